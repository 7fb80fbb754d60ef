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

/// A finished band of lines, as a sink receives it.
template <class Pixel, class DepthWord>
struct Band {
  std::int32_t y0;                   ///< its first line in the picture, [0, height)
  std::int32_t y1;                   ///< one past its last line, (y0, height]
  std::span<Pixel> pixels;           ///< row by row, width · (y1 − y0) of them
  std::span<const DepthWord> depth;  ///< one for each pixel; empty if the algorithm keeps no depths
  unsigned buffer;                   ///< number of the colour band that holds it, from 0
};

/// Which bands of a frame a drawer draws. Bands are numbered from 0 at the top.
enum class BandShare : std::uint8_t {
  all,   ///< a renderer without a partner
  even,  ///< a renderer with a partner: 0, 2, 4, …
  odd,   ///< the partner: 1, 3, 5, …
};

/// The input from which the bands of a frame are drawn.
template <class Pixel>
struct BandScene {
  PolygonTable& table;                    ///< spanning consumes its buckets
  std::span<const ShadingGroup> shading;  ///< one for each group of the table
  Pixel background;                       ///< colour of pixels that no polygon covers
  VisibilityCounters* counters;           ///< written if the traits ask for statistics
  const World* world;                     ///< null if the algorithm works on screen polygons alone
};

/// A sink that has hardware fill memory while the core continues. `fill(value, count, words)` starts a fill; at most
/// two may be under way, and `words` are aligned as the arena aligns them. `filled()` waits until all fills have ended
/// and may return false to abandon the frame. `available(buffer)` tells whether `acquire` would return at once.
template <class Sink, class Word, class Pixel>
concept FillingSink = requires(Sink& sink, Word* depth, Pixel* pixels, Word value, Pixel pixel) {
  { sink.acquire(0u) } -> std::same_as<bool>;
  { sink.available(0u) } -> std::same_as<bool>;
  sink.fill(value, std::uint32_t{1}, depth);
  sink.fill(pixel, std::uint32_t{1}, pixels);
  { sink.filled() } -> std::same_as<bool>;
};

/// Draws all or every second of a frame's bands from a polygon table. It holds a visibility algorithm with its memory,
/// a depth band, and the colour bands, which it uses in turn. It keeps all state between bands itself, so several
/// drawers may draw from one table at the same time if the algorithm does not change the table.
template <class Traits>
class BandDrawer {
 public:
  using DepthWord = typename Traits::Depth::Word;  ///< a depth in the depth buffer
  using Pixel = typename Traits::Format::Pixel;    ///< a pixel in the pixel format
  using BandView = Band<Pixel, DepthWord>;         ///< what a sink receives
  using Scene = BandScene<Pixel>;                  ///< the input of a frame
  /// The visibility algorithm.
  using Visibility = typename Traits::Visibility::template Algorithm<typename Traits::Depth, Pixel,
                                                                     typename Traits::Shaders, Traits::statistics>;
  static_assert(VisibilityAlgorithm<Visibility, ShadingGroup>,
                "the traits' Visibility lacks what visibility/algorithm.hpp asks for");

  /// The drawer's part of the caller's memory.
  struct Pools {
    typename Visibility::Memory visibility;  ///< memory of the visibility algorithm
    std::span<DepthWord> depth;              ///< all depth bands, one after another
    std::span<Pixel> colour;                 ///< all colour bands, one after another

    /// Distance between the starts of two bands, in words. It is rounded up so that each band is aligned as the arena
    /// would align it.
    template <class Word>
    static constexpr std::size_t stride(const Capacity& c) {
      constexpr std::size_t words_a_step = std::max<std::size_t>(Arena::alignment / sizeof(Word), 1);
      return (std::size_t{c.width} * c.band_lines + words_a_step - 1) / words_a_step * words_a_step;
    }
    /// Takes the pools from an arena.
    constexpr void take(Arena& arena, const Capacity& c) {
      visibility.take(arena, c);
      const std::size_t depth_size =
          c.depth_bands == 1 ? std::size_t{c.width} * c.band_lines : stride<DepthWord>(c) * c.depth_bands;
      depth = arena.take<DepthWord>(Visibility::keeps_depth ? depth_size : 0);
      colour = arena.take<Pixel>(stride<Pixel>(c) * c.colour_bands);
    }
  };

  /// An empty drawer, which cannot draw until another is assigned to it.
  BandDrawer() = default;
  /// A drawer for pictures of this capacity in these pools.
  BandDrawer(const Capacity& capacity, const Pools& pools)
      : capacity_(capacity), pools_(pools), visibility_(pools.visibility) {}

  /// Draws the drawer's share of a frame. For each band it calls `sink.acquire(buffer)` if the sink has it, which waits
  /// until that colour band is free again; it draws the band; and it calls `sink(band)`. Either call may return false
  /// to abandon the frame. With a FillingSink, each band is cleared while the one above it is drawn.
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

