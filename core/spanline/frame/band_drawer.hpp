#pragma once
#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/cpu/fill_constant.hpp"
#include "spanline/frame/status.hpp"
#include "spanline/memory/arena.hpp"
#include "spanline/memory/capacity.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/shade/shading_group.hpp"
#include "spanline/visibility/algorithm.hpp"
#include "spanline/visibility/counters.hpp"

namespace spanline {

/// A finished band of lines, as the sink gets it.
template <class Pixel, class DepthWord>
struct Band {
  std::int32_t y0;                   ///< its first line in the picture, [0, height)
  std::int32_t y1;                   ///< the line behind its last, (y0, height]
  std::span<Pixel> pixels;           ///< line by line, width · (y1 − y0)
  std::span<const DepthWord> depth;  ///< parallel to the pixels; empty where the algorithm keeps none
  unsigned buffer;                   ///< which of the drawer's colour bands holds it, counted from 0
};

/// Which bands of a frame somebody draws; bands count from 0 at the top.
enum class BandShare : std::uint8_t {
  all,   ///< a renderer alone
  even,  ///< a renderer with a partner: 0, 2, 4, …
  odd,   ///< the partner: 1, 3, 5, …
};

/// What a frame shows, as its bands are drawn from it.
template <class Pixel>
struct BandScene {
  PolygonTable& table;                    ///< spanning takes its buckets apart
  std::span<const ShadingGroup> shading;  ///< one a group of the table
  Pixel background;                       ///< where no polygon is
  VisibilityCounters* counters;           ///< written where the traits count
  const World* world;                     ///< null where the algorithm takes screen polygons alone
};

/// A sink behind which hardware fills memory while the core goes on. `fill(value, count, words)` starts it, two at a
/// time at most, from words that begin as the arena lets them begin; `filled()` waits until all of it has ended, and
/// may return false to give the frame up. `available(buffer)` tells whether `acquire` would return at once.
template <class Sink, class Word, class Pixel>
concept FillingSink = requires(Sink& sink, Word* depth, Pixel* pixels, Word value, Pixel pixel) {
  { sink.acquire(0u) } -> std::same_as<bool>;
  { sink.available(0u) } -> std::same_as<bool>;
  sink.fill(value, std::uint32_t{1}, depth);
  sink.fill(pixel, std::uint32_t{1}, pixels);
  { sink.filled() } -> std::same_as<bool>;
};

/// Draws the bands of a frame, or every second one, from a polygon table: a visibility algorithm with its memory, a
/// depth band, and the colour bands that it draws into by turns. All state between bands is its own, so that several
/// may draw from one table at a time where the algorithm leaves the table alone.
template <class Traits>
class BandDrawer {
 public:
  using DepthWord = typename Traits::Depth::Word;  ///< of the depth buffer
  using Pixel = typename Traits::Format::Pixel;    ///< a word of the pixel format
  using BandView = Band<Pixel, DepthWord>;         ///< what a sink gets
  using Scene = BandScene<Pixel>;                  ///< what bands are drawn from
  /// The visibility algorithm.
  using Visibility = typename Traits::Visibility::template Algorithm<typename Traits::Depth, Pixel,
                                                                     typename Traits::Shaders, Traits::statistics>;
  static_assert(VisibilityAlgorithm<Visibility, ShadingGroup>,
                "the traits' Visibility lacks what visibility/algorithm.hpp asks for");

  /// Its part of the caller's memory.
  struct Pools {
    typename Visibility::Memory visibility;  ///< the algorithm's
    std::span<DepthWord> depth;              ///< all bands
    std::span<Pixel> colour;                 ///< all bands

    /// Words from one band to the next: each begins as the arena would let it begin.
    template <class Word>
    static constexpr std::size_t stride(const Capacity& c) {
      constexpr std::size_t words_a_step = std::max<std::size_t>(Arena::alignment / sizeof(Word), 1);
      return (std::size_t{c.width} * c.band_lines + words_a_step - 1) / words_a_step * words_a_step;
    }
    /// Cuts them out of an arena.
    constexpr void take(Arena& arena, const Capacity& c) {
      visibility.take(arena, c);
      const std::size_t depth_size =
          c.depth_bands == 1 ? std::size_t{c.width} * c.band_lines : stride<DepthWord>(c) * c.depth_bands;
      depth = arena.take<DepthWord>(Visibility::keeps_depth ? depth_size : 0);
      colour = arena.take<Pixel>(stride<Pixel>(c) * c.colour_bands);
    }
  };

