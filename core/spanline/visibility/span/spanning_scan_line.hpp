#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <string_view>

#include "spanline/raster/link.hpp"
#include "spanline/raster/make_surface.hpp"
#include "spanline/raster/plane_equation.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/raster/surface_blocks.hpp"
#include "spanline/visibility/algorithm.hpp"
#include "spanline/visibility/band_target.hpp"
#include "spanline/visibility/span/active_edge_table.hpp"
#include "spanline/visibility/span/layer_sweep.hpp"
#include "spanline/visibility/span/polygons_on_rows.hpp"
#include "spanline/visibility/span/row_sweep.hpp"
#include "spanline/visibility/span/sleep.hpp"
#include "spanline/visibility/span/spanning_counters.hpp"
#include "spanline/visibility/span/wake_bucket.hpp"

namespace spanline {

/// The spanning scan-line algorithm (lecture 002, "Spanning Scan Line Algorithm"): no depth buffer; each row is cut
/// into spans, each span is decided once, and every pixel is shaded once, the background's as well. At 24 bits it draws
/// the bytes of the z-buffer, since both compare the same plane words.
///
/// Polygons wake in the bucket of their first row, and sleep while a nearer one is certain to hide them. Where more are
/// awake than there are records, the farthest are left out of the row, of equally far ones the latest, and come back as
/// soon as there is room.
///
/// Where the list of shaders has see-through ones, their polygons wake in a table of their own and are laid over the
/// visible spans (LayerSweep); other lists are none the worse for it. Their records are a pool of their own, `layers`,
/// which may be smaller than the number of layers on a row: the nearest wait then, and the row is swept again
/// for them, as many at a time as there are records. That is right where those that wait lie before those that do not;
/// the order is that of the nearest corner, of equally near ones the later first.
template <class Depth, class Pixel, class Shaders, bool Counting>
class SpanningScanLine {
 public:
  using Surface = typename Shaders::Surface;
  using Target = BandTarget<Depth, Pixel>;

  /// Depths are kept for Counting alone, for others to look at: nothing here reads them.
  static constexpr AlgorithmNeeds needs = AlgorithmNeeds::screen_polygons;
  static constexpr bool keeps_depth = Counting, tests_depth = false, takes_table_apart = true, clears_ahead = true;

  using Counter = SpanningCounter;
  static constexpr auto& counter_names = spanning_counter_names;

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
    /// Bytes of `count` awake polygons.
    [[nodiscard]] static constexpr std::size_t bytes(std::size_t count) {
      return count * sizeof(Entry) + 2 * (count + 2) * sizeof(AwakeKey);
    }
  };

