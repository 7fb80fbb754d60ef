#pragma once
/// @file
/// The painter's algorithm, lecture 003, "The Painter's Algorithm", and lecture 000.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "spanline/raster/band_of_row.hpp"
#include "spanline/visibility/algorithm.hpp"
#include "spanline/visibility/sort/ordered_rows.hpp"
#include "spanline/visibility/sort/screen_extent.hpp"
#include "spanline/visibility/sort/sort_by_depth.hpp"
#include "spanline/visibility/sort/sorted_bands.hpp"

namespace spanline {

/// The painter's algorithm: polygons are sorted once a frame by the depth of their farthest corner and drawn from back
/// to front, in bands. It compares no depths of pixels, so it is right where no two polygons that overlap on screen
/// overlap in depth, as in scenes of polygons of constant depth ("2½D"). There it draws the z-buffer's bytes: of
/// equally far polygons, the one that was submitted first is drawn last.
///
/// See-through polygons are blended in their turn, so it needs no pool for them. Each band's polygons are those that
/// continue from the band above, merged with those that begin in it.
template <class Depth, class Pixel, class Shaders, bool Counting>
class PaintersAlgorithm {
  struct Entry {
    std::uint32_t farthest;  ///< depth word of the farthest corner
    std::uint16_t first_row, end_row;
    Link next;
  };
  using Drawn = DrawnPolygon<Shaders>;

 public:
  using Target = BandTarget<Depth, Pixel>;

  static constexpr AlgorithmNeeds needs = AlgorithmNeeds::screen_polygons;
  static constexpr bool takes_outlines = true;
  /// Depths are written only when counting, for inspection.
  static constexpr bool keeps_depth = Counting, tests_depth = false, takes_table_apart = false, clears_ahead = true;
  static constexpr std::span<const std::string_view> counter_names{};

  /// The memory of the algorithm, cut off an arena.
  struct Memory {
    std::span<Entry> entries;  ///< one for each polygon
    std::span<Link> bands;     ///< the farthest polygon that begins in each band
    std::span<Link> queues;    ///< for sorting
    std::span<Drawn> drawn;    ///< the polygon that is being drawn

    constexpr void take(Arena& arena, const Capacity& capacity) {
      entries = arena.take<Entry>(capacity.polygons);
      bands = arena.take<Link>(capacity.bands());
      queues = arena.take<Link>(radix_queues);
      drawn = arena.take<Drawn>(1);
    }
  };

  [[nodiscard]] static constexpr bool takes(const Capacity&) { return true; }
  /// The polygon table's buckets are not used.
  [[nodiscard]] static constexpr std::uint32_t bucket_lines(const Capacity& capacity) { return capacity.height; }

  PaintersAlgorithm() = default;
  explicit PaintersAlgorithm(const Memory& memory) : memory_(memory) {}

  /// Sorts the frame's polygons.
  void begin_frame(const FrameInput& input) {
    continuing_ = no_link;
    polygon_count_ = input.table.polygon_count;
    Link first = no_link;
    for_each_from_the_last(input.table, [&](Link number, const PolygonGroup& group) {
      std::int32_t top = ScreenVertex::bias * 2, bottom = 0;
      std::uint32_t farthest = 0;
      for_each_corner(
          {input.table, group, number}, [&](const ScreenVertex& corner) __attribute__((always_inline)) {
            const std::int32_t y = corner.y;
            top = y < top ? y : top;
            bottom = y > bottom ? y : bottom;
            farthest = corner.depth_word > farthest ? corner.depth_word : farthest;
          });
      const std::int32_t height = input.viewport.height;
      const std::int32_t first_row = std::max<std::int32_t>(row_at(top) - row_bias, 0),
                         end_row = std::min(row_at(bottom) - row_bias, height);
      if (first_row >= end_row) return;
      constexpr std::uint32_t outcodes = 0xff;
      memory_.entries[number] = {farthest & ~outcodes, static_cast<std::uint16_t>(first_row),
                                 static_cast<std::uint16_t>(end_row), first};
      first = number;
    });
    constexpr unsigned depth_bytes = 3;  // above the outcode
    first = sort_by_bytes(memory_.entries.data(), first, depth_bytes, memory_.queues,
                          [](const Entry& entry, unsigned pass) { return entry.farthest >> (8 * pass + 8) & 0xff; });
    const BandOfRow band_of_row(word(input.band_lines));
    deal_to_bands(memory_.entries.data(), first, memory_.bands,
                  [&](const Entry& entry) { return band_of_row(entry.first_row); });
  }

