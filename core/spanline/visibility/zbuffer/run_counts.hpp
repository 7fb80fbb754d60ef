#pragma once
#include <cstdint>

namespace spanline {

/// A pixel source that counts the pixels taken from it.
template <class Source>
struct CountedSource : Source {
  static constexpr bool constant = false;
  std::uint64_t* written;
  [[nodiscard]] auto get() const {
    ++*written;
    return Source::get();
  }
};

/// Counts runs, the depth tests in them and the pixels written. Without Counting it does nothing.
template <bool Counting>
struct RunCounts {
  static constexpr bool counting = Counting;
  template <class Target>
  static void run(const Target& target, std::uint32_t pixels) {
    if constexpr (Counting) {
      ++target.counters->spans;
      target.counters->depth_tests += pixels;
    }
  }
  template <class Source, class Target>
  static auto source(const Source& source, const Target& target) {
    if constexpr (Counting)
      return CountedSource<Source>{source, &target.counters->pixels};
    else
      return source;
  }
};

}  // namespace spanline
