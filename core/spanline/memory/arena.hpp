#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>

namespace spanline {

/// Cuts typed pools off a range of bytes, in order. An arena without memory only counts, so the same sequence of `take`
/// calls also tells how many bytes the pools need.
class Arena {
 public:
  static constexpr std::size_t alignment = 8;

  constexpr Arena() = default;
  explicit Arena(std::span<std::byte> memory) : memory_(memory) {}
  /// An arena over the part of `memory` that begins at a multiple of the alignment.
  [[nodiscard]] static Arena aligned(std::span<std::byte> memory) {
    const std::size_t misaligned = reinterpret_cast<std::uintptr_t>(memory.data()) % alignment;
    return Arena(memory.subspan(misaligned == 0 ? 0 : std::min(alignment - misaligned, memory.size())));
  }

  /// Returns `count` objects of T, or an empty span if the memory is used up. size() grows in both cases.
  template <class T>
  constexpr std::span<T> take(std::size_t count) {
    static_assert(alignof(T) <= alignment);
    const std::size_t start = used_;
    used_ += (count * sizeof(T) + alignment - 1) / alignment * alignment;
    if (memory_.data() == nullptr || used_ > memory_.size()) return {};
    T* first = reinterpret_cast<T*>(memory_.data() + start);
    for (std::size_t i = 0; i < count; ++i) new (static_cast<void*>(first + i)) T;
    return {first, count};
  }

  /// Bytes of all pools taken so far, including those that did not fit.
  [[nodiscard]] constexpr std::size_t size() const { return used_; }
  /// Whether the pools need more bytes than the memory has.
  [[nodiscard]] constexpr bool overrun() const { return used_ > memory_.size(); }

 private:
  std::span<std::byte> memory_{};
  std::size_t used_ = 0;  ///< bytes taken so far, a multiple of the alignment; may exceed the memory's size
};

}  // namespace spanline
