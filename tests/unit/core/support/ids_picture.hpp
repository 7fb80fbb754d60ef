#pragma once
#include <spanline/frame/ready_made_traits.hpp>
#include "support/studio.hpp"

namespace spanline::test {

using Ids = IdTraits<Depth16<>, Counted>;

/// Room for some instances of a mesh, with much to spare for clipping.
[[nodiscard]] inline Capacity mesh_capacity(int width, int height, std::size_t instances, std::size_t vertices,
                                            std::size_t triangles) {
  Capacity c;
  c.width = static_cast<std::uint16_t>(width);
  c.height = static_cast<std::uint16_t>(height);
  c.band_lines = c.height;
  c.colour_bands = 1;
  c.instances = static_cast<std::uint32_t>(instances);
  c.vertices = c.shades = c.textures = static_cast<std::uint32_t>(vertices + 9 * triangles);
  c.polygons = c.fans = static_cast<std::uint32_t>(7 * triangles);
  return c;
}

}  // namespace spanline::test
