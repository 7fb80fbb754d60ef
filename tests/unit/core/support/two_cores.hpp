#pragma once
#include <spanline/frame/band_partner.hpp>

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

#include "support/studio.hpp"

namespace spanline::test {

/// Collects bands, and nothing else.
template <class Traits>
struct BandCollector {
  Picture<Traits>& picture;
  template <class Band>
  bool operator()(const Band& band) {
    return Collector<Traits>{picture}(band);
  }
};

/// The studio's frame by two threads that draw at a time, each every second band.
template <class Traits>
[[nodiscard]] Picture<Traits> draw_on_two_cores(Studio<Traits>& studio) {
  Renderer<Traits>& renderer = studio.renderer();
  std::vector<std::byte> memory(BandPartner<Traits>::bytes_needed(renderer.capacity()));
  BandPartner<Traits> partner(renderer, memory);
  studio.note(partner.status());
  Picture<Traits> even = studio.empty_picture(), odd = studio.empty_picture();
  studio.note(partner.take_frame());
  Status odd_status;
  std::thread other([&] { odd_status = partner.draw_odd(BandCollector<Traits>{odd}); });
  studio.note(renderer.draw_even(BandCollector<Traits>{even}));
  other.join();
  studio.note(odd_status);
  const Capacity& c = renderer.capacity();
  for (int y = 0; y < c.height; ++y) {
    if (y / c.band_lines % 2 == 0) continue;
    const auto begin = static_cast<std::ptrdiff_t>(even.at(0, y)), end = begin + c.width;
    std::copy(odd.pixels.begin() + begin, odd.pixels.begin() + end, even.pixels.begin() + begin);
    std::copy(odd.depth.begin() + begin, odd.depth.begin() + end, even.depth.begin() + begin);
  }
  return even;
}

}  // namespace spanline::test
