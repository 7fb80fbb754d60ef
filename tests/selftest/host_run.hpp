#pragma once
#include <cstdint>
#include <vector>

#include "scenes/selftest_registry.hpp"
#include "scenes/selftest_runner.hpp"
#include "spanline/model/colour.hpp"

namespace spanline::test {

/// The models of the packages, as the boards have them.
[[nodiscard]] const scenes::SelftestModels& selftest_models();

/// What a run of the self-test draws on this host, which has all the memory that it wants.
struct HostPicture {
  scenes::SelftestResult result;
  std::vector<std::uint16_t> pixels;  ///< row by row, as stored
  std::vector<bool> covered;          ///< whether a pixel's depth is a polygon's; empty where nothing keeps depths
};
/// Compiled once for all programs that want it: it holds every renderer of the table.
[[nodiscard]] HostPicture draw_on_host(const scenes::SelftestScene& scene, const scenes::SelftestRun& run);

/// The same by an algorithm that the table has no runs for: no more than the result.
[[nodiscard]] scenes::SelftestResult draw_on_host(const AlgorithmEntry& entry, const scenes::SelftestScene& scene,
                                                  std::uint16_t band);

/// Its pixels for a picture file, row by row, channels rounded to the nearest of 255ths.
[[nodiscard]] std::vector<Rgb888> colours_of(const HostPicture& picture, const scenes::SelftestRun& run);

}  // namespace spanline::test
