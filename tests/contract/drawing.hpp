#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <spanline/visibility/counters.hpp>
#include <spanline/visibility/registry.hpp>
#include <vector>

#include "scene.hpp"

namespace spanline::contract {

/// Every algorithm of the registry that can draw the scene: screen polygons are for those that take them.
[[nodiscard]] std::vector<AlgorithmEntry> algorithms_for(const Scene& scene);
/// The entry of that name; throws if there is none.
[[nodiscard]] const AlgorithmEntry& algorithm(const char* name);

/// How a scene is drawn.
struct Manner {
  enum class Content : std::uint8_t {
    ids,      ///< with statistics, so that every algorithm keeps depths
    colours,  ///< without: what programs ship
    layers,   ///< colours, and most polygons are see-through (layers.hpp)
  };
  Content content = Content::ids;
  DepthSense sense = DepthSense::smaller_is_nearer;
  int band_lines = 0;                        ///< 0: the whole picture at once
  bool two_cores = false;                    ///< by two threads, each every second band
  std::optional<std::uint32_t> active = {};  ///< room for active polygons; all of them if not said
  std::optional<std::uint32_t> layers = {};  ///< room for layers; as many as it takes if not said
};

/// A finished picture, whatever its formats.
struct Drawing {
  int width = 0, height = 0;
  std::vector<std::uint32_t> pixels;
  std::vector<std::uint32_t> depths;  ///< 24 bits and 8 guard bits, in the sense asked for; only with ids
  VisibilityCounters counters;        ///< only with ids
  Status status;
  bool shades_once = false;  ///< the algorithm has a counter `shaded`, which promises that every pixel is written once

  [[nodiscard]] std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

/// Draws at 24 bits. Algorithms that work on the whole picture at once take no notice of `band_lines`.
[[nodiscard]] Drawing draw(const AlgorithmEntry& algorithm, const Scene& scene, const Manner& manner);

/// What exact algorithms must draw: the z-buffer of the whole picture.
[[nodiscard]] Drawing reference(const Scene& scene, Manner manner = {});

/// The same at 16 bits, ids alone; depths of screen triangles lose their low byte.
[[nodiscard]] Drawing draw_16_bits(const AlgorithmEntry& algorithm, const Scene& scene);

/// Whether a pool holds what is seen through: fragments of z-buffers, or layers of `span`.
[[nodiscard]] inline bool is_of_layers(Pool pool) { return pool == Pool::fragments || pool == Pool::layers; }

}  // namespace spanline::contract