  /// Whether keys can address that many awake polygons.
  [[nodiscard]] static constexpr bool takes(const Capacity& capacity) {
    const std::size_t most = capacity.awake > capacity.layers ? capacity.awake : capacity.layers;
    return most * sizeof(Entry) <= awake_key::largest_offset;
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

  /// Nothing: the background is drawn where it shows.
  template <class Fill>
  void clear(const Target&, Fill) {}

  /// Draws one band; bands come from top to bottom. `shading` is parallel to the table's groups; `covered(id)` is told
  /// of each polygon that covers a pixel centre (for Counting only). Takes the table's buckets apart.
  template <class ShadingGroup, class Covered>
  [[gnu::noinline]] void draw_band(PolygonTable& table, std::span<const ShadingGroup> shading, std::int32_t,
                                   Viewport viewport, const Target& target, Covered&& covered) {
    Rows<ShadingGroup, Covered> rows{{table, viewport}, *this, shading.data(), target, covered};
    if constexpr (has_layers)
      rows.draw_with_layers();
    else
      rows.draw();
  }

  /// Steps over a band that somebody else draws; of its target, rows and width count. Nothing falls asleep in it.
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

  /// Polygons that found no record: those of a row are all that a pool has to hold at most.
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
  /// Bounds keep clear of the plane's rounding: at most half a guard unit a pixel of the way from the anchor, which the
  /// largest picture makes 1,024, and 2 units of 24-bit depth or 1 of 16-bit depth for fast set-ups.
  static constexpr std::uint32_t depth_unit = 1u << Depth::guard_bits;
  static constexpr BoundMargin margin{depth_unit + 2048, 2 * depth_unit + 2048};
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

    SpanningScanLine& algorithm;
    const ShadingGroup* shading;
    const Target& target;
    Covered& covered;
    Pixel* line = nullptr;
    std::int32_t row = 0;
    [[no_unique_address]] std::conditional_t<has_layers, LayerSweep<Rows>*, NoLayerTable> layer_sweep{};
    bool drawn = false;  ///< the row's opaque pixels, which is swept again for further layers

    /// Whether spans were drawn before; never without layers.
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

    /// The same for lists with see-through shaders.
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

    /// The row again for layers that found no record: they lie over those that did, as many at a time as there are
    /// records.
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

    // What RowSweep asks of its owner.

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
        if constexpr (Shader::interpolates) {
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
      if constexpr (Shader::interpolates) {
        spanline::make_surface<Shader>(*surface, group, this->corners(entry), this->plane_equation(entry));
        entry.surface_row = 0;
      } else {
        Shader::make(*surface, group, this->corners(entry));
      }
    }

    // What LayerSweep asks of its owner.

    [[gnu::noinline]] void layer(AwakePolygon& polygon, std::int32_t begin, std::int32_t end) {
      fill(polygon, begin, end);
      if constexpr (Counting) count_layer(polygon, begin, end);
    }

    void begins([[maybe_unused]] const AwakePolygon& polygon) {
      if constexpr (Counting) {
        if (again() && !this->table.groups[polygon.group].see_through) return;
        ++target.counters->own[Counter::decisions];
        covered(shading[polygon.group].first_id + this->corners(polygon).triangle);
      }
    }

    void hidden(AwakePolygon& polygon, const AwakePolygon& front) {
      if (polygon.turn_row - row <= polygon_sleep::least_rows || row < polygon.retry_row) return;
      [[maybe_unused]] const bool sleeps = polygon_sleep::fall_asleep(polygon, front, this->table, row, target.width);
      if constexpr (Counting) target.counters->own[Counter::sleeps] += sleeps;
    }

    [[nodiscard]] typename Depth::Word* depth_line() const { return target.depth + (line - target.pixels); }
    void count_background(std::int32_t begin, std::int32_t end) {
      target.counters->own[Counter::shaded] += word(end - begin);
      std::fill(depth_line() + begin, depth_line() + end, Depth::clear);
    }
    /// Depths are those of opaque pixels, as a z-buffer keeps them.
    void count_layer(AwakePolygon& polygon, std::int32_t begin, std::int32_t end) {
      ++target.counters->spans;
      Entry& entry = static_cast<Entry&>(polygon);
      if (!polygon.has_plane) make_plane<Depth>(polygon, *this);
      Shaders::with(shading[entry.group].shader, [&]<class Shader>() {
        if constexpr (SurfaceInBlocks<typename Shader::Surface>) {
          const auto& surface = entry.surface.template as<typename Shader::Surface>();
          bool keeps_depth_of_others = false;
          if constexpr (SeeThrough<Shader>) keeps_depth_of_others = surface.blends();
          std::int32_t column = begin;
          for_each_pixel(surface.blocks(begin), word(end - begin), [&]<class Source>(const Source& source) {
            const std::int32_t here = column++;
            if constexpr (SourceWithHoles<Source>) {
              if (!source.present()) return;
            }
            ++target.counters->pixels;
            if (!keeps_depth_of_others) put_depth(polygon, here);
          });
        }
      });
    }
    void put_depth(const AwakePolygon& polygon, std::int32_t column) {
      const std::uint32_t plane_word = polygon.depth_at(column, row);
      depth_line()[column] =
          static_cast<typename Depth::Word>(Depth::stored(Depth::smaller ? plane_word : ~plane_word));
    }
    void count(AwakePolygon& polygon, std::int32_t begin, std::int32_t end) {
      ++target.counters->spans;
      target.counters->pixels += word(end - begin);
      target.counters->own[Counter::shaded] += word(end - begin);
      if (!polygon.has_plane) make_plane<Depth>(polygon, *this);
      for (std::int32_t column = begin; column < end; ++column) put_depth(polygon, column);
    }
  };

  Memory memory_{};
  ActiveEdgeTable table_;
  [[no_unique_address]] std::conditional_t<has_layers, LayerTable, NoLayerTable> layers_;
  bool overflowed_ = false;
};

/// Visibility of a renderer: the spanning scan-line algorithm. No depth buffer; exact at 24 bits.
struct Spanning {
  template <class Depth, class Pixel, class Shaders, bool Counting>
  using Algorithm = SpanningScanLine<Depth, Pixel, Shaders, Counting>;
};

}  // namespace spanline
