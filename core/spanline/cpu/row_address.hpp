#pragma once
#include <cstdint>
#include <type_traits>

namespace spanline {

/// The addresses of a band's row in both buffers. If depths and pixels have the same size, one address and a constant
/// distance serve for both, which saves a register in the loops.
template <class Word, class Pixel>
class RowAddress {
 public:
  RowAddress(Word* depth, Pixel* pixels, std::int32_t offset) : depth_(depth + offset) {
    if constexpr (paired)
      other_ = reinterpret_cast<std::uintptr_t>(pixels) - reinterpret_cast<std::uintptr_t>(depth);
    else
      other_ = pixels + offset;
  }
  void next_row(std::int32_t width) {
    depth_ += width;
    if constexpr (!paired) other_ += width;
  }
  [[nodiscard]] Word* depth(std::uint32_t column) const { return depth_ + column; }
  /// The pixel that belongs to `depth`, which must be depth(column).
  [[nodiscard]] Pixel* pixels([[maybe_unused]] Word* depth, [[maybe_unused]] std::uint32_t column) const {
    if constexpr (paired)
      return reinterpret_cast<Pixel*>(reinterpret_cast<std::uintptr_t>(depth) + other_);
    else
      return other_ + column;
  }

 private:
  static constexpr bool paired = sizeof(Word) == sizeof(Pixel);
  Word* depth_;
  std::conditional_t<paired, std::uintptr_t, Pixel*> other_;
};

}  // namespace spanline
