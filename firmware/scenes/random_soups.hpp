#pragma once
#include <array>
#include <cstdint>

#include "scenes/random.hpp"
#include "scenes/screen_soups.hpp"
#include "spanline/raster/screen_vertex.hpp"

namespace spanline::scenes {

/// What random triangles on screen look like. Corners fall on any sixteenth of a pixel.
enum class SoupShape : std::uint8_t {
  tiny,      ///< within 6 × 6 pixels, some without any pixel centre
  large,     ///< corners up to half a picture outside it
  sliver,    ///< two corners anywhere, the third within a pixel of the line between them
  guard,     ///< one corner in the picture, the others anywhere in the guard band
  crossing,  ///< corners anywhere in the picture: each cuts through most others
  tied,      ///< the same, all at one depth: the first that was submitted wins
};

namespace soup_detail {

struct Corner {
  std::int32_t x, y;    ///< sixteenths of a pixel
  std::uint32_t depth;  ///< in 32 bits, away from both ends
};

/// Draws triangles of a shape for a picture of a size.
struct Maker {
  Random random;
  std::int32_t width, height;  ///< sixteenths of a pixel

  constexpr std::int32_t between(std::int32_t low, std::int32_t high) {
    return low + static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(high - low + 1)));
  }
  constexpr std::uint32_t depth() { return 0x01000000 + random.below(0xfe000000); }
  constexpr Corner anywhere(std::int32_t margin_x, std::int32_t margin_y) {
    const std::int32_t x = between(-margin_x, width + margin_x), y = between(-margin_y, height + margin_y);
    return {x, y, depth()};
  }

  constexpr std::array<Corner, 3> triangle(SoupShape shape) {
    constexpr std::int32_t guard = ScreenVertex::guard_pixels * 16, six_pixels = 96;
    std::array<Corner, 3> corners{};
    switch (shape) {
      case SoupShape::tiny: {
        const Corner at = anywhere(0, 0);
        for (Corner& c : corners) {
          c.x = at.x + between(0, six_pixels);
          c.y = at.y + between(0, six_pixels);
          c.depth = depth();
        }
        break;
      }
      case SoupShape::sliver: {
        const Corner a = anywhere(0, 0), b = anywhere(0, 0);
        const std::int32_t part = between(0, 256), x = a.x + (b.x - a.x) * part / 256 + between(-16, 16),
                           y = a.y + (b.y - a.y) * part / 256 + between(-16, 16);
        corners = {a, b, Corner{x, y, depth()}};
        break;
      }
      case SoupShape::large:
        for (Corner& c : corners) c = anywhere(width / 2, height / 2);
        break;
      case SoupShape::guard:
        for (Corner& c : corners) {
          c.x = between(-guard, guard);
          c.y = between(-guard, guard);
          c.depth = depth();
        }
        corners[0] = anywhere(0, 0);
        break;
      case SoupShape::crossing:
        for (Corner& c : corners) c = anywhere(0, 0);
        break;
      case SoupShape::tied:
        for (Corner& c : corners) {
          c = anywhere(0, 0);
          c.depth = 0x40000000;
        }
        break;
    }
    return corners;
  }

  [[nodiscard]] constexpr ScreenVertex vertex(const Corner& c, int depth_bits) const {
    unsigned code = 0;
    if (c.x < 0) code |= outcode_left;
    if (c.x > width) code |= outcode_right;
    if (c.y < 0) code |= outcode_top;
    if (c.y > height) code |= outcode_bottom;
    return ScreenVertex::make(c.x, c.y, c.depth >> (32 - depth_bits), depth_bits, static_cast<std::uint8_t>(code));
  }
};

}  // namespace soup_detail

/// Fills `soup` with random triangles for a picture of `width` × `height` pixels, each up to 1023. Corners have
/// outcodes where they leave the picture. 16-bit depths are the top bits of the 24-bit ones.
inline void make_random_triangles(SoupShape shape, int width, int height, int depth_bits, ScreenSoup soup) {
  soup_detail::Maker maker{Random(0x9e3779b9u + static_cast<std::uint32_t>(shape)), width * 16, height * 16};
  for (std::size_t i = 0; i < soup.colours.size(); ++i) {
    const auto corners = maker.triangle(shape);
    for (std::size_t k = 0; k < 3; ++k) soup.vertices[3 * i + k] = maker.vertex(corners[k], depth_bits);
    soup.colours[i] = static_cast<std::uint16_t>(maker.random() >> 8);
  }
}

}  // namespace spanline::scenes
