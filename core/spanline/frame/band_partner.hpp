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

/// Draws the odd bands of a renderer's frames, for a second core: both draw at a time from one polygon table, and the
/// picture has the bytes that the renderer alone would give it, as long as no pool runs full.
///
/// Each core hands over its own bands; who puts them on a display in order has to wait for both. The renderer starts
/// no frame before both have returned. What a core has written by `take_frame` must be visible to the other one (a
/// barrier, and no cache between them).
template <class Traits>
class BandPartner {
 public:
  using Drawer = BandDrawer<Traits>;     ///< what draws its bands
  using Pixel = typename Drawer::Pixel;  ///< a word of the pixel format

  /// Bytes of the caller's memory, alignment included: a second set of bands, and where the algorithm takes the polygon
  /// table's buckets apart a copy of them.
  [[nodiscard]] static constexpr std::size_t bytes_needed(const Capacity& capacity) {
    Arena counting;
    Pools pools;
    pools.take(counting, capacity);
    return counting.size() + Arena::alignment - 1;
  }

  /// `status()` tells whether the memory was enough and the renderer is in order; if not, there is nothing to draw.
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

  /// Whether it can draw.
  [[nodiscard]] Status status() const { return status_; }

  /// Takes over the frame that the renderer holds, before either draws. Without one it says what the renderer would.
  Status take_frame() {
    frame_ = status_.ok() ? renderer_.frame_ : status_;
    if (!frame_.ok()) return frame_;
    table_ = renderer_.table_;
    if constexpr (copies) {
      std::copy_n(table_.references.begin(), table_.polygon_count, references_.begin());
      std::copy(table_.buckets.begin(), table_.buckets.end(), buckets_.begin());
      table_.references = references_;
      table_.buckets = buckets_;
    }
    counters_ = {};
    return {};
  }

  /// Draws the bands 1, 3, 5, … of the frame that was taken, once; the sink as for Renderer::draw, its colour bands the
  /// partner's own.
  template <class Sink>
  Status draw_odd(Sink&& sink) {
    if (!frame_.ok()) return frame_;
    frame_ = Fault::no_frame;
    return drawer_.draw(renderer_.scene(table_, counters_), BandShare::odd, sink);
  }

  /// As Renderer::colour_band, of the partner.
  [[nodiscard]] std::span<Pixel> colour_band(unsigned buffer) const { return drawer_.colour_band(buffer); }
  /// What visibility did in the odd bands, where the traits count it.
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
  Status frame_{Fault::no_frame};  ///< what keeps the frame from being drawn
};

}  // namespace spanline
