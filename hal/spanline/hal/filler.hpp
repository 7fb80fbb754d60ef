#pragma once
/// @file
/// Hardware that clears bands.
///
/// ```cpp
/// // What a board with a DMA has; this one lets the core do it.
/// struct CoreFiller {
///   void fill(std::uint16_t value, std::uint32_t count, std::uint16_t* words) {
///     while (count-- != 0) *words++ = value;
///   }
///   bool filled() { return true; }
/// };
/// static_assert(hal::Filler<CoreFiller>);
/// ```
#include <concepts>
#include <cstdint>

namespace spanline::hal {

/// Hardware, such as DMA, that fills memory with a value while the core continues.
///
/// - `fill(value, count, words)`: starts to fill `count` words of 16 bits, which begin at a multiple of 8 bytes. Two
///   fills may be under way; the next call waits.
/// - `filled()`: waits until all have ended; false if one does not.
template <typename F>
concept Filler = requires(F& filler, std::uint16_t value, std::uint16_t* words) {
  filler.fill(value, std::uint32_t{1}, words);
  { filler.filled() } -> std::same_as<bool>;
};

/// For boards without such hardware: programs that ask for a Filler let the core clear bands.
struct NoFiller {};

}  // namespace spanline::hal
