// What must hold of the self-test's scenes on any machine, looked at on this one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "host_run.hpp"
#include "spanline/model/validate.hpp"

namespace spanline {
namespace {

using scenes::SelftestRenderer;
using scenes::SelftestRun;
using scenes::SelftestScene;

constexpr std::uint32_t all_memory = std::numeric_limits<std::uint32_t>::max();

bool has_24_bits(SelftestRenderer renderer) {
  return renderer == SelftestRenderer::gouraud_24 || renderer == SelftestRenderer::gouraud_24_larger ||
         renderer == SelftestRenderer::layers_24 || renderer == SelftestRenderer::surfaces_24 ||
         renderer == SelftestRenderer::sort_flat || scenes::is_spanning(renderer);
}

TEST(SelftestScenes, MeshesAreValid) {
  for (const Mesh* mesh : {&scenes::torus, &scenes::coloured_torus, &scenes::prisms, &scenes::terrain,
                           &test::selftest_models().bunny, &test::selftest_models().teapot}) {
    const MeshReport report = validate(*mesh);
    EXPECT_TRUE(report.ok()) << to_string(report.fault) << " at " << report.at;
  }
}

TEST(SelftestScenes, NamesAreDistinct) {
  std::set<std::string> names;
  for (const SelftestScene& scene : scenes::selftest_scenes) EXPECT_TRUE(names.insert(scene.name).second) << scene.name;
}

/// Band heights and senses of depth change no pixel; 16 and 24 bits are two pictures. Swapped pixels have CRCs of their
/// own, and pools of active polygons and of layers run full as the bands lie.
TEST(SelftestScenes, EveryRunOfASceneDrawsTheSamePicture) {
  scenes::for_each_selftest_run(all_memory, [](const SelftestScene& scene, const SelftestRun& run) {
    static std::map<std::pair<std::string, bool>, std::uint32_t> pictures;
    const scenes::SelftestResult result = test::draw_on_host(scene, run).result;
    EXPECT_TRUE(as_expected(scene, result.status))
        << scene.name << ": " << to_string(result.status.fault) << ", " << to_string(result.status.pool) << ", wanted "
        << result.status.wanted;
    if (run.renderer == SelftestRenderer::swapped_16 || scene.starved == Pool::active ||
        scene.starved == Pool::fragments)
      return;
    const auto [first, is_new] = pictures.try_emplace({scene.name, has_24_bits(run.renderer)}, result.crc);
    EXPECT_EQ(first->second, result.crc) << scene.name << ", depth " << to_string(run.renderer) << ", band "
                                         << run.band;
  });
}

/// So do the exact algorithms beyond the table; at least half of its scenes are theirs.
TEST(SelftestScenes, EveryAlgorithmDrawsThePictureOf24Bits) {
  std::map<std::string, std::uint32_t> pictures;
  scenes::for_each_selftest_run(all_memory, [&](const SelftestScene& scene, const SelftestRun& run) {
    if (scenes::is_for_every_algorithm(scene) && has_24_bits(run.renderer) && !pictures.contains(scene.name))
      pictures[scene.name] = test::draw_on_host(scene, run).result.crc;
  });
  EXPECT_GE(2 * pictures.size(), scenes::selftest_scenes.size());
  scenes::for_each_registry_run(
      all_memory, [&](const AlgorithmEntry& entry, const SelftestScene& scene, std::uint16_t band) {
        const scenes::SelftestResult result = test::draw_on_host(entry, scene, band);
        EXPECT_TRUE(result.status.ok()) << scene.name << " by " << entry.name;
        if (entry.exactness == Exactness::exact) {
          EXPECT_EQ(result.crc, pictures.at(scene.name)) << scene.name << " by " << entry.name;
        }
      });
}

/// The share of a picture that is covered, in percent.
int covered_percent(const SelftestScene& scene, const SelftestRun& run) {
  const std::vector<bool> covered = test::draw_on_host(scene, run).covered;
  return static_cast<int>(100 * std::count(covered.begin(), covered.end(), true) /
                          static_cast<std::ptrdiff_t>(covered.size()));
}

TEST(SelftestScenes, NoPictureIsEmpty) {
  for (const SelftestScene& scene : scenes::selftest_scenes)
    EXPECT_GE(covered_percent(scene, scene.runs.front()), 2) << scene.name;
}

/// In these scenes ambient light alone gives red at least 2 of 31; less on a covered pixel is a shade that wrapped.
TEST(SelftestScenes, NoSmoothSurfaceIsDarkerThanAmbientLight) {
  const std::set<std::string> smooth{"bunny-gouraud", "teapot-gouraud", "lights", "lights-smooth-small"};
  scenes::for_each_selftest_run(all_memory, [&](const SelftestScene& scene, const SelftestRun& run) {
    if (!smooth.contains(scene.name) || run.renderer != SelftestRenderer::gouraud_16) return;
    int wrapped = 0;
    const test::HostPicture drawn = test::draw_on_host(scene, run);
    for (std::size_t i = 0; i < drawn.pixels.size(); ++i)
      wrapped += drawn.covered[i] && drawn.pixels[i] >> 11 < 2 ? 1 : 0;
    EXPECT_EQ(wrapped, 0) << scene.name << ", band " << run.band;
  });
}

/// On a board with 16 KB of RAM, of which picture_memory.hpp leaves 13,056 bytes.
TEST(SelftestScenes, SmallestBoardDrawsAtLeast200PolygonsInBands) {
  std::uint32_t most = 0;
  scenes::for_each_selftest_run(13'056, [&](const SelftestScene& scene, const SelftestRun& run) {
    const bool meant = scene.starved == Pool::none && scene.soup_triangles == 0 && run.band < scene.capacity.height;
    if (!meant || scene.capacity.width != 128 || scene.capacity.height != 128) return;
    most = std::max(most, test::draw_on_host(scene, run).result.drawn);
  });
  EXPECT_GE(most, 200U);
}

}  // namespace
}  // namespace spanline
