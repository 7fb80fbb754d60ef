#pragma once
#include <span>
#include <spanline/frame/ready_made_traits.hpp>
#include <spanline/model/cull.hpp>
#include <vector>

#include "support/studio.hpp"

namespace spanline::test {

/// One pixel of a polygon, as the lectures print them.
struct Fragment {
  int column, row;
  std::int32_t depth;  ///< as the vertices carry it: smaller is nearer
  std::uint16_t colour;
};

/// A triangle that covers the centre of one pixel and of no other.
[[nodiscard]] inline Corners one_pixel(const Fragment& f) {
  const int x = f.column * 16, y = f.row * 16;
  return {Corner{x + 4, y + 4, f.depth}, Corner{x + 15, y + 4, f.depth}, Corner{x + 4, y + 15, f.depth}};
}

/// Draws fragments in their order.
template <class Depth>
[[nodiscard]] Picture<FlatTraits<Rgb565, Depth>> draw_fragments(int width, int height,
                                                                std::span<const Fragment> fragments) {
  std::vector<Corners> triangles;
  std::vector<std::uint16_t> colours;
  for (const Fragment& f : fragments) {
    triangles.push_back(one_pixel(f));
    colours.push_back(f.colour);
  }
  Studio<FlatTraits<Rgb565, Depth>> studio(screen_capacity(width, height, fragments.size()));
  const auto vertices = vertices_of(triangles, Depth::bits, width, height);
  FrameSettings settings;
  settings.cull = Cull::none;
  studio.begin(settings);
  studio.add_screen(vertices, colours);
  return studio.draw();
}

}  // namespace spanline::test
