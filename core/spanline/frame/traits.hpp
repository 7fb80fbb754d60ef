#pragma once
#include "spanline/model/material.hpp"
#include "spanline/raster/depth_format.hpp"
#include "spanline/shade/flat.hpp"
#include "spanline/shade/gouraud.hpp"
#include "spanline/shade/pixel_format.hpp"
#include "spanline/shade/polygon_id.hpp"
#include "spanline/shade/shader_list.hpp"
#include "spanline/visibility/depth_buffer.hpp"
#include "spanline/visibility/span/spanning_scan_line.hpp"

namespace spanline {

/// What a renderer is made of, chosen when the program is compiled. A program links what its traits name and nothing
/// else.
template <class DepthFormatT, class PixelFormat, class ShaderListT, bool Statistics = false,
          class VisibilityT = ZBuffer>
struct RendererTraits {
  using Depth = DepthFormatT;      ///< Depth16<…> or Depth24<…>
  using Format = PixelFormat;      ///< Rgb565, Rgb565Swapped or PolygonIds
  using Shaders = ShaderListT;     ///< ShaderList<…>
  using Visibility = VisibilityT;  ///< ZBuffer or Spanning
  static constexpr bool statistics =
      Statistics;  ///< count spans, pixels and depth tests, and tell the sink of covered polygons
};

/// Flat shading, 16-bit depth: the smallest renderer.
template <class Format = Rgb565, class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using FlatTraits = RendererTraits<Depth, Format, ShaderList<FlatShader<Format>>, Statistics, Visibility>;

/// Flat and Gouraud shading, with vertex colours.
template <class Format = Rgb565, class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using FullTraits =
    RendererTraits<Depth, Format, ShaderList<FlatShader<Format>, GouraudShader<Format>, GouraudColourShader<Format>>,
                   Statistics, Visibility>;

/// Draws polygon numbers instead of colours.
template <class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using IdTraits = RendererTraits<Depth, PolygonIds, ShaderList<IdShader>, Statistics, Visibility>;

/// The place in the list of the shader that serves a material; the list's `count` if there is none.
template <class Traits>
[[nodiscard]] constexpr std::uint8_t shader_for(ShadingMode mode, bool vertex_colours) {
  using Shaders = typename Traits::Shaders;
  using Format = typename Traits::Format;
  if constexpr (Shaders::template index_of<IdShader> < Shaders::count) {
    return Shaders::template index_of<IdShader>;
  } else {
    if (mode == ShadingMode::flat) return Shaders::template index_of<FlatShader<Format>>;
    if (vertex_colours) return Shaders::template index_of<GouraudColourShader<Format>>;
    return Shaders::template index_of<GouraudShader<Format>>;
  }
}

}  // namespace spanline
