#pragma once
/// @file
/// Depth sort, after M. Newell, R. Newell and T. Sancha, "A Solution to the Hidden Surface Problem" (1972), lecture
/// 002, "Newell, Newell, Sancha Algorithm", and lecture 003, "The Depth-Sort Algorithm"; here from front to back, over
/// a record of what is filled.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include "spanline/visibility/algorithm.hpp"
#include "spanline/visibility/filled/filled_columns.hpp"
#include "spanline/visibility/sort/band_members.hpp"
#include "spanline/visibility/sort/depth_sort_counters.hpp"
#include "spanline/visibility/sort/open_pixels.hpp"
#include "spanline/visibility/sort/ordered_layers.hpp"
#include "spanline/visibility/sort/ordered_rows.hpp"
#include "spanline/visibility/sort/pair_order.hpp"
#include "spanline/visibility/sort/screen_extent.hpp"
#include "spanline/visibility/sort/sort_by_depth.hpp"
#include "spanline/visibility/sort/sorted_bands.hpp"

namespace spanline {

/// Depth sort. The polygons of a frame are sorted once by their nearest depth. In each band they are drawn from front
/// to back, P before the polygons Q that come after it in the list, and every pixel is filled once.
///
/// The textbook splits P where it and a Q hide parts of each other. Here nothing is split: P fills those of its pixels
/// that are not filled yet and on which no later Q is in front; the later ones fill what P has left. That is right in
/// any order of the list: at every pixel the foremost polygon is the only one that no later one beats and that finds
/// the pixel open. So cycles and penetration end without an argument, and the overlap tests only save the comparison of
/// pixels. A Q that lies wholly in front of P is moved before P, unless P itself was just moved.
///
/// With 24-bit depths it draws the z-buffer's bytes, since pixels are compared by the same plane words.
template <class Depth, class Pixel, class Shaders, bool Counting>
class DepthSortAlgorithm {
  using Drawn = DrawnPolygon<Shaders>;
  using Plane = NumberedPlane<Depth>;

 public:
  using Target = BandTarget<Depth, Pixel>;

  static constexpr AlgorithmNeeds needs = AlgorithmNeeds::screen_polygons;
  static constexpr bool takes_outlines = true;
  /// Depths are written only when counting, for inspection.
  static constexpr bool keeps_depth = Counting, tests_depth = false, takes_table_apart = false, clears_ahead = true;
  using Counter = DepthSortCounter;
  static constexpr auto& counter_names = depth_sort_counter_names;

  static constexpr bool has_layers = Shaders::see_through;

  /// The memory of the algorithm, cut off an arena.
  struct Memory {
    std::span<SortedPolygon> polygons;
    std::span<Link> queues;  ///< for sorting
    std::span<Drawn> drawn;  ///< the polygon that is being drawn
    BandMembers members;
    FilledColumns filled;
    OpenPixels open;
    [[no_unique_address]] std::conditional_t<has_layers, LayerMemory<Shaders>, NoLayerMemory> layers;

    constexpr void take(Arena& arena, const Capacity& capacity) {
      polygons = arena.take<SortedPolygon>(capacity.polygons);
      queues = arena.take<Link>(radix_queues);
      drawn = arena.take<Drawn>(1);
      members.take(arena, capacity.members, capacity.bands());
      filled.take(arena, capacity.width, capacity.band_lines);
      open.take(arena, capacity.width, capacity.band_lines);
      layers.take(arena, capacity);
    }
  };

  /// The greatest number of see-through polygons in a band: that of the records that keys can address.
  static constexpr auto most_layers =
      static_cast<std::uint32_t>(std::min<std::size_t>(awake_key::largest_offset / sizeof(Drawn), no_link - 1));
  [[nodiscard]] static constexpr bool takes(const Capacity& capacity) {
    return capacity.members < no_link && (!has_layers || capacity.layers <= most_layers);
  }
  /// The polygon table's buckets are not used.
  [[nodiscard]] static constexpr std::uint32_t bucket_lines(const Capacity& capacity) { return capacity.height; }

  DepthSortAlgorithm() = default;
  explicit DepthSortAlgorithm(const Memory& memory) : memory_(memory) {}

