#pragma once
#include <cstdint>

#include "spanline/model/colour.hpp"

namespace spanline {

/// How a surface is lit. The renderer's type lists which of these it links (frame/renderer.hpp); asking for another is
/// a Status.
enum class ShadingMode : std::uint8_t {
  flat,     ///< one intensity a polygon, from its normal
  gouraud,  ///< intensity interpolated between the vertices; with vertex colours, the colour too
};

/// What a surface looks like. Colours of the mesh, where it has them, replace `colour`.
struct Material {
  Rgb888 colour{};
  ShadingMode shading = ShadingMode::flat;
};

}  // namespace spanline
