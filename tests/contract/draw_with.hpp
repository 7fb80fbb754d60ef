#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "drawing.hpp"
#include "layers.hpp"
#include "support/two_cores.hpp"

namespace spanline::contract {

inline Capacity capacity_of(const Scene& scene, const Manner& manner) {
  Capacity c;
  c.width = static_cast<std::uint16_t>(scene.width);
  c.height = static_cast<std::uint16_t>(scene.height);
  c.band_lines =
      static_cast<std::uint16_t>(manner.band_lines == 0 ? scene.height : std::min(manner.band_lines, scene.height));
  c.colour_bands = 1;
  c.instances = static_cast<std::uint32_t>(scene.parts.size() + scene.triangles.size() + 1);
  for (const Part& part : scene.parts) {
    c.vertices += static_cast<std::uint32_t>(part.mesh->vertex_count() + 9 * part.mesh->triangle_count());
    c.fans += static_cast<std::uint32_t>(7 * part.mesh->triangle_count());
  }
  c.shades = c.textures = c.vertices;
  c.polygons = static_cast<std::uint32_t>(scene.polygon_count());
  constexpr std::uint32_t most_active = 4096;  // more than any of the scenes has on a row
  c.active = c.awake = c.members = manner.active.value_or(std::min(c.polygons, most_active));
  return c;
}

/// The triangles given on screen, in batches of their own materials where layers are wanted.
template <class Traits>
void add_triangles(test::Studio<Traits>& studio, std::span<const ScreenVertex> vertices,
                   std::span<const std::uint16_t> colours) {
  if constexpr (Traits::Shaders::see_through) {
    for (std::size_t first = 0; first < colours.size(); first += batch_length)
      studio.add_screen(vertices.subspan(3 * first, std::min(3 * batch_length, vertices.size() - 3 * first)),
                        colours.subspan(first), material_of(first / batch_length));
  } else if (!vertices.empty()) {
    studio.add_screen(vertices, colours);
  }
}

/// Any colours, of which neighbours have different ones.
inline std::vector<std::uint16_t> colours_of(const Scene& scene) {
  std::vector<std::uint16_t> colours(scene.triangles.size());
  for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = static_cast<std::uint16_t>(i * 40503u + 1u);
  return colours;
}

template <class Traits>
Drawing draw_once(const Scene& scene, const Manner& manner, std::uint32_t layers) {
  using Depth = typename Traits::Depth;
  Capacity capacity = capacity_of(scene, manner);
  capacity.fragments = capacity.layers = layers;
  test::Studio<Traits> studio(capacity);
  std::vector<ScreenVertex> vertices = test::vertices_of(scene.triangles, 24, scene.width, scene.height);
  if constexpr (Depth::bits == 16)
    for (ScreenVertex& v : vertices)
      v.depth_word = std::min(v.depth_word >> 16, std::uint32_t{Depth::farthest}) << 16 | v.outcode();
  const std::vector<std::uint16_t> colours = colours_of(scene);
  studio.begin(scene.settings);
  add_triangles(studio, std::span<const ScreenVertex>(vertices), std::span<const std::uint16_t>(colours));
  for (const Part& part : scene.parts) {
    Material material = part.material;
    if (manner.content == Manner::Content::layers) {
      const Material layer = material_of(static_cast<std::size_t>(&part - scene.parts.data()));
      material.opacity = layer.opacity;
      material.transparency = layer.transparency;
      material.shading = ShadingMode::flat;
    }
    studio.add(*part.mesh, part.transform, material);
  }
  const auto picture = manner.two_cores ? draw_on_two_cores(studio) : studio.draw();
  Drawing drawing;
  drawing.width = scene.width;
  drawing.height = scene.height;
  drawing.pixels.assign(picture.pixels.begin(), picture.pixels.end());
  if constexpr (Traits::statistics) drawing.depths.assign(picture.depth.begin(), picture.depth.end());
  drawing.counters = studio.statistics().visibility;
  drawing.status = studio.status();
  const std::span<const std::string_view> names(BandDrawer<Traits>::Visibility::counter_names);
  drawing.shades_once = Traits::statistics && !manner.two_cores && std::ranges::find(names, "shaded") != names.end();
  return drawing;
}

/// Draws a scene by a renderer of those traits.
template <class Traits>
Drawing draw_with(const Scene& scene, const Manner& manner) {
  Drawing drawing = draw_once<Traits>(scene, manner, manner.layers.value_or(1000));
  // Twice at most: of two cores, each knows its own bands.
  for (int again = 0; again < 2 && !manner.layers && is_of_layers(drawing.status.pool); ++again)
    drawing = draw_once<Traits>(scene, manner, drawing.status.wanted);
  return drawing;
}

/// How an algorithm draws in a manner: some work on the whole picture at once.
inline Manner manner_for(const AlgorithmEntry& algorithm, Manner manner) {
  if (algorithm.full_frame()) manner.band_lines = 0;
  return manner;
}
/// How the reference draws.
inline Manner manner_for_reference(Manner manner) {
  manner.band_lines = 0;
  manner.active.reset();
  return manner;
}

}  // namespace spanline::contract
