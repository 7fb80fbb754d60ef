#include "host_run.hpp"

#include <bunny.hpp>
#include <cstddef>
#include <limits>
#include <span>
#include <teapot.hpp>

namespace spanline::test {
namespace {

using scenes::SelftestRenderer;

bool larger_is_nearer(SelftestRenderer renderer) {
  return renderer == SelftestRenderer::flat_16_larger || renderer == SelftestRenderer::gouraud_24_larger;
}

/// Gathers the bands of a picture, which come from the top down.
struct Collector {
  HostPicture& picture;
  bool larger_is_nearer;

  template <class Word>
  [[nodiscard]] bool is_covered(Word depth) const {
    return depth != (larger_is_nearer ? Word{0} : std::numeric_limits<Word>::max());
  }
  template <class Band>
  void operator()(const Band& band) {
    picture.pixels.insert(picture.pixels.end(), band.pixels.begin(), band.pixels.end());
    for (const auto depth : band.depth) picture.covered.push_back(is_covered(depth));
  }
};

unsigned swapped_bytes(unsigned half_word) { return (half_word << 8 | half_word >> 8) & 0xffffU; }

Rgb888 rgb888(unsigned rgb565) {
  const auto channel = [](unsigned value, unsigned greatest) {
    return static_cast<std::uint8_t>((value * 255 + greatest / 2) / greatest);
  };
  return {channel(rgb565 >> 11, 31), channel(rgb565 >> 5 & 63, 63), channel(rgb565 & 31, 31)};
}

}  // namespace

const scenes::SelftestModels& selftest_models() {
  static constexpr scenes::SelftestModels models{spanline_models::bunny, spanline_models::teapot};
  return models;
}

HostPicture draw_on_host(const scenes::SelftestScene& scene, const scenes::SelftestRun& run) {
  static_assert(alignof(std::uint64_t) >= Arena::alignment);
  std::vector<std::uint64_t> words(selftest_bytes(scene, run) / sizeof(std::uint64_t) + 1);
  const std::span<std::byte> memory = std::as_writable_bytes(std::span(words));
  HostPicture picture;
  Collector collector{picture, larger_is_nearer(run.renderer)};
  constexpr std::uint32_t any_memory = std::numeric_limits<std::uint32_t>::max();
  picture.result = scenes::draw_selftest<any_memory>(scene, run, selftest_models(), memory, collector);
  return picture;
}

scenes::SelftestResult draw_on_host(const AlgorithmEntry& entry, const scenes::SelftestScene& scene,
                                    std::uint16_t band) {
  const scenes::RegistryDrawer drawer = scenes::registry_drawer_of(entry);
  std::vector<std::uint64_t> words(drawer.bytes(scene, band) / sizeof(std::uint64_t) + 1);
  return drawer.draw(scene, band, selftest_models(), std::as_writable_bytes(std::span(words)));
}

std::vector<Rgb888> colours_of(const HostPicture& picture, const scenes::SelftestRun& run) {
  const bool swapped = run.renderer == SelftestRenderer::swapped_16;
  std::vector<Rgb888> colours;
  colours.reserve(picture.pixels.size());
  for (const unsigned stored : picture.pixels) colours.push_back(rgb888(swapped ? swapped_bytes(stored) : stored));
  return colours;
}

}  // namespace spanline::test
