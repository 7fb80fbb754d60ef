#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "support/random_instance.hpp"
#include "support/ready_made_studios.hpp"

namespace spanline::test {

/// Any texture coordinates for each of the instance's vertices.
inline void add_texture_coordinates(Random& random, OwnedMesh& owned) {
  const auto any = [&] { return static_cast<std::int16_t>(random.between(-32768, 32767)); };
  for (std::size_t i = 0; i < owned.view().vertex_count(); ++i) {
    const std::int16_t s = any();
    owned.texture_coordinates.push_back({s, any()});
  }
}

/// The pixels of an instance in bands of so many lines.
template <class Traits>
[[nodiscard]] std::vector<typename Traits::Format::Pixel> instance_pixels(const RandomInstance& instance,
                                                                          const FrameSettings& settings,
                                                                          const Material& material, int lines) {
  Capacity capacity = mesh_capacity(instance.view.viewport.width, instance.view.viewport.height, 1,
                                    instance.mesh.vertex_count(), instance.mesh.triangle_count());
  capacity.band_lines = static_cast<std::uint16_t>(std::min<int>(lines, capacity.height));
  capacity.active = capacity.awake = capacity.polygons;
  Studio<Traits> studio(capacity);
  studio.begin(settings);
  studio.add(instance.mesh, instance.transform, material);
  auto pixels = studio.draw().pixels;
  EXPECT_TRUE(studio.status().ok()) << to_string(studio.status().fault) << to_string(studio.status().pool);
  return pixels;
}

/// The whole picture by the z-buffer is that of bands, and that by spans.
template <class ByBuffer, class BySpans>
void expect_alike_in_bands_and_spans(const RandomInstance& instance, const FrameSettings& settings,
                                     const Material& material) {
  const auto whole = instance_pixels<ByBuffer>(instance, settings, material, 4096);
  for (const int lines : {1, 13})
    EXPECT_EQ(instance_pixels<ByBuffer>(instance, settings, material, lines), whole) << lines;
  EXPECT_EQ(instance_pixels<BySpans>(instance, settings, material, 16), whole);
}

}  // namespace spanline::test
