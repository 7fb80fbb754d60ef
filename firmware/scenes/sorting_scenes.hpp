#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "scenes/random.hpp"
#include "scenes/screen_soups.hpp"
#include "spanline/frame/frame_settings.hpp"
#include "spanline/math/integer.hpp"
#include "spanline/model/mesh.hpp"

// What algorithms that sort polygons find easy, as models and landscapes are, and what they find hard: polygons that
// penetrate one another, which no order draws right.
namespace spanline::scenes {

using namespace spanline::literals;

/// Benchmark scenes P100 and P500: `count` flat right triangles with legs of `leg` pixels at random places. Every
/// corner has a random depth of its own, so that nearly all that overlap on screen penetrate.
inline void make_penetrating_triangles(std::uint32_t leg, std::uint32_t count, int depth_bits, ScreenSoup soup) {
  Random random;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t x0 = random.below(321 - leg), y0 = random.below(241 - leg), orientation = random() & 3;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const RightCorner corner(orientation, k);
      soup.vertices[3 * i + k] =
          soup_vertex(static_cast<std::int32_t>(x0 + (corner.right ? leg : 0)),
                      static_cast<std::int32_t>(y0 + (corner.below ? leg : 0)), 4096 + random.below(57344), depth_bits);
    }
    soup.colours[i] = static_cast<std::uint16_t>(random() >> 8);
  }
}

/// Benchmark scene LAND: jagged ground whose peaks hide what lies behind them.
namespace landscape {

inline constexpr std::uint32_t columns = 48, rows = 25, triangles = 2 * columns * rows;

/// A point of the ground: rows come nearer from the horizon to the bottom of the picture, and each point is raised by
/// up to 19 pixels.
inline ScreenVertex point(std::uint32_t column, std::uint32_t row, int depth_bits) {
  constexpr std::uint32_t horizon = 40, farthest = 60000, row_depth = 2000;
  Random random(column * 7919 + row * 104729 + 12345);
  random();  // the first numbers of neighbouring seeds are alike
  random();
  const std::uint32_t height = random.below(20), roughness = random.below(300);
  return soup_vertex(static_cast<std::int32_t>(column * 320 / columns),
                     static_cast<std::int32_t>(horizon + row * 200 / rows - height),
                     farthest - row * row_depth - roughness, depth_bits);
}

/// Puts its triangles into `soup`, the farthest row first.
inline void make(int depth_bits, ScreenSoup soup) {
  std::size_t triangle = 0;
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      const ScreenVertex top_left = point(column, row, depth_bits), top_right = point(column + 1, row, depth_bits),
                         bottom_right = point(column + 1, row + 1, depth_bits),
                         bottom_left = point(column, row + 1, depth_bits);
      const std::array corners{top_left, top_right, bottom_right, top_left, bottom_right, bottom_left};
      for (std::size_t k = 0; k < corners.size(); ++k) soup.vertices[3 * triangle + k] = corners[k];
      soup.colours[triangle] = static_cast<std::uint16_t>(triangle * 40503);
      soup.colours[triangle + 1] = static_cast<std::uint16_t>(triangle * 40503 + 777);
      triangle += 2;
    }
  }
}

}  // namespace landscape

/// Benchmark scene BALL: the half of a ball that faces the eye, 200 pixels across in the middle of 320 × 240. Its
/// triangles share their vertices, as those of models do. Made by the compiler from integers alone.
namespace ball {

inline constexpr std::size_t cells = 28, row = cells + 1;
inline constexpr std::int32_t radius = 4096;  ///< steps of the mesh

/// A grid of vertices, from pole to pole along x. At either pole a column of vertices falls together, and half of the
/// triangles beside it vanish.
struct Tables {
  std::array<Vertex16, row * row> vertices{};
  std::array<std::uint16_t, 6 * cells * cells> indices{};
  std::array<Rgb888, 2 * cells * cells> colours{};
};

constexpr Tables make() {
  Tables tables;
  const auto root = [](std::int32_t square) {
    return square > 0 ? static_cast<std::int32_t>(square_root(static_cast<std::uint64_t>(square))) : 0;
  };
  constexpr auto half = static_cast<std::int32_t>(cells / 2);
  for (std::size_t column = 0; column < row; ++column) {
    const std::int32_t x = radius * (static_cast<std::int32_t>(column) - half) / half;
    const std::int32_t reach = root(radius * radius - x * x);
    for (std::size_t line = 0; line < row; ++line) {
      const std::int32_t y = reach * (static_cast<std::int32_t>(line) - half) / half;
      const std::int32_t z = root(radius * radius - x * x - y * y);
      tables.vertices[line * row + column] = {static_cast<std::int16_t>(x), static_cast<std::int16_t>(y),
                                              static_cast<std::int16_t>(z)};
    }
  }
  for (std::size_t i = 0; i < 2 * cells * cells; ++i) {
    const std::size_t corner = i / 2 / cells * row + i / 2 % cells;
    const std::array<std::size_t, 3> triangle = i % 2 == 0 ? std::array{corner, corner + 1, corner + row + 1}
                                                           : std::array{corner, corner + row + 1, corner + row};
    for (std::size_t k = 0; k < 3; ++k) tables.indices[3 * i + k] = static_cast<std::uint16_t>(triangle[k]);
    const std::size_t mixed = i * 40503;
    tables.colours[i] = {static_cast<std::uint8_t>(mixed >> 8), static_cast<std::uint8_t>(mixed >> 3),
                         static_cast<std::uint8_t>(mixed << 3)};
  }
  return tables;
}

inline constexpr Tables tables = make();

inline constexpr Mesh mesh = [] {
  Mesh half_ball;
  half_ball.vertices = tables.vertices;
  half_ball.indices = tables.indices;
  half_ball.polygon_colours = tables.colours;
  half_ball.step_exponent = -12;
  half_ball.bounds = {{}, radius};
  return half_ball;
}();

/// Seen from 16 radii away, nearly in parallel. The depth range is one that the fast transform of vertices takes.
inline FrameSettings settings() {
  FrameSettings view;
  view.camera.eye = {{}, {}, 16.0_q16};
  view.camera.focal = 1600.0_q16;
  view.camera.near_plane = 14.0_q16;
  view.camera.far_plane = 20.0_q16;
  return view;
}

}  // namespace ball

}  // namespace spanline::scenes
