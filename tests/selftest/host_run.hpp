#pragma once
#include <bunny.hpp>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <teapot.hpp>
#include <vector>

#include "scenes/selftest_runner.hpp"

namespace spanline::test {

inline constexpr scenes::SelftestModels selftest_models{spanline_models::bunny, spanline_models::teapot};

/// Draws a run of the self-test on this host, which has all the memory that it wants.
template <class See>
scenes::SelftestResult draw_on_host(const scenes::SelftestScene& scene, const scenes::SelftestRun& run, See&& see) {
  static_assert(alignof(std::uint64_t) >= Arena::alignment);
  std::vector<std::uint64_t> words(selftest_bytes(scene, run) / sizeof(std::uint64_t) + 1);
  const std::span<std::byte> memory = std::as_writable_bytes(std::span(words));
  return scenes::draw_selftest<std::numeric_limits<std::uint32_t>::max()>(scene, run, selftest_models, memory, see);
}

}  // namespace spanline::test
