#pragma once
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "scene.hpp"
#include "spanline/frame/frame_settings.hpp"
#include "spanline/memory/capacity.hpp"
#include "spanline/world/submission_order.hpp"

namespace spanline::fuzz {

/// Everything that a program hands to a renderer for a frame, as a fuzzer's bytes say: any bytes mean something. What a
/// header restricts without a check of its own is within its range; what is checked may be anything.
struct ApiFrame {
  Capacity capacity;                                ///< mostly valid, often too small
  std::uint16_t other_lines = 1;                    ///< the other band height that it is drawn with
  std::size_t bytes_missing = 0;                    ///< of the memory that the capacity takes
  unsigned misaligned = 0;                          ///< where the memory begins
  unsigned sink_fails_at = 0;                       ///< the band, counted from 1, at which the sink gives up; 0: never
  bool without_begin = false;                       ///< forgets to begin the frame
  std::uint16_t picked_column = 0, picked_row = 0;  ///< where pick() looks, not always inside the picture
  /// Also adds triangles on screen, more than can be numbered, which nobody may read: there is no table behind them.
  bool too_many_triangles = false;

  FrameSettings settings;
  std::vector<DirectionalLight> lights;
  std::vector<PointLight> point_lights;
  std::deque<contract::OwnedMesh> owned;
  std::deque<Mesh> meshes;  ///< views of `owned`; those alone that validate() takes
  std::deque<test::OwnTexture> textures;
  std::deque<contract::SurfaceTables> tables;
  std::vector<contract::Part> parts;
  bool in_order = false;          ///< the parts are added by `order`, not one by one
  std::vector<Submission> order;  ///< some of them name parts, or polygons, that do not exist

  std::vector<ScreenVertex> screen_vertices;  ///< of triangles or polygons given on screen
  std::vector<std::uint8_t> screen_corners;   ///< of each polygon, not always right; empty: they are triangles
  std::vector<std::uint16_t> screen_colours;
  Material screen_material;

  ApiFrame() = default;
  ApiFrame(const ApiFrame&) = delete;
  ApiFrame& operator=(const ApiFrame&) = delete;
  ApiFrame(ApiFrame&&) = default;
  ApiFrame& operator=(ApiFrame&&) = default;
  ~ApiFrame() = default;
};

[[nodiscard]] ApiFrame decode_frame(std::span<const std::uint8_t> bytes);

}  // namespace spanline::fuzz