  /// Begins a frame or a share of one.
  void start(const Scene& scene, BandShare share) {
    share_ = share;
    if (scene.counters != nullptr) scene.counters->names = Visibility::counter_names;
    visibility_.begin_frame(input(scene));
  }
  /// Whether a band belongs to the share.
  [[nodiscard]] bool draws(std::uint32_t band) const {
    return share_ == BandShare::all || (band & 1) == (share_ == BandShare::odd ? 1u : 0u);
  }
  /// Skips a band that another drawer draws.
  void skip_band(const Scene& scene, std::uint32_t band) {
    const std::int32_t y0 = first_line(band);
    visibility_.skip_band(scene.table, scene.shading, static_cast<std::int32_t>(band), viewport(),
                          {nullptr, nullptr, capacity_.width, y0 + row_bias, end_line(y0) + row_bias, {}});
  }
  /// Clears a band's colour and depth as far as the algorithm needs it.
  void clear_band(const Scene& scene, std::uint32_t band) {
    visibility_.clear(target(scene, band, band_view(band)),
                      [](auto value, std::uint32_t count, auto* words) { fill_constant(value, count, words); });
  }
  /// Starts to clear a band of the share ahead of its turn, by a FillingSink. False if the sink abandons the frame.
  template <class Sink>
  bool clear_ahead(const Scene& scene, std::uint32_t band, Sink& sink) {
    if (!sink.acquire(buffer_of(band))) return false;
    visibility_.clear(target(scene, band, band_view(band)),
                      [&](auto value, std::uint32_t count, auto* words) { sink.fill(value, count, words); });
    cleared_ = static_cast<std::uint16_t>(band);
    return true;
  }
  /// Forgets that a band was cleared ahead.
  void forget_clears() { cleared_ = none; }
  /// Draws a band that was cleared. Tells the sink which triangles cover a pixel centre, if the traits ask for
  /// statistics.
  template <class Sink>
  [[gnu::always_inline]] BandView draw_band(const Scene& scene, std::uint32_t band, Sink& sink) {
    const BandView view = band_view(band);
    const auto draw = [&](auto covered) {
      visibility_.draw_band(scene.table, scene.shading, static_cast<std::int32_t>(band), viewport(),
                            target(scene, band, view), covered);
    };
    if constexpr (requires { sink.covered(0u); })
      draw([&](std::uint32_t id) { sink.covered(id); });
    else
      draw([](std::uint32_t) {});
    return view;
  }
  /// Ends the frame; the status names a pool that ran full.
  Status end(const Scene& scene) {
    forget_clears();
    first_buffer_ = static_cast<std::uint8_t>(buffer_of(capacity_.bands()));
    const PoolShortage shortage = visibility_.shortage(input(scene));
    if (shortage.pool != Pool::none) return {Fault::pool_full, shortage.pool, shortage.wanted};
    return {};
  }

  /// The memory of a colour band; empty if there is no such band.
  [[nodiscard]] std::span<Pixel> colour_band(unsigned buffer) const {
    const std::size_t start = colour_start(buffer);
    if (start >= pools_.colour.size()) return {};
    return pools_.colour.subspan(start, std::size_t{capacity_.width} * capacity_.band_lines);
  }
  /// The capacity that the drawer was made for.
  [[nodiscard]] const Capacity& capacity() const { return capacity_; }
  /// Its memory.
  [[nodiscard]] const Pools& pools() const { return pools_; }
  /// The visibility algorithm, for its counters.
  [[nodiscard]] const Visibility& visibility() const { return visibility_; }

 private:
  [[nodiscard]] FrameInput input(const Scene& scene) const {
    return {scene.table, viewport(), capacity_.band_lines, scene.world};
  }
  static constexpr std::uint16_t none = 0xffff;

  /// Waits for a band's buffer and clears it.
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
  /// Number of the share's bands among the first `bands`.
  [[nodiscard]] std::uint32_t turns(std::uint32_t bands) const {
    return share_ == BandShare::all ? bands : (bands + (share_ == BandShare::even ? 1 : 0)) >> 1;
  }
  /// With up to two colour bands no remainder is computed: on Cortex-M0+ it is a function call for each band.
  [[nodiscard]] unsigned buffer_of(std::uint32_t band) const {
    const std::uint32_t turn = turns(band);
    if (capacity_.colour_bands <= 2) return turn & (capacity_.colour_bands - 1u);
    return (first_buffer_ + turn) % capacity_.colour_bands;
  }
  /// Index at which a colour band begins.
  [[nodiscard]] std::size_t colour_start(unsigned buffer) const {
    return std::size_t{buffer} * Pools::template stride<Pixel>(capacity_);
  }
  /// Index at which a band's depths begin.
  [[nodiscard]] std::size_t depth_start(std::uint32_t band) const {
    if (!Visibility::keeps_depth || capacity_.depth_bands == 1) return 0;
    return (turns(band) & 1) * Pools::template stride<DepthWord>(capacity_);
  }
  [[nodiscard]] BandView band_view(std::uint32_t band) const {
    const std::int32_t y0 = first_line(band), y1 = end_line(y0);
    const std::size_t count = std::size_t{capacity_.width} * static_cast<std::size_t>(y1 - y0);
    const unsigned buffer = buffer_of(band);
    return {y0, y1, pools_.colour.subspan(colour_start(buffer), count),
            pools_.depth.subspan(depth_start(band), Visibility::keeps_depth ? count : 0), buffer};
  }
  [[nodiscard]] typename Visibility::Target target(const Scene& scene, std::uint32_t band, const BandView& view) const {
    return {Visibility::keeps_depth ? pools_.depth.data() + depth_start(band) : nullptr,
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
  std::uint16_t cleared_ = none;   ///< number of the band that is being cleared ahead
  std::uint8_t first_buffer_ = 0;  ///< colour band of the frame's first band
  BandShare share_ = BandShare::all;
};

}  // namespace spanline