  /// Sorts the frame's polygons by their depths: opaque ones by the nearest, see-through ones by the farthest.
  void begin_frame(const FrameInput& input) {
    scale_ = BoxScale(input.viewport);
    polygon_count_ = input.table.polygon_count;
    Link opaque = no_link;
    [[maybe_unused]] Link layers = no_link;
    for_each_from_the_last(input.table, [&](Link number, const PolygonGroup& group) {
      SortedPolygon& sorted = memory_.polygons[number];
      if (!describe({input.table, group, number}, input.viewport, sorted)) return;
      Link& list = has_layers && group.see_through ? layers : opaque;
      if (has_layers && group.see_through) sorted.turn_round();
      sorted.next = list;
      list = number;
    });
    memory_.members.begin_frame(memory_.polygons.data(), sort(opaque), scale_, input.band_lines);
    if constexpr (has_layers)
      memory_.layers.members.begin_frame(memory_.polygons.data(), sort(layers), scale_, input.band_lines);
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
    const std::int32_t first_row = target.first_row - row_bias, end_row = target.end_row - row_bias;
    gather(band, first_row, end_row);
    memory_.filled.begin_band(viewport.width, end_row - first_row);
    Band<ShadingGroup> drawing{
        {{table, viewport}, shading.data(), target}, memory_, tests_, scale_, first_row, end_row};
    if constexpr (Counting) {
      tell_covered_members(memory_.members, drawing, covered);
      if constexpr (has_layers) tell_covered_members(memory_.layers.members, drawing, covered);
    }
    drawing.draw_band();
  }

  /// Steps over a band that another core draws.
  template <class ShadingGroup>
  void skip_band(PolygonTable&, std::span<const ShadingGroup>, std::int32_t band, Viewport, const Target& target) {
    gather(band, target.first_row - row_bias, target.end_row - row_bias);
  }

  /// Tells whether polygons were left out of a band, and how many members the fullest band has.
  [[nodiscard]] PoolShortage shortage(const FrameInput&) const {
    if (memory_.members.overflowed()) return {Pool::members, memory_.members.wanted()};
    if constexpr (has_layers) {
      if (memory_.layers.members.overflowed()) return {Pool::layers, memory_.layers.members.wanted()};
    }
    return {};
  }
  void note_peaks(PoolPeaks& peaks) const {
    peaks.polygons += polygon_count_ * sizeof(SortedPolygon);
    peaks.members = memory_.members.peak_bytes() + memory_.queues.size_bytes() + memory_.drawn.size_bytes() +
                    memory_.filled.bytes() + memory_.open.bytes();
    if constexpr (has_layers) peaks.layers = memory_.layers.peak_bytes();
  }

 private:
  /// Describes a polygon for the sort; false if it has no pixels.
  [[nodiscard]] bool describe(const PolygonEntry& entry, Viewport viewport, SortedPolygon& sorted) const {
    const ScreenExtent extent = ScreenExtent::of(entry, viewport);
    if (extent.empty()) return false;
    BoundMargin margin = depth_margin<Depth>;
    if (entry.is_outline()) [[unlikely]] {
      const std::uint32_t slack = entry.outline().header.depth_slack();
      margin.below += slack;
      margin.above += slack;
    }
    const std::uint32_t nearest = extent.nearest > margin.below ? extent.nearest - margin.below : 0,
                        farthest = extent.farthest < ~margin.above ? extent.farthest + margin.above : ~0u;
    sorted.nearest = static_cast<std::uint16_t>(nearest >> 16);
    sorted.farthest = static_cast<std::uint16_t>(farthest >> 16);
    sorted.box = PackedBox(extent, scale_);
    return true;
  }
  [[nodiscard]] Link sort(Link first) const {
    constexpr unsigned depth_bytes = 2;
    return sort_by_bytes(memory_.polygons.data(), first, depth_bytes, memory_.queues,
                         [](const SortedPolygon& polygon, unsigned pass) -> std::uint32_t {
                           return std::uint32_t{polygon.nearest} >> (8 * pass) & 0xff;
                         });
  }
  void gather(std::int32_t band, std::int32_t first_row, std::int32_t end_row) {
    memory_.members.gather(band, first_row, end_row);
    if constexpr (has_layers) memory_.layers.members.gather(band, first_row, end_row);
  }
  template <class Drawing, class Covered>
  void tell_covered_members(const BandMembers& members, const Drawing& drawing, Covered& covered) {
    Drawn& drawn = memory_.drawn.front();
    for (const BandMember& member : std::span(members.begin(), members.count())) {
      const std::int32_t row = place(drawn, drawing, member.number, drawing.first_row, drawing.end_row);
      if (row < drawing.end_row) tell_covered_from(drawn, drawing, drawing.shading[drawn.group], row, covered);
    }
  }

