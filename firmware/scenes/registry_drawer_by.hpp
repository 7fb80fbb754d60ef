#pragma once
#include "scenes/selftest_registry.hpp"
#include "scenes/selftest_runner.hpp"

namespace spanline::scenes {

/// One list of shaders for all scenes.
template <class Visibility>
RegistryDrawer registry_drawer_by() {
  using Traits = SeeThroughTraits<Rgb565, Depth24<>, Visibility>;
  return {selftest_detail::bytes<Traits>, [](const SelftestScene& scene, std::uint16_t band,
                                             const SelftestModels& models, std::span<std::byte> memory) {
            if (selftest_detail::bytes<Traits>(scene, band) > memory.size())
              return SelftestResult{{Fault::pool_full, Pool::memory, 0}};
            return selftest_detail::draw<Traits>(scene, band, models, memory, [](const auto&) {});
          }};
}

}  // namespace spanline::scenes
