#pragma once
#include "image/height_image.hpp"
#include "scene/scene.hpp"

namespace spanline::sim {

/// Displacement mapping (lecture 004): geometry is subdivided and moved, when the asset is made.
struct DisplacementRequest {
  double amount = 0;  ///< how far the greatest height moves a point along its normal, in units of the model
  int levels = 0;     ///< each divides a triangle into four: [0, max_levels]
  static constexpr int max_levels = 8;
};

/// The scene with every triangle divided at the middles of its edges, `levels` times, and every point moved along its
/// smooth normal by the height at its texture coordinates; normals are made anew. Vertices at one point move together,
/// by the mean of their heights, so that no seam opens. Throws Failure where the scene has no texture coordinates, or
/// would have more than `most_displaced_triangles`.
[[nodiscard]] Scene displaced(const Scene& scene, const HeightImage& heights, const DisplacementRequest& request);

inline constexpr std::size_t most_displaced_triangles = std::size_t{1} << 22;

}  // namespace spanline::sim
