#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/visibility/sort/band_members.hpp"
#include "spanline/visibility/sort/depth_sort_counters.hpp"
#include "spanline/visibility/sort/ordered_rows.hpp"
#include "spanline/visibility/sort/pair_order.hpp"
#include "spanline/visibility/span/active_edge_table.hpp"
#include "spanline/visibility/span/depth_order.hpp"
#include "spanline/visibility/span/layer_sweep.hpp"

namespace spanline {

/// The memory with which depth sort lays see-through polygons (layers) over a band, cut off an arena.
template <class Shaders>
struct LayerMemory {
  static constexpr std::size_t most_fronts = 16;  ///< a power of two

  /// The layers of the band, the farthest first: depths are complemented, so that the nearest of the sort is the
  /// farthest layer.
  BandMembers members;
  std::span<Link> owners;                    ///< the visible opaque polygon at each pixel of the band, or no_link
  std::span<AwakePolygon> fronts;            ///< opaque polygons that layers were compared with last, by their numbers
  std::span<DrawnPolygon<Shaders>> records;  ///< layers that are laid row by row
  std::span<AwakeKey> keys;

  constexpr void take(Arena& arena, const Capacity& capacity) {
    members.take(arena, capacity.layers, capacity.bands());
    owners = arena.take<Link>(std::size_t{capacity.width} * capacity.band_lines);
    fronts = arena.take<AwakePolygon>(most_fronts);
    records = arena.take<DrawnPolygon<Shaders>>(capacity.layers);
    keys = arena.take<AwakeKey>(2 * (std::size_t{capacity.layers} + 2));
  }
  [[nodiscard]] std::size_t peak_bytes() const {
    return members.peak_bytes() + owners.size_bytes() + fronts.size_bytes() + records.size_bytes() + keys.size_bytes();
  }
};

/// Takes its place where no shader is see-through.
struct NoLayerMemory {
  constexpr void take(Arena&, const Capacity&) {}
};

/// Moves a member of the list before another one that precedes it.
inline void move_before(BandMember* member, BandMember* moved, [[maybe_unused]] VisibilityCounters* counters) {
  if (counters != nullptr) ++counters->own[DepthSortCounter::moves];
  const BandMember first = *moved;
  for (; moved != member; --moved) moved[0] = moved[-1];
  *member = first;
}

/// Lays the see-through polygons of a band over the opaque ones, from back to front in the order of the sort.
///
/// The list has the farthest layer first. P is laid when no later Q may be behind it: the overlap tests decide as they
/// do for opaque polygons, with the roles of the nearer and the farther one exchanged, and a Q that is wholly behind P
/// is moved before it. Layers that penetrate or overlap in a cycle are laid together, row by row, with all that lie
/// between them in the list (a knot); LayerSweep orders them at each pixel.
///
/// The record of the band's owners tells which opaque polygon is visible at a pixel. A layer shows where it is in front
/// of that.
template <class Depth, class Shaders, class Target, class ShadingGroup, bool Counting>
struct OrderedLayers : OrderedRuns<Depth, Shaders, Target, ShadingGroup, Counting> {
  using Drawn = DrawnPolygon<Shaders>;
  using Plane = NumberedPlane<Depth>;
  using Counter = DepthSortCounter;
  static constexpr unsigned crossings_counter = Counter::crossings;

  LayerMemory<Shaders>& memory;
  std::span<const SortedPolygon> polygons;
  PairTests<Depth, Counting>& tests;
  Drawn& drawn;
  std::int32_t first_row, end_row;  ///< of the band, not biased
  std::int32_t row = 0;             ///< that a knot is on

  [[gnu::noinline]] void lay() {
    for (AwakePolygon& front : memory.fronts) front.number = no_link;
    BandMember* const end = memory.members.end();
    bool may_move = true;
    for (BandMember* member = memory.members.begin(); member != end;) {
      BandMember* rival = member + 1;
      const PairOrder order = next_rival(*member, rival, end);
      if (order == PairOrder::behind && may_move) {
        move_before(member, rival, this->target.counters);
        may_move = false;
        continue;
      }
      if (rival == end)
        lay_alone((member++)->number);
      else
        member = lay_knot(member, rival, end);
      may_move = true;
    }
  }

  // The functions that LayerSweep calls.

  void layer(AwakePolygon& polygon, std::int32_t begin, std::int32_t end) {
    this->fill(static_cast<Drawn&>(polygon), row, {begin, end});
  }
  void begins(const AwakePolygon&) {}

 private:
  /// The first member from `q` on that may be behind `p` somewhere; `end` if there is none.
  [[gnu::noinline]] PairOrder next_rival(const BandMember& p, BandMember*& q, BandMember* end) {
    const std::uint16_t last = polygons[p.number].farthest;
    const PackedBox::Facing facing(p.box);
    bool begun = false;
    for (; q != end && q->nearest <= last; ++q) {
      if (!facing.overlaps(q->box)) {
        if constexpr (Counting) {
          const bool by_columns = !facing.x_extents_overlap(q->box);
          ++this->target.counters->own[by_columns ? Counter::x_extents : Counter::y_extents];
        }
        continue;
      }
      if (!begun) tests.begin(*this, p.number);
      begun = true;
      Plane other;
      other.set(q->number);
      const PairOrder order = tests.test(*this, other, false, this->target.counters);
      if (order == PairOrder::behind || order == PairOrder::unknown) return order;
    }
    q = end;
    return PairOrder::apart;
  }

