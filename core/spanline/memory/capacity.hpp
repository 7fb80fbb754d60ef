#pragma once
/// @file
/// The sizes of a renderer's pools, from which follows how much memory it needs.
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

/// The sizes of a renderer's pools, in entries. The caller provides all memory; `Renderer::bytes_needed` computes how
/// many bytes a capacity takes.
struct Capacity {
  std::uint16_t width = 320;      ///< pixels, 1 … 2047
  std::uint16_t height = 240;     ///< pixels, 1 … 2047
  std::uint16_t band_lines = 16;  ///< lines drawn at a time, 1 … height; all of them make a full-frame z-buffer
  std::uint8_t colour_bands = 2;  ///< 1 … 16; with 2, one band is drawn while another is sent to the display
  std::uint8_t depth_bands = 1;   ///< 1 or 2; 2 if the sink clears a band's memory while the band above is drawn
  std::uint32_t instances = 1;    ///< instances in view
  std::uint32_t vertices = 0;     ///< vertices of all instances in view, and those that clipping adds
  std::uint32_t shades = 0;       ///< vertices of instances with Gouraud shading, and those that clipping adds
  std::uint32_t textures = 0;     ///< vertices of textured instances, and those that clipping adds
  std::uint32_t polygons = 0;     ///< triangles and whole planar polygons in view that are not culled
  /// Records: one for each of these triangles that is a piece of a clipped triangle or of a larger polygon, 2 for each
  /// polygon drawn whole with up to five corners, 3 with up to eight. Where a renderer counts or draws ids, one that is
  /// clipped takes up to 9. So an unclipped polygon never takes more than its fan would.
  std::uint32_t fans = 0;
  std::uint32_t active = 0;  ///< z-buffers: polygons that reach across a band's lower edge; 0 for a single band
  std::uint32_t awake = 0;   ///< `span`: polygons that are awake on the same row; on 32-bit cores the limit is 287 to
                             ///< 744, which depends on the list of shaders (docs/visibility.md; Renderer::takes)
  std::uint32_t fragments = 0;  ///< z-buffers with see-through shaders: blended fragments of one band
  std::uint32_t layers = 0;   ///< `span` with see-through shaders: see-through polygons that are awake on the same row;
                              ///< `depth-sort` with such shaders: see-through polygons in the same band
  std::uint32_t members = 0;  ///< `depth-sort`: opaque polygons in the same band

  /// The number of bands in a picture.
  [[nodiscard]] constexpr std::uint32_t bands() const {
    return band_lines == 0 ? 0 : (height + band_lines - 1u) / band_lines;
  }
  /// Whether the sizes and the numbers of bands lie in their ranges.
  [[nodiscard]] constexpr bool valid() const {
    return width >= 1 && width <= 2047 && height >= 1 && height <= 2047 && band_lines >= 1 && band_lines <= height &&
           colour_bands >= 1 && colour_bands <= 16 && (depth_bands == 1 || depth_bands == 2);
  }
};

}  // namespace spanline