  /// Nothing to draw with, until another is assigned.
  BandDrawer() = default;
  /// Draws pictures of this capacity in these pools.
  BandDrawer(const Capacity& capacity, const Pools& pools)
      : capacity_(capacity), pools_(pools), visibility_(pools.visibility) {}

  /// Draws a frame's share. For each band: `sink.acquire(buffer)` where the sink has it, which waits until that colour
  /// band is free again; then the drawing; then `sink(band)`. Either may return false to give the frame up. A
  /// FillingSink clears each band while the one above it is drawn.
  template <class Sink>
  Status draw(const Scene& scene, BandShare share, Sink& sink) {
    start(scene, share);
    for (std::uint32_t band = 0; band < capacity_.bands(); ++band) {
      if (!draws(band)) {
        skip_band(scene, band);
        continue;
      }
      if (!make_ready(scene, band, sink)) return Fault::sink_failed;
      const BandView view = draw_band(scene, band, sink);
      if (!sink(view)) return Fault::sink_failed;
    }
    return end(scene);
  }

  // The steps of `draw`.

  /// Begins a frame, or somebody's share of one.
  void start(const Scene& scene, BandShare share) {
    share_ = share;
    if (scene.counters != nullptr) scene.counters->names = Visibility::counter_names;
    visibility_.begin_frame(input(scene));
  }
  /// Whether a band belongs to the share.
  [[nodiscard]] bool draws(std::uint32_t band) const {
    return share_ == BandShare::all || (band & 1) == (share_ == BandShare::odd ? 1u : 0u);
  }
  /// Steps over a band that somebody else draws.
  void skip_band(const Scene& scene, std::uint32_t band) {
    const std::int32_t y0 = first_line(band);
    visibility_.skip_band(scene.table, scene.shading, static_cast<std::int32_t>(band), viewport(),
                          {nullptr, nullptr, capacity_.width, y0 + row_bias, end_line(y0) + row_bias, {}});
  }
  /// Prepares a band's colour and depth as the algorithm wants them.
  void clear_band(const Scene& scene, std::uint32_t band) {
    visibility_.clear(target(scene, band, band_view(band)),
                      [](auto value, std::uint32_t count, auto* words) { fill_constant(value, count, words); });
  }
  /// For a FillingSink: starts to clear a band of the share, before its turn comes. False where the sink gives up.
  template <class Sink>
  bool clear_ahead(const Scene& scene, std::uint32_t band, Sink& sink) {
    if (!sink.acquire(buffer_of(band))) return false;
    visibility_.clear(target(scene, band, band_view(band)),
                      [&](auto value, std::uint32_t count, auto* words) { sink.fill(value, count, words); });
    cleared_ = static_cast<std::uint16_t>(band);
    return true;
  }
  /// Nothing has been cleared ahead.
  void forget_clears() { cleared_ = none; }
  /// Draws a band that was cleared, and tells the sink of covered triangles where the traits count.
  template <class Sink>
  BandView draw_band(const Scene& scene, std::uint32_t band, Sink& sink) {
    const BandView view = band_view(band);
    visibility_.draw_band(scene.table, scene.shading, static_cast<std::int32_t>(band), viewport(),
                          target(scene, band, view), [&](std::uint32_t id) {
                            if constexpr (requires { sink.covered(id); }) sink.covered(id);
                          });
    return view;
  }
  /// Ends the frame, and says what has run full.
  Status end(const Scene& scene) {
    forget_clears();
    first_buffer_ = static_cast<std::uint8_t>(buffer_of(capacity_.bands()));
    const PoolShortage shortage = visibility_.shortage(input(scene));
    if (shortage.pool != Pool::none) return {Fault::pool_full, shortage.pool, shortage.wanted};
    return {};
  }

