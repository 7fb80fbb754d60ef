#pragma once
#include <cstdint>

#include "board.hpp"
#include "scenes/random.hpp"

/// What the comparisons of kernels with their portable twins share.
namespace twins {

using spanline::scenes::Random;

/// Runs `compare(random)` so many times; true where both forms gave the same each time. Prints a line either way.
template <class Compare>
bool all_alike(const char* kernel, std::uint32_t rounds, Compare compare) {
  Random random;
  for (std::uint32_t round = 0; round < rounds; ++round) {
    if (compare(random)) continue;
    spanline::board::write("differs ");
    spanline::board::write(kernel);
    spanline::board::write(" in round ");
    spanline::board::write_unsigned(round);
    spanline::board::write("\n");
    return false;
  }
  spanline::board::write("twins ");
  spanline::board::write(kernel);
  spanline::board::write("\n");
  return true;
}

template <class Word>
bool same(const Word* a, const Word* b, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    if (a[i] != b[i]) return false;
  }
  return true;
}

/// A number in [low, high].
inline std::int32_t between(Random& random, std::int32_t low, std::int32_t high) {
  return low + static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(high - low) + 1));
}

/// Depths and pixels of one kernel and of its twin, which begin alike.
template <std::uint32_t Count>
struct Buffers {
  struct Pair {
    alignas(4) std::uint16_t depth[Count];
    alignas(4) std::uint16_t pixels[Count];
  };
  Pair fast, portable;

  /// `count` depths from the start on: cleared ones, a few that lack one bit of that, and ones that the plane word's
  /// depth meets, beats or loses to.
  void fill(Random& random, std::uint32_t count, std::uint32_t z) {
    const std::uint32_t cleared_of_4 = random.below(5);
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t near = (z >> 16) + random.below(3) - 1, word = random();
      const bool cleared = (word & 3) < cleared_of_4;
      const std::uint32_t almost_clear = 0xffff ^ ((word >> 20 & 31) == 0 ? 1u << (word >> 28) : 0);
      fast.depth[i] = static_cast<std::uint16_t>(cleared ? almost_clear : (word & 12) != 0 ? near : word >> 16);
      fast.pixels[i] = static_cast<std::uint16_t>(word >> 8);
      portable.depth[i] = fast.depth[i];
      portable.pixels[i] = fast.pixels[i];
    }
  }
  [[nodiscard]] bool alike(std::uint32_t count) const {
    return same(fast.depth, portable.depth, count) && same(fast.pixels, portable.pixels, count);
  }
};

/// A step of a plane word: none, small, or any.
inline std::uint32_t random_step(Random& random) {
  const std::uint32_t kind = random.below(4), step = random();
  return kind == 0 ? 0 : kind == 1 ? step : static_cast<std::uint32_t>(static_cast<std::int32_t>(step) >> 12);
}

}  // namespace twins
