#pragma once
/// @file
/// The renderer.
///
/// ```cpp
/// #include <spanline/frame/ready_made_traits.hpp>
///
/// using Picture = Renderer<FlatTraits<>>;
/// constexpr Capacity size{.width = 320, .height = 240, .vertices = 8, .polygons = 6, .fans = 6, .active = 6};
/// alignas(8) static std::byte memory[Picture::bytes_needed(size)];
///
/// Status draw(const FrameSettings& settings, const Mesh& mesh) {
///   Picture renderer(size, memory);
///   if (const Status begun = renderer.begin(settings); !begun.ok()) return begun;
///   if (const Status added = renderer.add(mesh, {}, {.colour = {240, 160, 60}}); !added.ok()) return added;
///   return renderer.draw([](const auto& band) { return send(band.y0, band.y1, band.pixels); });
/// }
/// ```
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "spanline/frame/band_drawer.hpp"
#include "spanline/frame/frame_pools.hpp"
#include "spanline/frame/frame_settings.hpp"
#include "spanline/frame/statistics.hpp"
#include "spanline/frame/status.hpp"
#include "spanline/frame/submissions.hpp"
#include "spanline/frame/traits.hpp"
#include "spanline/memory/arena.hpp"
#include "spanline/memory/capacity.hpp"
#include "spanline/visibility/counters.hpp"
#include "spanline/world/submission_order.hpp"

namespace spanline {

template <class Traits>
class BandPartner;

/// The main interface of the library: it takes the instances of a frame and then draws the frame band by band.
///
/// It owns no memory and allocates none. The caller supplies `bytes_needed` bytes, and the tables of meshes and lights,
/// which must stay valid until `draw` has returned. Of surfaces at equal depth, the order of submission decides which
/// is seen.
template <class Traits>
class Renderer {
 public:
  using Depth = typename Traits::Depth;      ///< the format of depths
  using DepthWord = typename Depth::Word;    ///< a depth in the depth buffer
  using Format = typename Traits::Format;    ///< the pixel format
  using Pixel = typename Format::Pixel;      ///< a pixel in that format
  using Shaders = typename Traits::Shaders;  ///< the list of shaders
  /// What a sink receives: a Band of these words.
  using BandView = typename BandDrawer<Traits>::BandView;

  /// Bytes of the caller's memory that a configuration takes, alignment included.
  [[nodiscard]] static constexpr std::size_t bytes_needed(const Capacity& capacity) {
    Arena counting;
    FramePools<Traits> pools;
    typename BandDrawer<Traits>::Pools bands;
    pools.take(counting, capacity);
    bands.take(counting, capacity);
    return counting.size() + Arena::alignment - 1;
  }

  /// The status that a renderer would have with a configuration. It is bad_configuration if a size is out of its range,
  /// or if a pool has more entries than can be numbered; then it names the pool and its limit. The limit depends on the
  /// core and on the shaders: `Spanning` addresses its records by 16 bits on 32-bit cores.
  [[nodiscard]] static constexpr Status check(const Capacity& capacity) { return FramePools<Traits>::check(capacity); }
  /// Whether a renderer accepts a configuration, for checks of a constant one at compile time:
  ///
  ///     static_assert(Renderer<FlatTraits<>>::takes(capacity));
  [[nodiscard]] static constexpr bool takes(const Capacity& capacity) { return check(capacity).ok(); }

  /// Divides `memory` into pools. `status()` tells whether it sufficed and the capacity is valid; if not, the renderer
  /// refuses every frame.
  Renderer(const Capacity& capacity, std::span<std::byte> memory) : drawer_(capacity, {}) {
    status_ = check(capacity);
    Arena arena = Arena::aligned(memory);
    typename BandDrawer<Traits>::Pools bands;
    if (status_.ok()) {
      submissions_.take(arena, capacity);
      bands.take(arena, capacity);
      if (arena.overrun())
        status_ = {Fault::pool_full, Pool::memory, static_cast<std::uint32_t>(bytes_needed(capacity))};
    }
    if (!status_.ok()) {
      frame_ = status_;
      return;
    }
    drawer_ = BandDrawer<Traits>(capacity, bands);
  }

  /// Whether the memory sufficed and the capacity is valid.
  [[nodiscard]] Status status() const { return status_; }