  /// A colour band's memory; empty where the band does not exist.
  [[nodiscard]] std::span<Pixel> colour_band(unsigned buffer) const {
    const std::size_t start = std::size_t{buffer} * Pools::template stride<Pixel>(capacity_);
    if (start >= pools_.colour.size()) return {};
    return pools_.colour.subspan(start, std::size_t{capacity_.width} * capacity_.band_lines);
  }
  /// The sizes that it was made for.
  [[nodiscard]] const Capacity& capacity() const { return capacity_; }
  /// Its memory.
  [[nodiscard]] const Pools& pools() const { return pools_; }
  /// The algorithm, for what it has counted.
  [[nodiscard]] const Visibility& visibility() const { return visibility_; }

 private:
  [[nodiscard]] FrameInput input(const Scene& scene) const {
    return {scene.table, viewport(), capacity_.band_lines, scene.world};
  }
  static constexpr std::uint16_t none = 0xffff;

  /// Waits for a band's buffer and has it cleared.
  template <class Sink>
  bool make_ready(const Scene& scene, std::uint32_t band, Sink& sink) {
    if constexpr (FillingSink<Sink, DepthWord, Pixel>) {
      if (band != cleared_ && !clear_ahead(scene, band, sink)) return false;
      if (!sink.filled()) return false;
      const std::uint32_t next = band + (share_ == BandShare::all ? 1 : 2);
      if (Visibility::clears_ahead && capacity_.depth_bands == 2 && next < capacity_.bands() &&
          sink.available(buffer_of(next)))
        return clear_ahead(scene, next, sink);
      return true;
    } else {
      if constexpr (requires { sink.acquire(0u); }) {
        if (!sink.acquire(buffer_of(band))) return false;
      }
      clear_band(scene, band);
      return true;
    }
  }

  [[nodiscard]] Viewport viewport() const { return {capacity_.width, capacity_.height}; }
  [[nodiscard]] std::int32_t first_line(std::uint32_t band) const {
    return static_cast<std::int32_t>(band * capacity_.band_lines);
  }
  [[nodiscard]] std::int32_t end_line(std::int32_t first) const {
    return std::min<std::int32_t>(first + capacity_.band_lines, capacity_.height);
  }
  /// Bands of the share among the first `bands`.
  [[nodiscard]] std::uint32_t turns(std::uint32_t bands) const {
    return share_ == BandShare::all ? bands : (bands + (share_ == BandShare::even ? 1 : 0)) >> 1;
  }
  /// Up to two colour bands go without the remainder, which costs Cortex-M0+ a call a band.
  [[nodiscard]] unsigned buffer_of(std::uint32_t band) const {
    const std::uint32_t turn = turns(band);
    if (capacity_.colour_bands <= 2) return turn & (capacity_.colour_bands - 1u);
    return (first_buffer_ + turn) % capacity_.colour_bands;
  }
  /// Where a band's depth begins.
  [[nodiscard]] std::size_t depth_start(std::uint32_t band) const {
    if (!Visibility::keeps_depth || capacity_.depth_bands == 1) return 0;
    return (turns(band) & 1) * Pools::template stride<DepthWord>(capacity_);
  }
  [[nodiscard]] BandView band_view(std::uint32_t band) const {
    const std::int32_t y0 = first_line(band), y1 = end_line(y0);
    const std::size_t count = std::size_t{capacity_.width} * static_cast<std::size_t>(y1 - y0);
    const unsigned buffer = buffer_of(band);
    return {y0, y1, colour_band(buffer).first(count),
            pools_.depth.subspan(depth_start(band), Visibility::keeps_depth ? count : 0), buffer};
  }
  [[nodiscard]] typename Visibility::Target target(const Scene& scene, std::uint32_t band, const BandView& view) const {
    return {pools_.depth.data() + depth_start(band),
            view.pixels.data(),
            capacity_.width,
            view.y0 + row_bias,
            view.y1 + row_bias,
            scene.background,
            scene.counters};
  }

  Capacity capacity_;
  Pools pools_{};
  Visibility visibility_{};
  std::uint16_t cleared_ = none;   ///< band that is being cleared ahead
  std::uint8_t first_buffer_ = 0;  ///< colour band that the frame's first band of lines goes to
  BandShare share_ = BandShare::all;
};

}  // namespace spanline
