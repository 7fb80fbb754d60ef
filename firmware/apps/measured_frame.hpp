#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "board.hpp"
#include "counter.hpp"
#include "scenes/crc32.hpp"
#include "spanline/frame/renderer.hpp"
#include "spanline/visibility/span/spanning_scan_line.hpp"
#include "spanline/visibility/zbuffer/deferred.hpp"

namespace spanline::measured {

template <class Traits>
constexpr bool is_spanning = std::is_same_v<typename Traits::Visibility, Spanning>;
template <class Visibility>
constexpr bool is_deferred = false;
template <unsigned Kept>
constexpr bool is_deferred<Deferred<Kept>> = true;

/// The algorithm's name on the command line; `band` 0 is the whole picture.
template <class Traits>
constexpr const char* visibility_name(unsigned band) {
  if (is_spanning<Traits>) return "span";
  if (std::is_same_v<typename Traits::Visibility, BoundedZBuffer>) return "zbuffer+bounds";
  if (is_deferred<typename Traits::Visibility>) return "deferred";
  return band == 0 ? "zbuffer" : "scanline-z";
}

struct Frame {
  std::uint32_t instructions;  ///< of the second frame, from `begin` to the last band, clears apart
  std::uint32_t crc;           ///< of its pixels
  std::size_t peak_bytes;
  bool complete;  ///< no pool ran full
};

/// Its bands go nowhere.
struct NullSink {};

/// Draws two frames in `memory` and measures the second. `submit(renderer)` starts a frame and adds what it shows.
/// `band`: lines a band, 0 for the whole picture at once.
template <class Traits, class Submit>
[[gnu::always_inline]] inline Frame warm_frame(Capacity capacity, unsigned band, std::span<std::byte> memory,
                                               Submit submit) {
  capacity.band_lines = static_cast<std::uint16_t>(band == 0 ? capacity.height : band);
  capacity.colour_bands = band == 0 ? 1 : 2;
  if (!is_spanning<Traits> && band == 0) capacity.active = 0;
  Renderer<Traits> renderer(capacity, memory);
  Frame frame{};
  for (int turn = 0; turn < 2; ++turn) {
    scenes::Crc32 crc;
    board::counter_start();
    submit(renderer);
    frame.instructions = board::counter_read();
    NullSink sink;
    frame.complete = renderer.start_bands().ok();
    for (std::uint32_t i = 0; i < capacity.bands(); ++i) {
      frame.complete &= renderer.clear_band(i).ok();
      board::counter_start();
      const auto view = renderer.draw_band(i, sink);
      frame.instructions += board::counter_read();
      for (const auto pixel : view.pixels) crc.add(pixel);
    }
    frame.complete &= renderer.end_bands().ok();
    board::counter_report();
    frame.crc = crc.value();
  }
  frame.peak_bytes = renderer.peaks().total();
  return frame;
}

}  // namespace spanline::measured
