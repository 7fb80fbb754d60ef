#pragma once
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "spanline/raster/screen_vertex.hpp"

/// The narrow waist between visibility and shading.
///
/// Visibility finds the runs of pixels that a polygon owns, or may own, on a line; it never sees a colour. Shading
/// gives the pixels of such a run as a source that stands at one column and steps to either side; it never sees an
/// edge. Z-buffers fuse the two by templates, since they ask for a pixel only where its depth wins; algorithms that
/// know whole spans take them from left to right.
namespace spanline {

/// What a shader gives for a run: the pixel at the current column, and steps. `constant` says that all pixels are
/// alike.
template <class S>
concept PixelSource = requires(S source, const S& view) {
  { S::constant } -> std::convertible_to<bool>;
  view.get();
  source.forward();
  source.back();
};

/// Numbers of polygons and vertices inside a frame: 16 bits on microcontrollers (65,534 polygons), 32 bits where
/// pointers have 64.
using Link = std::conditional_t<(sizeof(void*) > 4), std::uint32_t, std::uint16_t>;
inline constexpr Link no_link = std::numeric_limits<Link>::max();
/// A polygon as found in the table.
struct PolygonCorners {
  const ScreenVertex* corner[3];
  Link triangle;  ///< triangle number within the group
  Link polygon;   ///< polygon number within the mesh
};

}  // namespace spanline
