#pragma once
#include <cstdint>
#include <span>

#include "spanline/raster/link.hpp"
#include "spanline/raster/screen_vertex.hpp"
#include "spanline/raster/texture_vertex.hpp"

namespace spanline {

/// Room for vertices, with their shades and textures, that clipping makes, behind those of the instance.
struct VertexStore {
  std::span<ScreenVertex> vertices;   ///< of the instance: its own come first
  std::span<std::uint32_t> shades;    ///< parallel to `vertices`, or empty
  std::span<TextureVertex> textures;  ///< parallel to `vertices`, or empty
  std::span<std::int32_t> thirds;     ///< third texture coordinates, parallel to `textures`, or empty
  Link count = 0;                     ///< in use
  std::uint32_t wanted_vertices = 0;  ///< that did not fit
};

}  // namespace spanline