  [[nodiscard]] Link* owners(std::int32_t at) const {
    return memory.owners.data() + (at - first_row) * this->target.width;
  }
  /// Calls use(front, columns) for each run of one visible opaque polygon in a part of a row. `front` is null where
  /// there is the background.
  template <class Use>
  void for_each_front(std::int32_t at, RowColumns columns, Use use) {
    const Link* const line = owners(at);
    while (columns.first < columns.end) {
      const Link owner = line[columns.first];
      std::int32_t end = columns.first + 1;
      while (end < columns.end && line[end] == owner) ++end;
      use(owner == no_link ? nullptr : &front_of(owner), RowColumns{columns.first, end});
      columns.first = end;
    }
  }
  /// What comparisons need of an opaque polygon: its number, its bounds and, once it was needed, its plane.
  [[nodiscard]] AwakePolygon& front_of(Link number) {
    AwakePolygon& front = memory.fronts[number & (LayerMemory<Shaders>::most_fronts - 1)];
    if (front.number == number) return front;
    const SortedPolygon& sorted = polygons[number];
    front.number = number;
    front.group = this->table.find_group(number);
    front.third = this->table.is_outline(number) ? AwakePolygon::Third::outline : AwakePolygon::Third::on_left;
    front.has_plane = false;
    front.nearest = std::uint32_t{sorted.nearest} << 16;
    front.farthest = std::uint32_t{sorted.farthest} << 16 | 0xffff;
    return front;
  }
  /// Sets the bounds of a layer, from the sort's, which are complemented.
  void bound(AwakePolygon& layer) const {
    const SortedPolygon& sorted = polygons[layer.number];
    layer.nearest = ~(std::uint32_t{sorted.farthest} << 16 | 0xffff);
    layer.farthest = ~(std::uint32_t{sorted.nearest} << 16);
  }

  /// Lays a layer where it is in front of the opaque polygons.
  [[gnu::noinline]] void lay_alone(Link number) {
    DepthOrder<Depth, Counting, crossings_counter> order(*this, this->target.counters);
    const std::int32_t first = place(drawn, *this, number, first_row, end_row);
    if (first == end_row) return;
    bound(drawn);
    this->begin(drawn);
    for_each_row(drawn, *this, first, end_row, [&](std::int32_t at, RowColumns run) {
      order.move_to(at);
      std::int32_t open = -1;  // where the visible part that was found last begins
      const auto close = [&](std::int32_t end) {
        if (open >= 0) this->fill(drawn, at, {open, end});
        open = -1;
      };
      for_each_front(at, run, [&](AwakePolygon* front, RowColumns columns) {
        const std::int32_t last = columns.end - 1;
        const bool at_first = front == nullptr || order.in_front(drawn, *front, columns.first);
        const bool at_last =
            front == nullptr || (last == columns.first ? at_first : order.in_front(drawn, *front, last));
        if (at_first && open < 0) open = columns.first;
        if (!at_first) close(columns.first);
        if (at_first == at_last) return;
        const std::int32_t change = at_first ? order.crossing(drawn, *front, columns.first, last)
                                             : order.crossing(*front, drawn, columns.first, last);
        if (at_first)
          close(change);
        else
          open = change;
      });
      close(run.end);
    });
  }

  /// Lays the members from `first` to `last` together, and those after them that may be behind one of them. Output: the
  /// first member that is not laid.
  [[gnu::noinline]] BandMember* lay_knot(BandMember* first, BandMember* last, BandMember* end) {
    if constexpr (Counting) ++this->target.counters->own[Counter::knots];
    for (BandMember* member = first; member <= last; ++member)
      for (BandMember* rival = last + 1; rival != end;) {
        static_cast<void>(next_rival(*member, rival, end));
        if (rival != end) last = rival++;
      }
    ActiveEdgeTable edges;
    edges.begin_frame(memory.keys, reinterpret_cast<std::byte*>(memory.records.data()), memory.records.size(),
                      sizeof(Drawn));
    AwakePolygon* waiting = place_knot(edges, first, last + 1);
    LayerSweep<OrderedLayers> sweep(*this);
    for (row = waiting == nullptr ? end_row : waiting->retry_row; row < end_row; ++row) {
      while (waiting != nullptr && waiting->retry_row == row) {
        AwakePolygon& polygon = *waiting;
        waiting = polygon.next;
        edges.enter(polygon,
                    polygon.fraction_bits != 0 ? place_columns(polygon) : cut_columns(polygon, this->viewport.width));
      }
      static_cast<void>(edges.step(*this, row));
      const std::int32_t width = this->viewport.width;
      sweep.begin_row(edges, row);
      if (sweep.reaches(width))
        for_each_front(row, {awake_key::column(*edges.sorted()), width}, [&](AwakePolygon* front, RowColumns columns) {
          if (sweep.reaches(columns.end)) sweep.over(front, columns.first, columns.end);
        });
    }
    return last + 1;
  }
  /// Places the members of a knot on their first rows in the band. Output: those with rows there, linked by first rows,
  /// which are in `retry_row`.
  [[nodiscard]] AwakePolygon* place_knot(ActiveEdgeTable& edges, const BandMember* member, const BandMember* end) {
    AwakePolygon* waiting = nullptr;
    for (; member != end; ++member) {
      AwakePolygon& record = *edges.take();
      const std::int32_t first = place(record, *this, member->number, first_row, end_row);
      if (first == end_row) continue;
      bound(record);
      this->begin(static_cast<Drawn&>(record));
      record.retry_row = static_cast<std::uint16_t>(first);
      AwakePolygon** link = &waiting;
      while (*link != nullptr && (*link)->retry_row < first) link = &(*link)->next;
      record.next = *link;
      *link = &record;
    }
    return waiting;
  }
};

}  // namespace spanline