  /// Fills a band's pixels with the background.
  template <class Fill>
  void clear(const Target& target, Fill fill) {
    const auto pixels = static_cast<std::uint32_t>(target.width * (target.end_row - target.first_row));
    fill(target.background, pixels, target.pixels);
    if constexpr (keeps_depth) fill(Depth::clear, pixels, target.depth);
  }

  template <class ShadingGroup, class Covered>
  [[gnu::noinline]] void draw_band(PolygonTable& table, std::span<const ShadingGroup> shading, std::int32_t band,
                                   Viewport viewport, const Target& target, Covered&& covered) {
    const OrderedRuns<Depth, Shaders, Target, ShadingGroup, Counting> runs{{table, viewport}, shading.data(), target};
    Drawn& drawn = memory_.drawn.front();
    walk_band(band, target, [&](Link number) {
      const std::int32_t row = place(drawn, runs, number, target.first_row - row_bias, target.end_row - row_bias);
      if constexpr (Counting) tell_covered_from(drawn, runs, shading[drawn.group], row, covered);
      runs.prepare(drawn);
      Pixel* pixels = runs.line(row);
      const std::int32_t width = target.width;
      for_each_row(
          drawn, runs, row, target.end_row - row_bias,
          [&](std::int32_t at, RowColumns columns)
              __attribute__((always_inline)) { runs.fill_prepared(drawn, at, columns, pixels); },
          [&] { pixels += width; });
    });
  }

  /// Steps over a band that another core draws.
  template <class ShadingGroup>
  void skip_band(PolygonTable&, std::span<const ShadingGroup>, std::int32_t band, Viewport, const Target& target) {
    walk_band(band, target, [](Link) {});
  }

  /// The pools are never too small.
  [[nodiscard]] static PoolShortage shortage(const FrameInput&) { return {}; }
  void note_peaks(PoolPeaks& peaks) const {
    peaks.polygons += polygon_count_ * sizeof(Entry);
    peaks.buckets += memory_.bands.size_bytes() + memory_.queues.size_bytes() + memory_.drawn.size_bytes();
  }

 private:
  /// Whether `a` is drawn before `b`.
  [[nodiscard]] bool is_behind(Link a, Link b) const {
    const std::uint32_t depth_a = memory_.entries[a].farthest, depth_b = memory_.entries[b].farthest;
    return depth_a > depth_b || (depth_a == depth_b && a > b);
  }

  /// Merges the polygons that continue from the band above with those that begin in this one, calls draw(number) for
  /// each, the farthest first, and keeps those that continue below.
  template <class Draw>
  [[gnu::always_inline]] void walk_band(std::int32_t band, const Target& target, Draw draw) {
    const std::int32_t end = target.end_row - row_bias;
    Link beginning = memory_.bands[static_cast<std::size_t>(band)];
    for (Link* link = &continuing_;;) {
      Link number = *link;
      if (beginning != no_link && (number == no_link || is_behind(beginning, number))) {
        Entry& entry = memory_.entries[beginning];
        const Link next = entry.next;
        entry.next = number;
        *link = number = beginning;
        beginning = next;
      }
      if (number == no_link) return;
      draw(number);
      Entry& entry = memory_.entries[number];
      if (entry.end_row > end)
        link = &entry.next;
      else
        *link = entry.next;
    }
  }

  Memory memory_{};
  std::uint32_t polygon_count_ = 0;
  Link continuing_ = no_link;  ///< the polygons that reach across the upper edge of the band, the farthest first
};

/// The visibility algorithm of a renderer: the painter's algorithm.
struct Painter {
  template <class Depth, class Pixel, class Shaders, bool Counting>
  using Algorithm = PaintersAlgorithm<Depth, Pixel, Shaders, Counting>;
};

}  // namespace spanline
