#pragma once
#include <cstdint>
#include <span>

#include "spanline/raster/link.hpp"
#include "spanline/raster/screen_vertex.hpp"
#include "spanline/raster/texture_vertex.hpp"

namespace spanline {

/// The vertices of an instance, with their shades and texture coordinates, followed by room for those that clipping
/// makes.
struct VertexStore {
  std::span<ScreenVertex> vertices;   ///< the instance's own vertices first, then those made by clipping
  std::span<std::uint32_t> shades;    ///< parallel to `vertices`, or empty
  std::span<TextureVertex> textures;  ///< parallel to `vertices`, or empty
  std::span<std::int32_t> thirds;     ///< third texture coordinates, parallel to `textures`, or empty
  Link count = 0;                     ///< number of vertices in use
  std::uint32_t wanted_vertices = 0;  ///< number of vertices that found no room
};

}  // namespace spanline
