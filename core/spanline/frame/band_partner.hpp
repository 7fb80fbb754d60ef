#pragma once
/// @file
/// Frames that two cores share.
///
/// ```cpp
/// #include <spanline/frame/ready_made_traits.hpp>
///
/// using Traits = FlatTraits<>;
///
/// Status first_core(Renderer<Traits>& picture, BandPartner<Traits>& partner, const FrameSettings& settings,
///                   const Mesh& mesh) {
///   if (const Status begun = picture.begin(settings); !begun.ok()) return begun;
///   if (const Status added = picture.add(mesh, {}, {}); !added.ok()) return added;
///   if (const Status taken = partner.take_frame(); !taken.ok()) return taken;
///   // Now the other core is told to draw.
///   return picture.draw_even([](const auto& band) { return send(band.y0, band.y1, band.pixels); });
/// }
/// Status second_core(BandPartner<Traits>& partner) {
///   return partner.draw_odd([](const auto& band) { return send(band.y0, band.y1, band.pixels); });
/// }
/// ```
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/frame/renderer.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/visibility/counters.hpp"

namespace spanline {

/// Draws the odd bands of a renderer's frames on a second core. Both cores draw at the same time from one polygon
/// table, and the picture is bit-identical to that of the renderer alone, as long as no pool runs full.
///
/// Each core hands over its own bands; a program that needs them in order has to wait for both cores. The renderer must
/// not start a frame before both have returned. What a core has written when it calls `take_frame` must be visible to
/// the other core, which takes a barrier and no cache between them.
template <class Traits>
class BandPartner {
 public:
  using Drawer = BandDrawer<Traits>;     ///< draws the partner's bands
  using Pixel = typename Drawer::Pixel;  ///< a pixel in the pixel format

  /// Bytes of the caller's memory that a partner takes, alignment included: its own bands, and a copy of the polygon
  /// table's buckets if the algorithm consumes them.
  [[nodiscard]] static constexpr std::size_t bytes_needed(const Capacity& capacity) {
    Arena counting;
    Pools pools;
    pools.take(counting, capacity);
    return counting.size() + Arena::alignment - 1;
  }

  /// `status()` tells whether the memory sufficed and the renderer is usable; if not, the partner draws nothing.
  BandPartner(Renderer<Traits>& renderer, std::span<std::byte> memory) : renderer_(renderer) {
    const Capacity& capacity = renderer.capacity();
    status_ = renderer.status();
    if (!status_.ok()) return;
    Arena arena = Arena::aligned(memory);
    Pools pools;
    pools.take(arena, capacity);
    if (arena.overrun()) {
      status_ = {Fault::pool_full, Pool::memory, static_cast<std::uint32_t>(bytes_needed(capacity))};
      return;
    }
    drawer_ = Drawer(capacity, pools.bands);
    references_ = pools.references;
    buckets_ = pools.buckets;
  }

  /// Whether the partner can draw.
  [[nodiscard]] Status status() const { return status_; }

  /// Takes over the renderer's current frame, before either core draws. If there is none, or the renderer has taken it
  /// apart already, it returns what the renderer would.
  Status take_frame() {
    frame_ = status_.ok() ? renderer_.frame_ : status_;
    if (frame_.ok() && copies && renderer_.spent_) frame_ = Fault::no_frame;
    if (!frame_.ok()) return frame_;
    table_ = renderer_.submissions_.table();
    if constexpr (copies) {
      std::copy_n(table_.references.begin(), table_.polygon_count, references_.begin());
      std::copy(table_.buckets.begin(), table_.buckets.end(), buckets_.begin());
      table_.references = references_;
      table_.buckets = buckets_;
    }
    counters_ = {};
    return {};
  }

  /// Draws the bands 1, 3, 5, … of the frame that was taken, once. The sink is the same as for Renderer::draw; the
  /// colour bands are the partner's own.
  template <class Sink>
  Status draw_odd(Sink&& sink) {
    if (!frame_.ok()) return frame_;
    frame_ = Fault::no_frame;
    return drawer_.draw(renderer_.scene(table_, counters_), BandShare::odd, sink);
  }

  /// The memory of one of the partner's colour bands, as Renderer::colour_band.
  [[nodiscard]] std::span<Pixel> colour_band(unsigned buffer) const { return drawer_.colour_band(buffer); }
  /// Counters of the odd bands, if the traits ask for statistics.
  [[nodiscard]] VisibilityCounters counters() const {
    if constexpr (Traits::statistics) return counters_;
    return {};
  }

 private:
  static constexpr bool copies = Drawer::Visibility::takes_table_apart;
  struct Pools {
    typename Drawer::Pools bands;
    std::span<PolygonReference> references;
    std::span<Link> buckets;

    constexpr void take(Arena& arena, const Capacity& c) {
      bands.take(arena, c);
      references = arena.take<PolygonReference>(copies ? c.polygons : 0);
      buckets = arena.take<Link>(copies ? FramePools<Traits>::bucket_count(c) : 0);
    }
  };

  Renderer<Traits>& renderer_;
  Status status_{};
  Drawer drawer_{};
  PolygonTable table_{};
  std::span<PolygonReference> references_;
  std::span<Link> buckets_;
  [[no_unique_address]] typename Renderer<Traits>::Counters counters_{};
  Status frame_{Fault::no_frame};  ///< why the frame cannot be drawn, or ok
};

}  // namespace spanline