  /// The band that is being drawn.
  template <class ShadingGroup>
  struct Band : OrderedRuns<Depth, Shaders, Target, ShadingGroup, Counting> {
    Memory& memory;
    PairTests<Depth, Counting>& tests;
    BoxScale scale;
    std::int32_t first_row, end_row;
    bool records_owners = false;  ///< whether layers will ask which polygon is visible

    [[gnu::always_inline]] void draw_band() {
      if constexpr (has_layers) {
        records_owners = memory.layers.members.count() != 0;
        if (records_owners) {
          const auto pixels = word((end_row - first_row) * this->target.width);
          Shaders::fill_apart(no_link, pixels, memory.layers.owners.data());
        }
      }
      draw_opaque();
      if constexpr (Counting) count_background();
      if constexpr (has_layers) {
        if (records_owners)
          OrderedLayers<Depth, Shaders, Target, ShadingGroup, Counting>{
              *this, memory.layers, memory.polygons, tests, memory.drawn.front(), first_row, end_row}
              .lay();
      }
    }

   private:
    /// Draws the members from the nearest to the farthest.
    [[gnu::always_inline]] void draw_opaque() {
      BandMember* const end = memory.members.end();
      bool may_move = true;
      for (BandMember* member = memory.members.begin(); member != end;) {
        if (memory.filled.full()) return;
        if (is_hidden(member->box)) {
          ++member;
          may_move = true;
          continue;
        }
        const PackedBox::Facing facing(member->box);
        BandMember* const last = memory.members.end_at(member + 1, memory.polygons[member->number].farthest);
        // The search for pairs ends at the latest at `last`, whose own box is put aside until then.
        const PackedBox kept = last->box;
        last->box = PackedBox::everywhere();
        BandMember* q = next_pair(member + 1, facing);
        if (q == last) {
          last->box = kept;
          draw_alone(*member);
        } else {
          Plane other;
          tests.begin(*this, member->number);
          const PairOrder order = next_rival(q, last, facing, other);
          if (q == last)
            draw_alone(*member);
          else if (order != PairOrder::in_front || !may_move)
            draw_against(member->number, q, last, other, order);
          last->box = kept;
          if (q != last && order == PairOrder::in_front && may_move) {
            move_before(member, q, Counting ? this->target.counters : nullptr);
            may_move = false;
            continue;
          }
        }
        ++member;
        may_move = true;
      }
    }

    /// Counts the pixels of the background.
    void count_background() {
      for (std::int32_t line = 0; line < end_row - first_row; ++line)
        memory.filled.for_each_gap(memory.filled.line(line), [&](RowColumns columns) {
          this->target.counters->own[Counter::shaded] += word(columns.end - columns.first);
        });
    }

    /// Whether all pixels of a box are filled, as far as that is told quickly.
    [[gnu::always_inline]] bool is_hidden(PackedBox box) const {
      const std::int32_t first = box.first_column(scale), end = box.end_column(scale);
      if (end - first > column_bits::columns_a_word) return memory.filled.is_closed(first, end);
      const std::int32_t top = box.first_row(scale) - first_row, bottom = box.end_row(scale);
      return memory.filled.is_filled(first, end, top < 0 ? 0 : top, (bottom < end_row ? bottom : end_row) - first_row);
    }

    /// The first member from `q` on whose box overlaps that of the current polygon; `last`, whose box overlaps all, if
    /// there is none.
    [[gnu::always_inline]] BandMember* next_pair(BandMember* q, PackedBox::Facing facing) const {
      while (!facing.overlaps(q->box)) {
        if constexpr (Counting) {
          const bool by_columns = !facing.x_extents_overlap(q->box);
          ++this->target.counters->own[by_columns ? Counter::x_extents : Counter::y_extents];
        }
        ++q;
      }
      return q;
    }
    /// The first pair from `q` on that is not in order. `q` becomes its member, or `last` if there is none.
    PairOrder next_rival(BandMember*& q, const BandMember* last, PackedBox::Facing facing, Plane& other) {
      for (; q != last; q = next_pair(q + 1, facing)) {
        other.set(q->number);
        const PairOrder order = tests.test(*this, other, true, this->target.counters);
        if (order == PairOrder::in_front || order == PairOrder::unknown) return order;
      }
      return PairOrder::apart;
    }
    SPANLINE_INLINE_IF_OPTIMISED void fill_run(Drawn& drawn, std::int32_t row, RowColumns columns) const {
      fill_run(drawn, row, columns, this->line(row));
    }
    SPANLINE_INLINE_IF_OPTIMISED void fill_run(Drawn& drawn, std::int32_t row, RowColumns columns,
                                               Pixel* pixels) const {
      if constexpr (Counting) this->target.counters->own[Counter::shaded] += word(columns.end - columns.first);
      this->fill(drawn, row, columns, pixels);
      if constexpr (has_layers) {
        if (records_owners)
          Shaders::fill_apart(drawn.number, word(columns.end - columns.first),
                              memory.layers.owners.data() + (row - first_row) * this->target.width + columns.first);
      }
    }

