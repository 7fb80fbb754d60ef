#pragma once
/// @file
/// The spanning scan-line algorithm, after G. S. Watkins, "A Real Time Visible Surface Algorithm" (1970), and lecture
/// 002, "Spanning Scan Line Algorithm".
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <string_view>

#include "spanline/raster/fan_diagonals.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/raster/make_surface.hpp"
#include "spanline/raster/plane_equation.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/visibility/algorithm.hpp"
#include "spanline/visibility/band_target.hpp"
#include "spanline/visibility/counted_runs.hpp"
#include "spanline/visibility/covered_triangles.hpp"
#include "spanline/visibility/screen_surface.hpp"
#include "spanline/visibility/span/active_edge_table.hpp"
#include "spanline/visibility/span/layer_sweep.hpp"
#include "spanline/visibility/span/polygons_on_rows.hpp"
#include "spanline/visibility/span/row_sweep.hpp"
#include "spanline/visibility/span/sleep.hpp"
#include "spanline/visibility/span/spanning_counters.hpp"
#include "spanline/visibility/span/wake_bucket.hpp"

namespace spanline {

/// The spanning scan-line algorithm. It has no depth buffer: each row is cut into spans, visibility is decided once for
/// each span, and every pixel, also of the background, is written once. With 24-bit depths it draws the same bytes as
/// the z-buffer, since both compare the same plane words.
///
/// A polygon wakes in the bucket of its first row and sleeps while a nearer one is certain to hide it. If more polygons
/// are awake than there are records, the farthest are left out of the row (of equally far ones, the latest) and return
/// as soon as there is room.
///
/// Polygons of see-through shaders have their own active-edge table and are drawn over the visible spans (LayerSweep).
/// Lists without see-through shaders pay nothing. The records of see-through polygons come from the pool `layers`,
/// which may be smaller than the number of layers on a row. Then the layers with the nearest corners wait (of equally
/// near ones, the earliest), and the row is swept again for them, as many at a time as there are records. The picture
/// is exact if those that wait lie in front of the others.
template <class Depth, class Pixel, class Shaders, bool Counting>
class SpanningScanLine {
 public:
  using Surface = typename Shaders::Surface;
  using Target = BandTarget<Depth, Pixel>;

  /// Depths are written only when counting, for inspection. The algorithm does not read them.
  static constexpr AlgorithmNeeds needs = AlgorithmNeeds::screen_polygons;
  static constexpr bool takes_outlines = true;
  static constexpr bool keeps_depth = Counting, tests_depth = false, takes_table_apart = true, clears_ahead = true;

  using Counter = SpanningCounter;
  static constexpr auto& counter_names = spanning_counter_names;

  /// The record of an awake polygon, with its surface.
  struct Entry : AwakePolygon {
    Surface surface;
  };
  static constexpr bool has_layers = Shaders::see_through;

  struct LayerMemory {
    std::span<Entry> records;
    std::span<AwakeKey> keys;
  };
  struct NoLayerMemory {};

  /// The memory of the algorithm, cut off an arena.
  struct Memory {
    std::span<Entry> awake;
    std::span<AwakeKey> keys;
    [[no_unique_address]] std::conditional_t<has_layers, LayerMemory, NoLayerMemory> layers;

    constexpr void take(Arena& arena, const Capacity& capacity) {
      awake = arena.take<Entry>(capacity.awake);
      keys = arena.take<AwakeKey>(2 * (std::size_t{capacity.awake} + 2));
      if constexpr (has_layers) {
        layers.records = arena.take<Entry>(capacity.layers);
        layers.keys = arena.take<AwakeKey>(2 * (std::size_t{capacity.layers} + 2));
      }
    }
    /// Bytes of the records and keys of `count` awake polygons.
    [[nodiscard]] static constexpr std::size_t bytes(std::size_t count) {
      return count * sizeof(Entry) + 2 * (count + 2) * sizeof(AwakeKey);
    }
  };

