#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "scenes/selftest_scenes.hpp"

namespace spanline::scenes {

/// The renderers that the self-test is drawn with. Each costs 15 to 35 KB of flash.
enum class SelftestRenderer : std::uint8_t {
  flat_16,            ///< flat shading alone, 16-bit depth
  flat_16_larger,     ///< the same, and larger depth is nearer
  gouraud_16,         ///< flat and Gouraud shading, 16-bit depth
  swapped_16,         ///< the same, and pixels have their high byte first
  gouraud_24,         ///< flat and Gouraud shading, 24-bit depth
  gouraud_24_larger,  ///< the same, and larger depth is nearer
  span_flat,          ///< spanning scan line, flat shading alone, 24 bits
  span_gouraud,       ///< spanning scan line, flat and Gouraud shading, 24 bits
  layers_16,          ///< flat and Gouraud shading, opaque and see-through, 16-bit depth
  layers_24,          ///< the same, 24-bit depth
  span_layers,        ///< the same by spanning scan line, 24 bits
  surfaces_24,        ///< the general shader, opaque and see-through, 24-bit depth
  span_surfaces,      ///< the same by spanning scan line
  textures_16,        ///< textures, plain, lit and in fog, 16-bit depth
  span_textures,      ///< the same by spanning scan line, 24 bits
  sort_flat,          ///< depth sort, flat shading alone, 24 bits
};

/// The renderer as lines of the self-test name it, in the column of the depth.
[[nodiscard]] constexpr const char* to_string(SelftestRenderer renderer) {
  constexpr const char* names[] = {"16-flat",     "16-flat-larger", "16",          "16-swapped",
                                   "24",          "24-larger",      "24-flat",     "24",
                                   "16-layers",   "24-layers",      "24-layers",   "24-surfaces",
                                   "24-surfaces", "16-textures",    "24-textures", "24-flat"};
  return names[static_cast<unsigned>(renderer)];
}

[[nodiscard]] constexpr bool is_spanning(SelftestRenderer renderer) {
  return renderer == SelftestRenderer::span_flat || renderer == SelftestRenderer::span_gouraud ||
         renderer == SelftestRenderer::span_layers || renderer == SelftestRenderer::span_surfaces ||
         renderer == SelftestRenderer::span_textures;
}

/// Whether a machine with so much memory for pictures has flash for the renderer. Small boards leave out what larger
/// ones show as well: below 8 KB 24 bits, and those of 32 to 64 KB, which draw scenes of every other kind, some forms
/// that the smaller ones draw.
[[nodiscard]] constexpr bool has_flash_for(SelftestRenderer renderer, std::uint32_t memory) {
  constexpr std::uint32_t kilobyte = 1024;
  switch (renderer) {
    case SelftestRenderer::swapped_16:
    case SelftestRenderer::gouraud_24_larger:
      return memory >= 64 * kilobyte;
    case SelftestRenderer::gouraud_24:
      return memory >= 8 * kilobyte;
    case SelftestRenderer::sort_flat:
      return memory >= 64 * kilobyte || (memory >= 8 * kilobyte && memory < 32 * kilobyte);
    default:
      return true;
  }
}

/// One drawing of a scene.
struct SelftestRun {
  SelftestRenderer renderer;
  std::uint16_t band;    ///< lines; the height of the picture for a z-buffer; 0 ends a list of runs
  std::uint32_t memory;  ///< bytes that it takes on a 32-bit machine, at most
};

/// A scene of the self-test: the same picture on every machine.
struct SelftestScene {
  const char* name;
  void (*build)(const SelftestRequest&, SelftestContent&);
  Capacity capacity;             ///< what it takes; the height of bands is a run's business
  std::uint32_t soup_triangles;  ///< given on screen
  Pool starved;                  ///< the pool that is too small for it, on purpose
  std::array<SelftestRun, 10> runs;
  std::uint32_t awake = 0;  ///< polygons awake at once: the active pool of spanning runs, and that of layers
};

}  // namespace spanline::scenes
