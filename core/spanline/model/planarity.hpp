#pragma once
/// @file
/// Whether a polygon may be marked as planar. The renderer draws a marked polygon as one entry, with one plane and one
/// surface, where its fan would be an entry for each triangle (docs/conventions.md).
///
/// ```cpp
/// constexpr Vertex16 corners[] = {{0, 0, 0}, {256, 0, 0}, {256, 256, 0}, {0, 256, 0}};
/// constexpr std::uint16_t indices[] = {0, 1, 2, 3};
/// constexpr std::uint8_t corner_counts[] = {4 | Mesh::planar};
/// const Mesh square{
///     .vertices = corners, .indices = indices, .corners = corner_counts, .step_exponent = -8, .bounds = {{}, 363}};
/// const bool may_be_marked = planarity_of(square, 0, 0) == Planarity::planar;
/// ```
#include <cstddef>
#include <cstdint>

#include "spanline/model/mesh.hpp"

namespace spanline {

/// What keeps a polygon from being marked as planar.
enum class Planarity : std::uint8_t {
  planar,    ///< nothing
  bent,      ///< its corners are not within half a unit of one plane
  unlinear,  ///< its texture coordinates, colours or opacities are no linear function over it
};

/// Whether polygon `polygon` of a mesh may be marked with Mesh::planar; `first_index` is that of its first corner in
/// `indices`. The mesh's other tables are valid. Lengths are measured in units: a unit is a step of the mesh, or the
/// least power of two of steps of which no corner lies more than 2^17 along an axis from the first one.
[[nodiscard]] Planarity planarity_of(const Mesh& mesh, std::size_t polygon, std::size_t first_index);

}  // namespace spanline
