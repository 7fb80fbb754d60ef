#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "scenes/textured_wall.hpp"
#include "spanline/frame/renderer.hpp"

namespace spanline::scenes {

using namespace spanline::literals;

/// Benchmark scene ROOM: a room with eleven boxes, seen from within. 72 textured quads, each marked as planar, in steps
/// of 2^-8 units; and the same as two triangles each.
struct RoomTables {
  static constexpr std::size_t boxes = 12, quads = 6 * boxes;
  std::array<Vertex16, 4 * quads> vertices{};
  std::array<TextureCoordinate, 4 * quads> coordinates{};
  std::array<std::uint16_t, 4 * quads> indices{};
  std::array<std::uint8_t, quads> corners{};
  std::array<std::uint16_t, 6 * quads> triangles{};
};

namespace room_detail {

/// A box from one corner to the other, in eighths of a unit.
struct Box {
  int low[3], high[3];
};
inline constexpr Box walls{{-48, 0, -48}, {48, 24, 48}};
inline constexpr Box boxes[]{
    {{-40, 0, -40}, {-28, 10, -30}}, {{-20, 0, -44}, {-12, 20, -36}}, {{4, 0, -40}, {20, 6, -28}},
    {{30, 0, -44}, {44, 16, -34}},   {{-44, 0, -12}, {-34, 8, 4}},    {{34, 0, -8}, {42, 24, 0}},
    {{-42, 0, 22}, {-30, 12, 34}},   {{-16, 0, 30}, {-4, 5, 42}},     {{12, 0, 26}, {18, 24, 32}},
    {{28, 0, 24}, {44, 9, 40}},      {{-26, 0, 8}, {-20, 14, 14}}};

/// Appends the faces of a box, counter-clockwise seen from outside, or from inside.
struct Builder {
  RoomTables tables{};
  std::size_t quads = 0;

  constexpr void face(const Box& box, int axis, bool high, bool inwards) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const std::size_t first = 4 * quads;
    for (std::size_t k = 0; k < 4; ++k) {
      // Seen against the axis, u to the right and v upwards, these go round counter-clockwise.
      const bool right = k == 1 || k == 2, up = k >= 2;
      int at[3]{};
      at[axis] = high ? box.high[axis] : box.low[axis];
      at[u] = right ? box.high[u] : box.low[u];
      at[v] = up ? box.high[v] : box.low[v];
      const auto step = [&](int i) { return static_cast<std::int16_t>(32 * at[i]); };
      tables.vertices[first + k] = {step(0), step(1), step(2)};
      tables.coordinates[first + k] = {static_cast<std::int16_t>(right ? 16384 : 0),
                                       static_cast<std::int16_t>(up ? 16384 : 0)};
    }
    const bool reversed = high == inwards;
    for (std::size_t k = 0; k < 4; ++k)
      tables.indices[first + k] = static_cast<std::uint16_t>(first + (reversed ? 3 - k : k));
    constexpr std::size_t fan[] = {0, 1, 2, 0, 2, 3};
    for (std::size_t k = 0; k < 6; ++k) tables.triangles[6 * quads + k] = tables.indices[first + fan[k]];
    tables.corners[quads++] = 4 | Mesh::planar;
  }
  constexpr void box(const Box& box, bool inwards) {
    for (const int axis : {0, 1, 2})
      for (const bool high : {false, true}) face(box, axis, high, inwards);
  }
};

}  // namespace room_detail

inline constexpr RoomTables room_tables = [] {
  room_detail::Builder builder;
  builder.box(room_detail::walls, true);
  for (const room_detail::Box& box : room_detail::boxes) builder.box(box, false);
  return builder.tables;
}();

inline constexpr Mesh room{.vertices = room_tables.vertices,
                           .indices = room_tables.indices,
                           .corners = room_tables.corners,
                           .texture_coordinates = room_tables.coordinates,
                           .step_exponent = -8,
                           .bounds = {{0, 384, 0}, 2210}};
inline constexpr Mesh room_of_triangles{.vertices = room_tables.vertices,
                                        .indices = room_tables.triangles,
                                        .texture_coordinates = room_tables.coordinates,
                                        .step_exponent = -8,
                                        .bounds = {{0, 384, 0}, 2210}};

/// The view of somebody who stands in the room and has turned by so much, for a picture of this height.
inline FrameSettings room_settings(Angle turned, std::int32_t height) {
  FrameSettings frame;
  Camera& camera = frame.camera;
  const Vec3<Q16_16> eye{0.25_q16, 1.5_q16, 0.5_q16};
  const auto fixed = [](Q2_30 value) { return Q16_16::from_raw(value.raw() >> 14); };
  camera.look_at(eye, {eye.x + fixed(sine(turned)), 1.25_q16, eye.z - fixed(cosine(turned))}, {{}, 1.0_q30, {}});
  camera.focal = Q16_16::from_ratio(std::int64_t{4} * height, 5);
  camera.near_plane = 0.125_q16;
  camera.far_plane = 24.0_q16;
  return frame;
}
inline constexpr Material room_material{
    .texturing = {.texture = &textured_wall::grained, .function = TextureFunction::replace}};

}  // namespace spanline::scenes