    /// Draws a polygon that no later one hides: it fills what is not filled yet.
    [[gnu::noinline]] void draw_alone(const BandMember& member) {
      Drawn& drawn = memory.drawn.front();
      const std::int32_t row = place(drawn, *this, member.number, first_row, end_row);
      if (row == end_row) return;
      this->begin(drawn);
      std::int32_t first_column = member.box.first_column(scale);
      if (drawn.fraction_bits == 0 || !is_narrow(member, first_column))
        draw_wide(drawn, row);
      else if (column_bits::word_of(first_column) == column_bits::word_of(member.box.end_column(scale) - 1))
        draw_narrow<true>(drawn, row, first_column & ~(column_bits::columns_a_word - 1));
      else
        draw_narrow<false>(drawn, row, first_column);
    }
    /// Whether a word has as many columns as the polygon; `first_column` becomes that of its first pixel if it has to
    /// be known exactly.
    [[gnu::always_inline]] bool is_narrow(const BandMember& member, std::int32_t& first_column) const {
      const std::int32_t columns = member.box.end_column(scale) - first_column;
      if (columns <= column_bits::columns_a_word) return true;
      if (columns - 2 * (1 << scale.columns) >= column_bits::columns_a_word) return false;
      const ScreenExtent extent = ScreenExtent::of(this->entry(memory.drawn.front()), this->viewport);
      first_column = extent.first_column;
      return extent.end_column - first_column <= column_bits::columns_a_word;
    }
    /// A window of as many columns as a word has, from `first_column` on, holds the polygon. `InWord` says that it is a
    /// word of the record.
    template <bool InWord>
    SPANLINE_INLINE_IF_OPTIMISED void draw_narrow(Drawn& drawn, std::int32_t row, std::int32_t first_column) {
      FilledColumns& filled = memory.filled;
      const std::int32_t index = column_bits::word_of(first_column);
      const int shift = first_column & 31;
      std::uint32_t* words = filled.line(row - first_row) + index;
      Pixel* pixels = this->line(row) + first_column;
      const std::size_t stride = filled.stride();
      const std::int32_t width = this->target.width;
      for_each_fixed_row(
          drawn, *this, row, end_row < drawn.end_row ? end_row : drawn.end_row,
          word(drawn.origin - first_column) << drawn.fraction_bits,
          [&](std::int32_t at, RowColumns run) __attribute__((always_inline)) {
            const std::uint32_t range = column_bits::between(run.first, run.end);
            const std::uint32_t now =
                InWord ? filled.fill_whole_word(words, index, range) : filled.fill_window(words, index, shift, range);
            if (now == range)
              fill_run(drawn, at, {first_column + run.first, first_column + run.end}, pixels - first_column);
            else if (now != 0)
              fill_parts(drawn, at, first_column, now, pixels);
          },
          [&] {
            words += stride;
            pixels += width;
          });
    }
    [[gnu::noinline]] void fill_parts(Drawn& drawn, std::int32_t row, std::int32_t first_column, std::uint32_t columns,
                                      Pixel* pixels) const {
      const auto fill = [&](std::int32_t first, std::int32_t end) {
        fill_run(drawn, row, {first, end}, pixels - first_column);
      };
      const std::int32_t open = column_bits::for_each_run(columns, first_column, -1, fill);
      if (open >= 0) fill(open, first_column + column_bits::columns_a_word);
    }
    [[gnu::noinline]] void draw_wide(Drawn& drawn, std::int32_t row) {
      FilledColumns& filled = memory.filled;
      std::uint32_t* words = filled.line(row - first_row);
      Pixel* pixels = this->line(row);
      const std::size_t stride = filled.stride();
      const std::int32_t width = this->target.width;
      for_each_row(
          drawn, *this, row, end_row,
          [&](std::int32_t at, RowColumns run) __attribute__((always_inline)) {
            // Captured by value, so that they stay in registers.
            filled.fill(
                words, run,
                [ this, &drawn, at, row_pixels = pixels ](RowColumns columns)
                    __attribute__((always_inline)) { fill_run(drawn, at, columns, row_pixels); });
          },
          [&] {
            words += stride;
            pixels += width;
          });
    }

