#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>

#include "spanline/raster/plane_equation.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/visibility/band_target.hpp"
#include "spanline/visibility/span/active_edge_table.hpp"
#include "spanline/visibility/span/polygons_on_rows.hpp"
#include "spanline/visibility/span/row_sweep.hpp"
#include "spanline/visibility/span/sleep.hpp"
#include "spanline/visibility/span/wake_bucket.hpp"

namespace spanline {

/// The spanning scan-line algorithm (lecture 002, "Spanning Scan Line Algorithm"): no depth buffer; each row is cut
/// into spans, each span is decided once, and every pixel is shaded once, the background's as well. At 24 bits it draws
/// the bytes of the z-buffer, since both compare the same plane words.
///
/// Polygons wake in the bucket of their first row, and sleep while a nearer one is certain to hide them. Where more are
/// awake than there are records, the farthest are left out of the row, of equally far ones the latest, and come back as
/// soon as there is room.
template <class Depth, class Pixel, class Shaders, bool Counting>
class SpanningScanLine {
 public:
  using Surface = typename Shaders::Surface;
  using Target = BandTarget<Depth, Pixel>;

  /// Depths are kept for Counting alone, for others to look at: nothing here reads them.
  static constexpr bool keeps_depth = Counting, tests_depth = false;

  struct Entry : AwakePolygon {
    Surface surface;
  };

  /// The memory of the algorithm, cut off an arena.
  struct Memory {
    std::span<Entry> active;
    std::span<AwakeKey> keys;

    template <class Arena, class Capacity>
    constexpr void take(Arena& arena, const Capacity& capacity) {
      active = arena.template take<Entry>(capacity.active);
      keys = arena.template take<AwakeKey>(2 * (std::size_t{capacity.active} + 2));
    }
    /// Bytes of `count` awake polygons.
    [[nodiscard]] static constexpr std::size_t bytes(std::size_t count) {
      return count * sizeof(Entry) + 2 * (count + 2) * sizeof(AwakeKey);
    }
  };

  /// Whether keys can address that many awake polygons.
  template <class Capacity>
  [[nodiscard]] static constexpr bool takes(const Capacity& capacity) {
    return std::size_t{capacity.active} * sizeof(Entry) <= awake_key::largest_offset;
  }
  /// The polygon table's buckets hold one row each.
  template <class Capacity>
  [[nodiscard]] static constexpr std::uint32_t bucket_lines(const Capacity&) {
    return 1;
  }

  SpanningScanLine() = default;
  explicit SpanningScanLine(const Memory& memory) : memory_(memory) {}

  /// Before the first band of a frame.
  void begin_frame() {
    table_.begin_frame(memory_.keys, reinterpret_cast<std::byte*>(memory_.active.data()), memory_.active.size(),
                       sizeof(Entry));
    overflowed_ = false;
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
    rows.draw();
  }

  [[nodiscard]] bool overflowed() const { return overflowed_; }
  /// Polygons awake at most.
  [[nodiscard]] std::uint32_t peak() const { return table_.peak(); }
  /// How many awake polygons the frame would have had room for at most.
  [[nodiscard]] static std::uint32_t wanted(const PolygonTable& table, Viewport viewport, std::int32_t) {
    return polygons_on_rows(table, viewport);
  }

 private:
  /// Bounds keep clear of the plane's rounding: at most half a guard unit a pixel of the way from the anchor, which the
  /// largest picture makes 1,024, and 2 units of 24-bit depth or 1 of 16-bit depth for fast set-ups.
  static constexpr std::uint32_t depth_unit = 1u << Depth::guard_bits;
  static constexpr BoundMargin margin{depth_unit + 2048, 2 * depth_unit + 2048};
  static_assert(margin.below % 256 == 0, "ActiveEdgeTable::evict takes the low bits of a bound for an outcode");

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

    void draw() {
      ActiveEdgeTable& edges = algorithm.table_;
      RowSweep<Rows> sweep(*this, target.width);
      line = target.pixels;
      const std::int32_t end = target.end_row - row_bias;
      for (row = target.first_row - row_bias; row < end; ++row, line += target.width) {
        if (!wake_bucket(edges, *this, row, margin)) algorithm.overflowed_ = true;
        const std::uint32_t repairs = edges.step(*this, row);
        if constexpr (Counting) target.counters->order_repairs += repairs;
        sweep.run(edges, row);
      }
    }

    // What RowSweep asks of its owner.

    void background(std::int32_t begin, std::int32_t end) {
      if constexpr (Counting) count_background(begin, end);
      Shaders::fill_apart(target.background, word(end - begin), line + begin);
    }

    [[gnu::always_inline]] void span(AwakePolygon& polygon, std::int32_t begin, std::int32_t end) {
      if constexpr (Counting) count(polygon, begin, end);
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

    void begins([[maybe_unused]] const AwakePolygon& polygon) {
      if constexpr (Counting) {
        ++target.counters->decisions;
        covered(shading[polygon.group].first_id + this->corners(polygon).triangle);
      }
    }

    void hidden(AwakePolygon& polygon, const AwakePolygon& front) {
      if (polygon.turn_row - row <= polygon_sleep::least_rows || row < polygon.retry_row) return;
      [[maybe_unused]] const bool sleeps = polygon_sleep::fall_asleep(polygon, front, this->table, row, target.width);
      if constexpr (Counting) target.counters->sleeps += sleeps;
    }

    [[nodiscard]] typename Depth::Word* depth_line() const { return target.depth + (line - target.pixels); }
    void count_background(std::int32_t begin, std::int32_t end) {
      target.counters->shaded += word(end - begin);
      std::fill(depth_line() + begin, depth_line() + end, Depth::clear);
    }
    void count(AwakePolygon& polygon, std::int32_t begin, std::int32_t end) {
      ++target.counters->spans;
      target.counters->pixels += word(end - begin);
      target.counters->shaded += word(end - begin);
      if (!polygon.has_plane) make_plane<Depth>(polygon, *this);
      for (std::int32_t column = begin; column < end; ++column) {
        const std::uint32_t plane_word = polygon.depth_at(column, row);
        depth_line()[column] =
            static_cast<typename Depth::Word>(Depth::stored(Depth::smaller ? plane_word : ~plane_word));
      }
    }
  };

  Memory memory_{};
  ActiveEdgeTable table_;
  bool overflowed_ = false;
};

/// Visibility of a renderer: the spanning scan-line algorithm. No depth buffer; exact at 24 bits.
struct Spanning {
  template <class Depth, class Pixel, class Shaders, bool Counting>
  using Algorithm = SpanningScanLine<Depth, Pixel, Shaders, Counting>;
};

}  // namespace spanline
