#pragma once
/// @file
/// How pixels lie in memory.
///
/// ```cpp
/// constexpr std::uint16_t red = 0xF800;
/// static_assert(hal::to_pixel_order(hal::PixelOrder::high_byte_first, red) == 0x00F8);
/// ```
#include <bit>
#include <cstdint>

namespace spanline::hal {

/// The byte order of an RGB565 pixel (red in bits 15..11, green in 10..5, blue in 4..0) in a 16-bit word of a band.
enum class PixelOrder : std::uint8_t {
  native,           ///< the word's value is the pixel
  high_byte_first,  ///< the byte with red comes first in memory, as it is sent to the panel
};

/// Converts an RGB565 value to a word in `order`; its own inverse.
[[nodiscard]] constexpr std::uint16_t to_pixel_order(PixelOrder order, std::uint16_t pixel) {
  if (order == PixelOrder::native || std::endian::native == std::endian::big) return pixel;
  return static_cast<std::uint16_t>((pixel << 8) | (pixel >> 8));
}

}  // namespace spanline::hal
