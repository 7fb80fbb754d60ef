#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "scenes/selftest_result.hpp"
#include "scenes/selftest_table.hpp"
#include "spanline/visibility/registry.hpp"

/// The self-test by the algorithms of the registry that the table has no runs for: each draws the table's scenes by
/// rule, without a line of its own here.
namespace spanline::scenes {

/// Whether the table draws by it: the algorithms of small boards, whose memory is stated run by run. The build makes no
/// translation unit for these (firmware/scenes/CMakeLists.txt names them as well).
[[nodiscard]] constexpr bool drawn_by_table(AlgorithmId id) {
  return id == AlgorithmId::zbuffer || id == AlgorithmId::scanline_z || id == AlgorithmId::span;
}

/// Bytes of boards that draw by every algorithm. One of each instruction set has them.
inline constexpr std::uint32_t memory_for_every_algorithm = 1024 * 1024;

/// Scenes that the table draws at 24 bits by flat and Gouraud shading, opaque or see-through, and in which no pool runs
/// full on purpose.
[[nodiscard]] constexpr bool is_for_every_algorithm(const SelftestScene& scene) {
  bool found = false;
  for (const SelftestRun& run : scene.runs)
    found = found || (run.band != 0 &&
                      (run.renderer == SelftestRenderer::gouraud_24 || run.renderer == SelftestRenderer::layers_24));
  return found && scene.starved == Pool::none;
}

/// Calls visit(entry, scene, band) for every such drawing of a machine with `memory` bytes to spare.
template <class Visit>
constexpr void for_each_registry_run(std::uint32_t memory, Visit&& visit) {
  if (memory < memory_for_every_algorithm) return;
  for (const AlgorithmEntry& entry : algorithm_registry)
    for (const SelftestScene& scene : selftest_scenes) {
      if (drawn_by_table(entry.id) || !is_for_every_algorithm(scene)) continue;
      if (scene.soup_triangles != 0 && !entry.takes_screen_polygons()) continue;
      const std::uint16_t height = scene.capacity.height;
      visit(entry, scene, entry.full_frame() || height < 16 ? height : std::uint16_t{16});
    }
}

/// How one algorithm draws.
struct RegistryDrawer {
  /// Bytes that a scene takes on this machine.
  std::size_t (*bytes)(const SelftestScene& scene, std::uint16_t band) = nullptr;
  /// `memory` is as draw_selftest wants it.
  SelftestResult (*draw)(const SelftestScene& scene, std::uint16_t band, const SelftestModels& models,
                         std::span<std::byte> memory) = nullptr;
};

/// Each in a translation unit of its own, which the build makes of registry_drawer.cpp.in.
template <AlgorithmId Unit>
[[nodiscard]] RegistryDrawer registry_drawer();
#define SPANLINE_ALGORITHM(id, ...) \
  template <>                       \
  RegistryDrawer registry_drawer<AlgorithmId::id>();
#include "spanline/visibility/algorithms.def"

/// The drawer of an algorithm that the table does not draw by.
[[nodiscard]] inline RegistryDrawer registry_drawer_of(const AlgorithmEntry& entry) {
  return with_unit(entry.id, []<AlgorithmId Unit>() -> RegistryDrawer {
    if constexpr (drawn_by_table(Unit))
      return {};
    else
      return registry_drawer<Unit>();
  });
}

}  // namespace spanline::scenes