  /// Starts a frame. If the settings are out of their ranges it returns a fault, and so do all further calls for this
  /// frame: nothing is added or drawn.
  Status begin(const FrameSettings& settings) {
    drawer_.forget_clears();
    submissions_.clear();
    counters_ = {};
    peaks_ = {};
    bands_in_turn_ = 0;
    spent_ = false;
    frame_ = status_.ok() ? check_settings(settings) : status_;
    if (!frame_.ok()) return frame_;
    background_ = Format::from(settings.background);
    submissions_.begin(settings);
    return {};
  }

  /// Adds an instance of a validated mesh; the Mesh object itself must stay valid until `draw` has returned. If no
  /// shader can draw the instance it is left out, and the status names the missing shader. If a pool is full, what fits
  /// is kept, and the status names the pool and the size that the frame has needed so far.
  Status add(const Mesh& mesh, const Transform& transform, const Material& material) {
    if (!frame_.ok()) return frame_;
    return submissions_.add(mesh, transform, material);
  }

  /// Adds instances, or parts of them, in the sequence of a submission order (world/submission_order.hpp). Triangles
  /// are numbered by the list of instances, whatever the order. What does not fit is left out and the rest is added.
  /// The status is that of the first instance that did not fit, or `bad_order` for an instance or polygons that do not
  /// exist.
  template <SubmissionOrder Order>
  Status add_in_order(Order&& order, std::span<const OrderedInstance> instances) {
    if (!frame_.ok()) return frame_;
    return submissions_.add_in_order(order, instances);
  }

  /// Adds triangles in screen coordinates: three corners each, with outcodes set where they lie outside the viewport,
  /// and an RGB565 colour each. Both tables must stay valid until `draw` has returned. The triangles are flat and take
  /// neither light, fog nor dither. At most 32,767 triangles a call on 32-bit cores.
  Status add_screen(std::span<const ScreenVertex> vertices, std::span<const std::uint16_t> colours) {
    static constexpr Material opaque{};  // static, so that it is not built on every call
    return add_screen(vertices, colours, opaque);
  }
  /// The same with the opacity and the transparency of a material; nothing else of the material is used.
  Status add_screen(std::span<const ScreenVertex> vertices, std::span<const std::uint16_t> colours,
                    const Material& material) {
    if (!frame_.ok()) return frame_;
    return submissions_.add_screen(vertices, colours, material);
  }
  /// The same for convex polygons with a colour each. `corners` counts those of each polygon, as Mesh::corners does: a
  /// marked polygon has the plane of its reference triangle (docs/conventions.md). `vertices` has that many in all, at
  /// most 65,534 on 32-bit cores.
  Status add_screen(std::span<const ScreenVertex> vertices, std::span<const std::uint8_t> corners,
                    std::span<const std::uint16_t> colours, const Material& material) {
    if (!frame_.ok()) return frame_;
    return submissions_.add_screen(vertices, corners, colours, material);
  }

  /// With a FillingSink, between `begin` and `draw`: starts to clear the first band while instances are added. Returns
  /// false if the sink abandons the frame; `draw` will then fail too.
  template <class Sink>
  bool clear_ahead(Sink&& sink) {
    return !frame_.ok() || drawer_.clear_ahead(scene(), 0, sink);
  }

  /// Draws the frame from top to bottom. For each band it calls `sink.acquire(buffer)` if the sink has it, which waits
  /// until that colour band is free again; it draws the band; and it calls `sink(band)`. Either call may return false
  /// to abandon the frame. With statistics, `sink.covered(id)` is called for every triangle that covers a pixel centre,
  /// if the sink has it. `Spanning` takes the frame's polygons apart, so it draws a frame once: what would draw it
  /// again returns `no_frame`. The z-buffers draw a frame as often as they are asked to.
  template <class Sink>
  Status draw(Sink&& sink) {
    return draw_share(BandShare::all, sink);
  }
  /// Draws only the bands 0, 2, 4, …, while a BandPartner draws the others.
  template <class Sink>
  Status draw_even(Sink&& sink) {
    return draw_share(BandShare::even, sink);
  }

