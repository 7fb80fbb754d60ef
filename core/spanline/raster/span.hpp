#pragma once
#include <concepts>
#include <cstdint>

/// The interface between visibility and shading.
///
/// Visibility finds the runs of pixels on a line where a polygon is, or may be, visible; it does not know colours.
/// Shading gives the pixels of such a run as a source, which is at one column and steps to the left or right; it does
/// not know edges. Z-buffers combine the two by templates, since they need a pixel only where it passes the depth test.
/// Algorithms that know whole spans read them from left to right.
namespace spanline {

/// The pixels of a run, as a shader gives them: `get` returns the pixel at the current column, `forward` and `back`
/// step by one column. `constant` says that all pixels are equal.
template <class S>
concept PixelSource = requires(S source, const S& view) {
  { S::constant } -> std::convertible_to<bool>;
  view.get();
  source.forward();
  source.back();
};

/// A source whose surface has holes (cut-out textures): `present` tells whether the surface exists at the current
/// column.
template <class S>
concept SourceWithHoles = requires(const S& view) {
  { view.present() } -> std::convertible_to<bool>;
}
&&S::has_holes;

/// A shader of see-through polygons, whose surfaces come in blocks. A surface's `blends()` tells whether its colours
/// blend with those behind; otherwise the surface is opaque where it is present, and a depth test suffices. A source's
/// `layer()` returns the current pixel as a `Layer` of a few bytes, the same type for all shaders of a list;
/// `over(pixel)` of a layer blends it over a pixel.
template <class Shader>
concept SeeThrough = requires {
  requires Shader::see_through;
};

/// A surface whose pixels are entries of a table of 64, indexed by the top bits of one linear function. Loops in
/// assembly have a special case for it.
template <class S>
concept RampSurface = requires(const S& surface) {
  { surface.intensity.at_origin } -> std::convertible_to<std::uint32_t>;
  { surface.ramp[0] } -> std::convertible_to<std::uint32_t>;
  requires S::ramp_bits == 6;
};

}  // namespace spanline
