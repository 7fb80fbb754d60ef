#pragma once
#include <concepts>
#include <cstdint>

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

/// A source whose surface has holes (cut-out textures): it tells whether there is anything at the current column.
template <class S>
concept SourceWithHoles = requires(const S& view) {
  { view.present() } -> std::convertible_to<bool>;
}
&&S::has_holes;

/// A shader of polygons that what lies behind may show through. Its surfaces come in blocks. `blends()` of a surface
/// tells whether its colours mix with those behind; otherwise it is opaque where it is present, and a depth test is all
/// that it takes. `layer()` of a source is the current pixel as a `Layer` of a few bytes, the same type for all shaders
/// of a list, whose `over(pixel)` lays it over a pixel.
template <class Shader>
concept SeeThrough = requires {
  requires Shader::see_through;
};

/// A surface whose pixels come from a table of 64 by the top bits of one linear function: loops in assembly know it.
template <class S>
concept RampSurface = requires(const S& surface) {
  { surface.intensity.at_origin } -> std::convertible_to<std::uint32_t>;
  { surface.ramp[0] } -> std::convertible_to<std::uint32_t>;
  requires S::ramp_bits == 6;
};

}  // namespace spanline
