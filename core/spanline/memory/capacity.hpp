#pragma once
#include <cstddef>
#include <cstdint>

namespace spanline {

/// How large a renderer's pools are. All memory is the caller's; `Renderer::bytes_needed` says how much this makes.
struct Capacity {
  std::uint16_t width = 320;      ///< pixels, 1 … 2047
  std::uint16_t height = 240;     ///< pixels, 1 … 2047
  std::uint16_t band_lines = 16;  ///< lines drawn at a time, 1 … height; height itself is a full-frame z-buffer
  std::uint8_t colour_bands = 2;  ///< 1; 2 to draw one while another is on its way to the display; 16 at most
  std::uint8_t depth_bands = 1;   ///< 1; 2 where the sink clears a band's memory while the one above is drawn
  std::uint32_t instances = 1;    ///< meshes in view
  std::uint32_t vertices = 0;     ///< of all instances in view, and what clipping adds
  std::uint32_t shades = 0;       ///< vertices of instances with Gouraud shading, and what clipping adds
  std::uint32_t textures = 0;     ///< vertices of textured instances, and what clipping adds
  std::uint32_t polygons = 0;     ///< triangles that face the eye
  std::uint32_t fans = 0;    ///< of these, the pieces of clipped triangles and of polygons with more than three corners
  std::uint32_t active = 0;  ///< z-buffers: polygons that reach across a band's lower edge; none with a single band.
                             ///< Spanning: polygons awake on a row
  std::uint32_t layers = 0;  ///< renderers with see-through shaders. z-buffers: fragments of a band whose colours mix
                             ///< with those behind. Spanning: see-through polygons awake on a row

  [[nodiscard]] constexpr std::uint32_t bands() const {
    return band_lines == 0 ? 0 : (height + band_lines - 1u) / band_lines;
  }
  [[nodiscard]] constexpr bool valid() const {
    return width >= 1 && width <= 2047 && height >= 1 && height <= 2047 && band_lines >= 1 && band_lines <= height &&
           colour_bands >= 1 && colour_bands <= 16 && (depth_bands == 1 || depth_bands == 2);
  }
};

/// Bytes in use at most, pool by pool.
struct PoolPeaks {
  std::size_t instances = 0, vertices = 0, shades = 0, textures = 0, polygons = 0, fans = 0, active = 0, layers = 0,
              buckets = 0, colour_bands = 0, depth_band = 0;
  [[nodiscard]] constexpr std::size_t total() const {
    return instances + vertices + shades + textures + polygons + fans + active + layers + buckets + colour_bands +
           depth_band;
  }
};

}  // namespace spanline
