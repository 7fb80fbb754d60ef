#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "scenes/random.hpp"
#include "spanline/raster/screen_vertex.hpp"

namespace spanline::scenes {

/// Triangles given on screen, corners three by three, and an RGB565 colour each.
struct ScreenSoup {
  std::span<ScreenVertex> vertices;
  std::span<std::uint16_t> colours;
};

/// A vertex at whole pixels of a 320 × 240 picture, with a 16-bit depth widened to `depth_bits`.
inline ScreenVertex soup_vertex(std::int32_t x, std::int32_t y, std::uint32_t z16, int depth_bits) {
  return ScreenVertex::make(x * 16, y * 16, z16 << (depth_bits - 16), depth_bits);
}

/// Where the k-th corner of a right triangle lies in the square that its legs span. The right angle is the square's
/// corner `orientation`, clockwise from top left.
struct RightCorner {
  constexpr RightCorner(std::uint32_t orientation, std::uint32_t k) {
    const std::uint32_t corner = (orientation + k + 3) & 3;
    right = corner == 1 || corner == 2;
    below = corner >= 2;
  }
  bool right, below;
};

/// Benchmark scenes S1, S2 and S3: `count` flat right triangles with legs of `leg` pixels at random places and depths.
inline void make_right_triangles(std::uint32_t leg, std::uint32_t count, int depth_bits, ScreenSoup soup) {
  Random random;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t x0 = random() % (321 - leg), y0 = random() % (241 - leg), orientation = random() & 3;
    const std::uint32_t base = 4096 + random() % 57344;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const RightCorner corner(orientation, k);
      const std::uint32_t x = x0 + (corner.right ? leg : 0), y = y0 + (corner.below ? leg : 0);
      soup.vertices[3 * i + k] =
          soup_vertex(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), base + random() % 2048, depth_bits);
    }
    soup.colours[i] = static_cast<std::uint16_t>((random() >> 8) & 0xffff);
  }
}

/// The triangles that cover a picture `complexity` times on average if they are thrown over it as by
/// `make_even_cover`.
[[nodiscard]] constexpr std::uint32_t even_cover_count(std::uint32_t complexity, std::uint32_t leg, std::uint32_t width,
                                                       std::uint32_t height) {
  return (2 * complexity * (width + leg) * (height + leg) + leg * leg - 1) / (leg * leg);
}

/// The longest leg with which so many triangles, thrown as by `make_even_cover`, cover a picture at most `complexity`
/// times on average.
[[nodiscard]] constexpr std::uint32_t even_cover_leg(std::uint32_t complexity, std::uint32_t triangles,
                                                     std::uint32_t width, std::uint32_t height) {
  std::uint32_t leg = 256;
  while (leg > 1 && even_cover_count(complexity, leg, width, height) < triangles) --leg;
  return leg;
}

/// Right triangles with legs of `leg` pixels at random depths, thrown evenly over a picture and its surroundings, so
/// that every pixel is covered equally often on average.
inline void make_even_cover(std::uint32_t leg, std::int32_t width, std::int32_t height, int depth_bits,
                            ScreenSoup soup) {
  Random random;
  const auto size = static_cast<std::int32_t>(leg);
  for (std::size_t i = 0; i < soup.colours.size(); ++i) {
    const std::int32_t x0 = static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(width + size))) - size,
                       y0 = static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(height + size))) - size;
    const std::uint32_t orientation = random() & 3, base = 4096 + random.below(57344);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const RightCorner corner(orientation, k);
      const std::int32_t x = x0 + (corner.right ? size : 0), y = y0 + (corner.below ? size : 0);
      ScreenVertex& vertex = soup.vertices[3 * i + k];
      vertex = soup_vertex(x, y, base + random.below(2048), depth_bits);
      const int code = (x < 0 ? outcode_left : 0) | (x > width ? outcode_right : 0) | (y < 0 ? outcode_top : 0) |
                       (y > height ? outcode_bottom : 0);
      vertex.depth_word |= static_cast<std::uint32_t>(code);
    }
    soup.colours[i] = static_cast<std::uint16_t>(random() >> 8);
  }
}

/// Benchmark scenes S7B and S7F: 20 quads over the whole picture, two triangles each, at depths 3000·(i + 1), farthest
/// or nearest first.
inline void make_full_screen_quads(bool back_to_front, int depth_bits, ScreenSoup soup) {
  constexpr std::uint32_t quads = 20;
  for (std::uint32_t i = 0; i < quads; ++i) {
    const std::uint32_t z = 3000 * (back_to_front ? quads - i : i + 1);
    const auto top_left = soup_vertex(0, 0, z, depth_bits), top_right = soup_vertex(320, 0, z, depth_bits);
    const auto bottom_left = soup_vertex(0, 240, z, depth_bits), bottom_right = soup_vertex(320, 240, z, depth_bits);
    const std::array<ScreenVertex, 6> corners{top_left, top_right, bottom_right, top_left, bottom_right, bottom_left};
    for (std::uint32_t k = 0; k < 6; ++k) soup.vertices[6 * i + k] = corners[k];
    soup.colours[2 * i] = soup.colours[2 * i + 1] = static_cast<std::uint16_t>((i + 1) * 0x0c31);
  }
}

/// Benchmark scenes R8 and R32: flat squares of `leg` pixels at random places, in planes at random depths. Corners go
/// four by four, clockwise from top left, and there is a colour for each square.
inline void make_squares(std::uint32_t leg, int depth_bits, ScreenSoup soup) {
  Random random;
  for (std::size_t i = 0; i < soup.colours.size(); ++i) {
    const std::uint32_t x0 = random() % (321 - leg), y0 = random() % (241 - leg);
    const std::uint32_t base = 4096 + random() % 57344, across = random() % 1024, down = random() % 1024;
    for (std::uint32_t k = 0; k < 4; ++k) {
      const bool right = k == 1 || k == 2, below = k >= 2;
      soup.vertices[4 * i + k] = soup_vertex(static_cast<std::int32_t>(x0 + (right ? leg : 0)),
                                             static_cast<std::int32_t>(y0 + (below ? leg : 0)),
                                             base + (right ? across : 0) + (below ? down : 0), depth_bits);
    }
    soup.colours[i] = static_cast<std::uint16_t>((random() >> 8) & 0xffff);
  }
}

/// The same squares as two triangles each. `triangles` has room for twice as many colours as `squares` has.
inline void cut_squares(ScreenSoup squares, ScreenSoup triangles) {
  for (std::size_t i = 0; i < squares.colours.size(); ++i) {
    constexpr std::array<std::uint8_t, 6> corners{0, 1, 2, 0, 2, 3};
    for (std::size_t k = 0; k < 6; ++k) triangles.vertices[6 * i + k] = squares.vertices[4 * i + corners[k]];
    triangles.colours[2 * i] = triangles.colours[2 * i + 1] = squares.colours[i];
  }
}

}  // namespace spanline::scenes