  /// The greatest number of polygons, and of layers, that can be awake on a row: that of the records that keys can
  /// address.
  static constexpr auto most_awake =
      static_cast<std::uint32_t>(std::min<std::size_t>(awake_key::largest_offset / sizeof(Entry), ~std::uint32_t{0}));
  /// Whether keys can address the records of that many awake polygons.
  [[nodiscard]] static constexpr bool takes(const Capacity& capacity) {
    return capacity.awake <= most_awake && capacity.layers <= most_awake;
  }
  /// The polygon table's buckets hold one row each.
  [[nodiscard]] static constexpr std::uint32_t bucket_lines(const Capacity&) { return 1; }

  SpanningScanLine() = default;
  explicit SpanningScanLine(const Memory& memory) : memory_(memory) {}

  /// Before the first band of a frame.
  void begin_frame(const FrameInput& /*input*/) {
    table_.begin_frame(memory_.keys, reinterpret_cast<std::byte*>(memory_.awake.data()), memory_.awake.size(),
                       sizeof(Entry));
    overflowed_ = false;
    if constexpr (has_layers) {
      layers_.overflowed = false;
      layers_.table.begin_frame(memory_.layers.keys, reinterpret_cast<std::byte*>(memory_.layers.records.data()),
                                memory_.layers.records.size(), sizeof(Entry));
    }
  }

  /// Does nothing, since drawing writes the background where it is visible.
  template <class Fill>
  void clear(const Target&, Fill) {}

  /// Draws one band; bands come from top to bottom. `shading` is parallel to the table's groups. `covered(id)` is
  /// called for each polygon that covers a pixel centre, only when counting. Changes the table's buckets.
  template <class ShadingGroup, class Covered>
  [[gnu::noinline]] void draw_band(PolygonTable& table, std::span<const ShadingGroup> shading, std::int32_t,
                                   Viewport viewport, const Target& target, Covered&& covered) {
    Rows<ShadingGroup, Covered> rows{{table, viewport}, *this, shading.data(), target, covered};
    if constexpr (has_layers)
      rows.draw_with_layers();
    else
      rows.draw();
  }

  /// Steps over a band that another core draws. Only the rows and the width of `target` are used. No polygon is put to
  /// sleep in it.
  template <class ShadingGroup>
  void skip_band(PolygonTable& table, std::span<const ShadingGroup>, std::int32_t, Viewport viewport,
                 const Target& target) {
    const PolygonSource source{table, viewport};
    for (std::int32_t row = target.first_row - row_bias; row < target.end_row - row_bias; ++row) {
      if constexpr (has_layers) {
        const WokenWithLayers woken = wake_bucket(table_, layers_.table, source, row, margin);
        note(woken);
        defer_waiting(source, woken.waiting, row);
        static_cast<void>(layers_.table.step(source, row));
      } else if (!wake_bucket(table_, source, row, margin)) {
        overflowed_ = true;
      }
      static_cast<void>(table_.step(source, row));
    }
  }

  /// Tells whether a polygon found no record, and how many records suffice: as many as there are polygons on the
  /// fullest row.
  [[nodiscard]] PoolShortage shortage(const FrameInput& input) const {
    if (overflowed_) return {Pool::awake, polygons_on_rows(input.table, input.viewport)};
    if (layers_.overflowed) return {Pool::layers, polygons_on_rows(input.table, input.viewport, true)};
    return {};
  }
  void note_peaks(PoolPeaks& peaks) const {
    peaks.awake = Memory::bytes(table_.peak());
    if constexpr (has_layers) peaks.layers = Memory::bytes(layers_.table.peak());
  }

 private:
  void note(WokenWithLayers woken) {
    if (!woken.all_opaque) overflowed_ = true;
    if constexpr (has_layers) {
      if (woken.waiting != no_link) layers_.overflowed = true;
    }
  }
  static constexpr BoundMargin margin = depth_margin<Depth>;
  static_assert(margin.below % 256 == 0, "ActiveEdgeTable::evict takes the low bits of a bound for an outcode");

  struct LayerTable {
    ActiveEdgeTable table;
    bool overflowed = false;
  };
  struct NoLayerTable {
    static constexpr bool overflowed = false;
  };

  template <class ShadingGroup, class Covered>
  struct Rows : PolygonSource {
    using DepthFormat = Depth;
    static constexpr bool counting = Counting;
    static constexpr unsigned crossings_counter = Counter::crossings;

