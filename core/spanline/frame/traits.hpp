#pragma once
#include "spanline/visibility/span/spanning_scan_line.hpp"
#include "spanline/visibility/zbuffer/depth_buffer.hpp"

namespace spanline {

/// What a renderer is made of, chosen when the program is compiled. A program links what its traits name and nothing
/// else.
template <class DepthFormatT, class PixelFormat, class ShaderListT, bool Statistics = false,
          class VisibilityT = ZBuffer>
struct RendererTraits {
  using Depth = DepthFormatT;      ///< Depth16<…> or Depth24<…>
  using Format = PixelFormat;      ///< Rgb565, Rgb565Swapped or PolygonIds
  using Shaders = ShaderListT;     ///< ShaderList<…>
  using Visibility = VisibilityT;  ///< ZBuffer, BoundedZBuffer, Deferred<…> or Spanning
  static constexpr bool statistics =
      Statistics;  ///< count spans, pixels and depth tests, and tell the sink of covered polygons
};

}  // namespace spanline
