#include "spanline/visibility/span/wake_bucket.hpp"

namespace spanline {
namespace {

/// The farthest polygon stands back for a row; those that ended make room first. False if one had to.
[[gnu::noinline]] bool wake_in_full_table(ActiveEdgeTable& edges, const PolygonSource& source, Link number,
                                          std::int32_t row, BoundMargin margin) {
  edges.reap(row);
  AwakePolygon candidate;
  const std::int32_t column = wake(candidate, source, number, row, margin);
  AwakePolygon* record = edges.take();
  const bool room = record != nullptr;
  if (!room) {
    record = edges.evict(candidate.nearest, number);
    const AwakePolygon& left_out = record == nullptr ? candidate : *record;
    if (row + 1 < left_out.end_row) source.table.defer(row + 1, left_out.number);
  }
  if (record != nullptr) {
    *record = candidate;
    edges.enter(*record, column);
  }
  return room;
}

/// Walks the bucket of `row`; `table_of(number)` is the table that a polygon enters and `no_room(table)` is told where
/// it was full.
template <class TableOf, class NoRoom>
[[gnu::always_inline]] inline void wake_all(const PolygonSource& source, std::int32_t row, BoundMargin margin,
                                            TableOf table_of, NoRoom no_room) {
  PolygonTable& table = source.table;
  const Link last = table.buckets[static_cast<std::size_t>(row)];
  if (last == no_link) return;
  Link number = table.references[last].next;
  for (;;) {
    const Link following = table.references[number].next;  // waking may defer the polygon
    ActiveEdgeTable& edges = table_of(number);
    if (AwakePolygon* record = edges.take(); __builtin_expect(record != nullptr, true))
      edges.enter(*record, wake(*record, source, number, row, margin));
    else if (!wake_in_full_table(edges, source, number, row, margin))
      no_room(edges);
    if (number == last) return;
    number = following;
  }
}

}  // namespace

bool wake_bucket(ActiveEdgeTable& edges, const PolygonSource& source, std::int32_t row, BoundMargin margin) {
  bool room = true;
  wake_all(
      source, row, margin, [&](Link) -> ActiveEdgeTable& { return edges; },
      [&](const ActiveEdgeTable&) { room = false; });
  return room;
}

WokenWithLayers wake_bucket(ActiveEdgeTable& edges, ActiveEdgeTable& layers, const PolygonSource& source,
                            std::int32_t row, BoundMargin margin) {
  WokenWithLayers woken{true, true};
  const PolygonTable& table = source.table;
  wake_all(
      source, row, margin,
      [&](Link number) -> ActiveEdgeTable& {
        return table.groups[table.find_group(number)].see_through ? layers : edges;
      },
      [&](const ActiveEdgeTable& full) { (&full == &layers ? woken.all_layers : woken.all_opaque) = false; });
  return woken;
}

}  // namespace spanline