    /// Draws a polygon P except where later ones, of which `q` is the first, are in front. `order` is what the tests
    /// say about it.
    [[gnu::noinline]] void draw_against(Link number, BandMember* q, const BandMember* last, Plane& other,
                                        PairOrder order) {
      Drawn& drawn = memory.drawn.front();
      const std::int32_t row = place(drawn, *this, number, first_row, end_row);
      if (row == end_row) return;
      this->begin(drawn);
      const std::uint32_t* filled = memory.filled.line(row - first_row);
      OpenPixels::Line line =
          memory.open.begin(row - first_row, (drawn.end_row < end_row ? drawn.end_row : end_row) - first_row);
      for_each_row(
          drawn, *this, row, end_row,
          [&](std::int32_t, RowColumns run) __attribute__((always_inline)) { OpenPixels::open(line, run, filled); },
          [&] {
            filled += line.stride;
            line.step();
          });
      PackedBox box;
      if (!tighten(box)) return;
      while (q != last) {
        if (withhold(other, order == PairOrder::in_front) && !tighten(box)) return;
        const PackedBox::Facing facing(box);
        q = next_pair(q + 1, facing);
        order = next_rival(q, last, facing, other);
      }
      const std::int32_t top = first_row + memory.open.first_line(), width = this->target.width;
      Pixel* pixels = this->line(top) - width;
      memory.open.fill_into(
          memory.filled, [&] { pixels += width; },
          [&](std::int32_t at, RowColumns columns)
              __attribute__((always_inline)) { fill_run(drawn, first_row + at, columns, pixels); });
    }
    bool tighten(PackedBox& box) const { return memory.open.tighten(first_row, scale, box); }

    /// Takes from P's open pixels those where Q is in front: all that they share if Q is `wholly` in front. Along a row
    /// the order changes once at most. True if any were taken.
    [[gnu::noinline]] bool withhold(Plane& other, bool wholly) {
      if constexpr (Counting) ++this->target.counters->own[Counter::resolved];
      AwakePolygon q;
      const std::int32_t end = first_row + memory.open.end_line();
      const std::int32_t row = place(q, *this, other.number(), first_row + memory.open.first_line(), end);
      std::uint32_t taken = 0;
      for_each_row(
          q, *this, row, end, [&](std::int32_t at, RowColumns run) __attribute__((always_inline)) {
            const std::int32_t line = at - first_row;
            RowColumns common = memory.open.common(line, run);
            if (common.first >= common.end) return;
            if (!wholly) {
              if (!other.has_plane() && !memory.open.any(line, common)) return;
              if (!keep_where_in_front(other, at, common)) return;
            }
            taken |= memory.open.close(line, common);
          });
      return taken != 0;
    }
    /// Leaves of the columns of a row those where Q is in front of P; false if there are none.
    bool keep_where_in_front(Plane& other, std::int32_t row, RowColumns& columns) {
      const LinearFunction &p = tests.front().plane(*this), &q = other.plane(*this);
      const std::uint32_t p_depth = p.at_origin + p.dy * word(row), q_depth = q.at_origin + q.dy * word(row);
      const bool wins_ties = other.number() < tests.front().number();
      const auto in_front = [&](std::int32_t column) {
        const std::uint32_t depth_p = p_depth + p.dx * word(column), depth_q = q_depth + q.dx * word(column);
        return depth_q < depth_p || (depth_q == depth_p && wins_ties);
      };
      if constexpr (Counting) this->target.counters->depth_tests += 2;
      const bool at_first = in_front(columns.first), at_last = in_front(columns.end - 1);
      if (at_first == at_last) return at_first;
      std::int32_t low = columns.first, high = columns.end - 1;
      while (high - low > 1) {
        const std::int32_t middle = (low + high) >> 1;
        (in_front(middle) == at_first ? low : high) = middle;
      }
      (at_first ? columns.end : columns.first) = high;
      return true;
    }
  };

  Memory memory_{};
  PairTests<Depth, Counting> tests_;
  BoxScale scale_;
  std::uint32_t polygon_count_ = 0;
};

/// The visibility algorithm of a renderer: depth sort, without a depth buffer and exact with 24-bit depths.
struct DepthSort {
  template <class Depth, class Pixel, class Shaders, bool Counting>
  using Algorithm = DepthSortAlgorithm<Depth, Pixel, Shaders, Counting>;
};

}  // namespace spanline
