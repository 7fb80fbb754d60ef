#pragma once
/// @file
/// What a renderer takes of memory.
///
/// ```cpp
/// #include <spanline/frame/ready_made_traits.hpp>
/// #include <spanline/frame/renderer.hpp>
///
/// // A cube: 8 vertices, 6 faces of two triangles each, of which 3 face the eye.
/// constexpr Capacity size{.width = 160, .height = 128, .vertices = 8, .polygons = 6, .fans = 6, .active = 6};
/// static_assert(Renderer<FlatTraits<>>::bytes_needed(size) < 20 * 1024);
/// ```
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
  std::uint32_t active = 0;  ///< z-buffers: polygons that reach across a band's lower edge; none with a single band
  std::uint32_t awake = 0;   ///< `span`: polygons awake on a row
  std::uint32_t fragments = 0;  ///< z-buffers with see-through shaders: fragments of a band whose colours mix with
                                ///< those behind
  std::uint32_t layers = 0;     ///< `span` with see-through shaders: see-through polygons awake on a row

  /// How many bands a picture has.
  [[nodiscard]] constexpr std::uint32_t bands() const {
    return band_lines == 0 ? 0 : (height + band_lines - 1u) / band_lines;
  }
  /// Whether sizes and numbers of bands are in their ranges.
  [[nodiscard]] constexpr bool valid() const {
    return width >= 1 && width <= 2047 && height >= 1 && height <= 2047 && band_lines >= 1 && band_lines <= height &&
           colour_bands >= 1 && colour_bands <= 16 && (depth_bands == 1 || depth_bands == 2);
  }
};

}  // namespace spanline