    SpanningScanLine& algorithm;
    const ShadingGroup* shading;
    const Target& target;
    Covered& covered;
    Pixel* line = nullptr;
    std::int32_t row = 0;
    [[no_unique_address]] std::conditional_t<has_layers, LayerSweep<Rows>*, NoLayerTable> layer_sweep{};
    bool drawn = false;  ///< the row's opaque pixels are drawn, and it is swept again for more layers

    /// Whether the row's opaque spans have been drawn already; constant false without layers.
    [[nodiscard]] bool again() const { return has_layers && drawn; }

    void draw() {
      ActiveEdgeTable& edges = algorithm.table_;
      RowSweep<Rows> sweep(*this, target.width);
      line = target.pixels;
      const std::int32_t end = target.end_row - row_bias;
      for (row = target.first_row - row_bias; row < end; ++row, line += target.width) {
        if (!wake_bucket(edges, *this, row, margin)) algorithm.overflowed_ = true;
        const std::uint32_t repairs = edges.step(*this, row);
        if constexpr (Counting) target.counters->own[Counter::order_repairs] += repairs;
        sweep.run(edges, row);
      }
    }

    /// As `draw`, for lists with see-through shaders.
    void draw_with_layers() {
      ActiveEdgeTable &edges = algorithm.table_, &layers = algorithm.layers_.table;
      RowSweep<Rows> sweep(*this, target.width);
      LayerSweep<Rows> over_spans(*this);
      layer_sweep = &over_spans;
      line = target.pixels;
      const std::int32_t end = target.end_row - row_bias;
      for (row = target.first_row - row_bias; row < end; ++row, line += target.width) {
        const WokenWithLayers woken = wake_bucket(edges, layers, *this, row, margin);
        algorithm.note(woken);
        const std::uint32_t repairs = edges.step(*this, row) + layers.step(*this, row);
        if constexpr (Counting) target.counters->own[Counter::order_repairs] += repairs;
        over_spans.begin_row(layers, row);
        sweep.run(edges, row);
        if (woken.waiting != no_link) lay_waiting(woken.waiting, sweep, over_spans);
      }
    }

    /// Sweeps the row again for layers that found no record, as many at a time as there are records. They lie in front
    /// of those that are drawn already.
    [[gnu::noinline]] void lay_waiting(Link waiting, RowSweep<Rows>& sweep, LayerSweep<Rows>& over_spans) {
      ActiveEdgeTable& layers = algorithm.layers_.table;
      if (!layers.has_records()) return defer_waiting(*this, waiting, row);
      drawn = true;
      while (waiting != no_link) {
        layers.stand_back(*this, row + 1);
        waiting = wake_waiting(layers, *this, waiting, row, margin);
        static_cast<void>(layers.step(*this, row));
        over_spans.begin_row(layers, row);
        sweep.run(algorithm.table_, row);
      }
      drawn = false;
    }

    // The functions that RowSweep calls.

    void background(std::int32_t begin, std::int32_t end) {
      if (!again()) {
        if constexpr (Counting) count_background(begin, end);
        Shaders::fill_apart(target.background, word(end - begin), line + begin);
      }
      lay_over(nullptr, begin, end);
    }

    [[gnu::always_inline]] void span(AwakePolygon& polygon, std::int32_t begin, std::int32_t end) {
      if (!again()) {
        if constexpr (Counting) count(polygon, begin, end);
        fill(polygon, begin, end);
      }
      lay_over(&polygon, begin, end);
    }

    void lay_over(AwakePolygon* polygon, std::int32_t begin, std::int32_t end) {
      if constexpr (has_layers) {
        if (layer_sweep->reaches(end)) layer_sweep->over(polygon, begin, end);
      }
    }

    [[gnu::always_inline]] void fill(AwakePolygon& polygon, std::int32_t begin, std::int32_t end) {
      Entry& entry = static_cast<Entry&>(polygon);
      const ShadingGroup& group = shading[entry.group];
      Shaders::with(group.shader, [&]<class Shader>() {
        if (!entry.has_surface) make_surface<Shader>(entry, group);
        auto& surface = entry.surface.template as<typename Shader::Surface>();
        if constexpr (Shader::interpolates || DividesOutlines<Shader>) {
          surface.skip_rows(row - entry.surface_row);
          entry.surface_row = static_cast<std::uint16_t>(row);
        }
        Shaders::fill(surface, begin, word(end - begin), line + begin);
      });
    }