  /// The steps of `draw`, for programs with their own loop, such as benchmarks: start; then clear and draw each band in
  /// order; then end. A step without a frame, before `start_bands`, or for a band outside the picture does nothing and
  /// returns a fault; the view of such a band is empty.
  Status start_bands() {
    if (const Status can_draw = take_turn(); !can_draw.ok()) return can_draw;
    drawer_.start(scene(), BandShare::all);
    return {};
  }
  /// Clears a band in [0, `capacity().bands()`) before it is drawn.
  Status clear_band(std::uint32_t band) {
    if (band >= bands_in_turn_) [[unlikely]]
      return frame_.ok() ? Status{Fault::bad_step} : frame_;
    drawer_.clear_band(scene(), band);
    return {};
  }
  /// Draws a band that was cleared. Of the sink, only `covered` is called.
  template <class Sink>
  [[gnu::always_inline]] BandView draw_band(std::uint32_t band, Sink& sink) {
    if (band >= bands_in_turn_) [[unlikely]]
      return {};
    return drawer_.draw_band(scene(), band, sink);
  }
  /// Ends a frame that was drawn by steps, or that the sink of `draw` abandoned. The status names a pool that ran full.
  Status end_bands() {
    if (!frame_.ok()) return frame_;
    if (bands_in_turn_ == 0) return Fault::bad_step;
    bands_in_turn_ = 0;
    note_peaks();
    return drawer_.end(scene());
  }

  /// The memory of colour band `buffer`, from 0, for present loops that hand it to a display; empty if there is no such
  /// band. Frames use the colour bands in turn; with three or more, the next frame continues after the last one used.
  [[nodiscard]] std::span<Pixel> colour_band(unsigned buffer) const { return drawer_.colour_band(buffer); }
  /// Counts of the frame so far; complete once `draw` has returned.
  [[nodiscard]] Statistics statistics() const {
    if constexpr (Traits::statistics) return {submissions_.counts(), counters_};
    return {submissions_.counts(), {}};
  }
  /// Bytes of each pool that the last frame used.
  [[nodiscard]] const PoolPeaks& peaks() const { return peaks_; }
  /// The capacity that the renderer was made for.
  [[nodiscard]] const Capacity& capacity() const { return drawer_.capacity(); }

 private:
  friend class BandPartner<Traits>;
  struct NoCounters {};
  using Counters = std::conditional_t<Traits::statistics, VisibilityCounters, NoCounters>;
  using Visibility = typename BandDrawer<Traits>::Visibility;

  [[nodiscard]] BandScene<Pixel> scene() { return scene(submissions_.table(), counters_); }
  [[nodiscard]] BandScene<Pixel> scene(PolygonTable& table, Counters& counters) const {
    BandScene<Pixel> scene{table, submissions_.shading(), background_, nullptr, submissions_.world()};
    if constexpr (Traits::statistics) scene.counters = &counters;
    return scene;
  }
  /// Whether the frame can be drawn now; if so, it counts as drawn.
  Status take_turn() {
    if (!frame_.ok()) return frame_;
    if (Visibility::takes_table_apart && spent_) return Fault::no_frame;
    spent_ = true;
    bands_in_turn_ = capacity().bands();
    return {};
  }
  template <class Sink>
  Status draw_share(BandShare share, Sink& sink) {
    if (const Status can_draw = take_turn(); !can_draw.ok()) return can_draw;
    const Status drawn = drawer_.draw(scene(), share, sink);
    if (drawn.fault == Fault::sink_failed) return drawn;
    bands_in_turn_ = 0;
    note_peaks();
    return drawn;
  }

  void note_peaks() {
    peaks_ = submissions_.taken();
    peaks_.colour_bands = drawer_.pools().colour.size_bytes();
    peaks_.depth_band = Visibility::tests_depth ? drawer_.pools().depth.size_bytes() : 0;
    drawer_.visibility().note_peaks(peaks_);
  }

  BandDrawer<Traits> drawer_;
  Status status_{};                  ///< of the capacity and the memory
  Status frame_{Fault::no_frame};    ///< why the frame cannot be added to and drawn, or ok
  bool spent_ = false;               ///< the frame has been drawn, or begun to be
  std::uint32_t bands_in_turn_ = 0;  ///< all of them between start_bands and end_bands
  Pixel background_{};
  Submissions<Traits> submissions_;
  [[no_unique_address]] Counters counters_{};
  PoolPeaks peaks_{};
};

}  // namespace spanline
