// Every scene of the self-test, with either depth, as z-buffer and in bands, against its golden CRC. A failure leaves
// the pictures got and wanted, and their difference, in the build folder.
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <string>

#include "golden_set.hpp"
#include "host_run.hpp"
#include "image/png.hpp"

namespace spanline::test {
namespace {

using scenes::SelftestRenderer;
using scenes::SelftestRun;
using scenes::SelftestScene;

constexpr std::uint32_t all_memory = std::numeric_limits<std::uint32_t>::max();

/// The bits of depth of runs that share a golden picture: plain pixels and smaller depths; 0 for others, which the
/// self-test compares with these.
int golden_bits(SelftestRenderer renderer) {
  switch (renderer) {
    case SelftestRenderer::flat_16:
    case SelftestRenderer::gouraud_16:
    case SelftestRenderer::textures_16:
      return 16;
    case SelftestRenderer::gouraud_24:
      return 24;
    default:
      return 0;
  }
}

/// Pictures whose bytes depend on where bands end have none.
bool has_golden(const SelftestScene& scene, const SelftestRun& run) {
  return golden_bits(run.renderer) != 0 && scene.starved != Pool::active;
}

struct Drawn {
  sim::Picture picture;
  GoldenSet::Crcs crcs;
};

Drawn draw(const SelftestScene& scene, const SelftestRun& run) {
  Drawn drawn{sim::Picture(scene.capacity.width, scene.capacity.height), {}};
  const HostPicture on_host = draw_on_host(scene, run);
  const scenes::SelftestResult& result = on_host.result;
  drawn.picture.pixels = colours_of(on_host, run);
  EXPECT_TRUE(as_expected(scene, result.status)) << scene.name;
  drawn.crcs = {result.crc, result.depth};
  return drawn;
}

void compare(const GoldenSet& golden, const SelftestScene& scene, const SelftestRun& run) {
  const std::string name = std::string(scene.name) + "-" + std::to_string(golden_bits(run.renderer));
  const Drawn drawn = draw(scene, run);
  const GoldenSet::Crcs* want = golden.find(name);
  if (want != nullptr && *want == drawn.crcs) return;
  write_difference(SPANLINE_DIFFERENCE_FOLDER, name, drawn.picture, golden.picture(name));
  ADD_FAILURE() << name << ", band " << run.band << (want == nullptr ? ": not in the table" : ": another picture")
                << "; see " << SPANLINE_DIFFERENCE_FOLDER << "; if it is right, build update-golden";
}

TEST(Golden, EverySceneDrawsItsPicture) {
  GoldenSet golden(SPANLINE_GOLDEN_FOLDER);
  const bool update = std::getenv("SPANLINE_UPDATE_GOLDEN") != nullptr;
  std::set<std::string> seen;
  scenes::for_each_selftest_run(all_memory, [&](const SelftestScene& scene, const SelftestRun& run) {
    if (!has_golden(scene, run)) return;
    const std::string name = std::string(scene.name) + "-" + std::to_string(golden_bits(run.renderer));
    if (seen.insert(name).second && update) {
      const Drawn drawn = draw(scene, run);
      golden.set(name, drawn.crcs, drawn.picture);
    } else {
      compare(golden, scene, run);
    }
  });
  for (const std::string& name : golden.names()) {
    if (seen.contains(name)) {
      EXPECT_FALSE(golden.picture(name).pixels.empty()) << name << ": has no picture; build update-golden";
    } else if (update) {
      golden.remove(name);
    } else {
      ADD_FAILURE() << name << ": no scene draws it any more; build update-golden";
    }
  }
  if (update) golden.save();
}

}  // namespace
}  // namespace spanline::test