    template <class Shader>
    [[gnu::noinline]] void make_surface(Entry& entry, const ShadingGroup& group) {
      auto* surface = new (entry.surface.bytes) typename Shader::Surface;
      entry.has_surface = true;
      entry.surface_row = 0;
      make_screen_surface<Shader>(*surface, group, this->entry(entry), entry.is_outline(), this->viewport);
    }

    // The functions that LayerSweep calls.

    [[gnu::noinline]] void layer(AwakePolygon& polygon, std::int32_t begin, std::int32_t end) {
      fill(polygon, begin, end);
      if constexpr (Counting) count_layer(polygon, begin, end);
    }

    void begins([[maybe_unused]] const AwakePolygon& polygon) {
      if constexpr (Counting) {
        if (again() && !this->table.groups[polygon.group].see_through) return;
        ++target.counters->own[Counter::decisions];
        tell_covered(polygon);
      }
    }

    /// Tells which triangles of a polygon cover a pixel of the row.
    void tell_covered(const AwakePolygon& polygon) {
      const PolygonEntry entry = this->entry(polygon);
      const std::uint32_t id = shading[polygon.group].first_id + entry.corners().triangle;
      if (!polygon.is_outline()) return covered(id);
      const AwakePolygon::Columns now = polygon.columns_below(0);
      FanDiagonals(entry.outline())
          .for_each_part({std::max<std::int32_t>(now.left, 0), polygon.right}, row,
                         [&](unsigned number, RowColumns) { covered(id + number); });
    }
    /// An outline that falls asleep may have triangles that begin while it sleeps.
    void tell_covered_asleep(const AwakePolygon& polygon) {
      const PolygonEntry entry = this->entry(polygon);
      if (polygon.is_outline())
        spanline::tell_covered(entry, this->viewport, row + row_bias,
                               shading[polygon.group].first_id + entry.corners().triangle, covered);
    }

    void hidden(AwakePolygon& polygon, const AwakePolygon& front) {
      if (polygon.turn_row - row <= polygon_sleep::least_rows || row < polygon.retry_row) return;
      [[maybe_unused]] const bool sleeps = polygon_sleep::fall_asleep(polygon, front, this->table, row, target.width);
      if constexpr (Counting) {
        target.counters->own[Counter::sleeps] += sleeps;
        if (sleeps) tell_covered_asleep(polygon);
      }
    }

    using Counted = CountedRuns<Depth, Target>;
    void count_background(std::int32_t begin, std::int32_t end) {
      target.counters->own[Counter::shaded] += word(end - begin);
      Counted(target, row).background({begin, end});
    }
    void count(AwakePolygon& polygon, std::int32_t begin, std::int32_t end) {
      target.counters->own[Counter::shaded] += word(end - begin);
      if (!polygon.has_plane) make_plane<Depth>(polygon, *this);
      Counted(target, row).opaque(polygon, {begin, end});
    }
    void count_layer(AwakePolygon& polygon, std::int32_t begin, std::int32_t end) {
      Entry& entry = static_cast<Entry&>(polygon);
      if (!polygon.has_plane) make_plane<Depth>(polygon, *this);
      Shaders::with(shading[entry.group].shader, [&]<class Shader>() {
        const auto& surface = entry.surface.template as<typename Shader::Surface>();
        Counted(target, row).template see_through<Shader>(polygon, surface, {begin, end});
      });
    }
  };

  Memory memory_{};
  ActiveEdgeTable table_;
  [[no_unique_address]] std::conditional_t<has_layers, LayerTable, NoLayerTable> layers_;
  bool overflowed_ = false;
};

/// The visibility algorithm of a renderer: the spanning scan line, without a depth buffer and exact with 24-bit depths.
struct Spanning {
  template <class Depth, class Pixel, class Shaders, bool Counting>
  using Algorithm = SpanningScanLine<Depth, Pixel, Shaders, Counting>;
};

}  // namespace spanline
