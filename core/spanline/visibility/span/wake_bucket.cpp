#include "spanline/visibility/span/wake_bucket.hpp"

#include "spanline/raster/link.hpp"

namespace spanline {
namespace {

/// A polygon that found no room in a full table.
struct LeftOut {
  Link number = no_link;
  std::int32_t end_row = 0;

  /// Puts the polygon into the bucket of the next row, if it reaches that row.
  void defer(const PolygonSource& source, std::int32_t row) const {
    if (row + 1 < end_row) source.table.defer(row + 1, number);
  }
};

/// Wakes a polygon in a full table. The records of polygons that have ended are freed first; if there are none, the
/// farthest, or the nearest, polygon is left out.
template <ActiveEdgeTable::Evicted Chosen>
LeftOut wake_in_full_table(ActiveEdgeTable& edges, const PolygonSource& source, Link number, std::int32_t row,
                           BoundMargin margin) {
  edges.reap(row);
  AwakePolygon candidate;
  const std::int32_t column = wake(candidate, source, number, row, margin);
  AwakePolygon* record = edges.take();
  LeftOut left_out;
  if (record == nullptr) {
    record = edges.evict<Chosen>(candidate.nearest, number);
    const AwakePolygon& waits = record == nullptr ? candidate : *record;
    left_out = {waits.number, waits.end_row};
  }
  if (record != nullptr) {
    *record = candidate;
    edges.enter(*record, column);
  }
  return left_out;
}

/// Wakes an opaque polygon in a full table. False if the farthest polygon had to be left out for a row.
[[gnu::noinline]] bool wake_before_the_farthest(ActiveEdgeTable& edges, const PolygonSource& source, Link number,
                                                std::int32_t row, BoundMargin margin) {
  const LeftOut left_out = wake_in_full_table<ActiveEdgeTable::Evicted::farthest>(edges, source, number, row, margin);
  if (left_out.number == no_link) return true;
  left_out.defer(source, row);
  return false;
}

/// Wakes a layer in a full table. If there is no room, the nearest layer joins the chain `waiting`.
[[gnu::noinline]] void wake_behind_the_nearest(ActiveEdgeTable& layers, const PolygonSource& source, Link number,
                                               std::int32_t row, BoundMargin margin, Link& waiting) {
  const LeftOut left_out = wake_in_full_table<ActiveEdgeTable::Evicted::nearest>(layers, source, number, row, margin);
  if (left_out.number == no_link) return;
  source.table.references[left_out.number].next = waiting;
  waiting = left_out.number;
}

void wake_layer(ActiveEdgeTable& layers, const PolygonSource& source, Link number, std::int32_t row, BoundMargin margin,
                Link& waiting) {
  if (AwakePolygon* record = layers.take(); record != nullptr)
    layers.enter(*record, wake(*record, source, number, row, margin));
  else
    wake_behind_the_nearest(layers, source, number, row, margin, waiting);
}

}  // namespace

bool wake_bucket(ActiveEdgeTable& edges, const PolygonSource& source, std::int32_t row, BoundMargin margin) {
  PolygonTable& table = source.table;
  const Link last = table.buckets[static_cast<std::size_t>(row)];
  if (last == no_link) return true;
  bool room = true;
  Link number = table.references[last].next;
  for (;;) {
    const Link following = table.references[number].next;  // read before waking, which may defer the polygon
    if (AwakePolygon* record = edges.take(); __builtin_expect(record != nullptr, true))
      edges.enter(*record, wake(*record, source, number, row, margin));
    else if (!wake_before_the_farthest(edges, source, number, row, margin))
      room = false;
    if (number == last) return room;
    number = following;
  }
}

// A separate loop, since choosing a table would cost renderers without layers some instructions for each row.
WokenWithLayers wake_bucket(ActiveEdgeTable& edges, ActiveEdgeTable& layers, const PolygonSource& source,
                            std::int32_t row, BoundMargin margin) {
  WokenWithLayers woken{true, no_link};
  PolygonTable& table = source.table;
  const Link last = table.buckets[static_cast<std::size_t>(row)];
  if (last == no_link) return woken;
  for (Link number = table.references[last].next;;) {
    const Link following = table.references[number].next;
    if (table.groups[table.find_group(number)].see_through)
      wake_layer(layers, source, number, row, margin, woken.waiting);
    else if (AwakePolygon* record = edges.take(); record != nullptr)
      edges.enter(*record, wake(*record, source, number, row, margin));
    else if (!wake_before_the_farthest(edges, source, number, row, margin))
      woken.all_opaque = false;
    if (number == last) return woken;
    number = following;
  }
}

Link wake_waiting(ActiveEdgeTable& layers, const PolygonSource& source, Link waiting, std::int32_t row,
                  BoundMargin margin) {
  Link again = no_link;
  while (waiting != no_link) {
    const Link number = waiting;
    waiting = source.table.references[number].next;
    wake_layer(layers, source, number, row, margin, again);
  }
  return again;
}

void defer_waiting(const PolygonSource& source, Link waiting, std::int32_t row) {
  while (waiting != no_link) {
    const Link number = waiting;
    waiting = source.table.references[number].next;
    const PolygonGroup& group = source.table.groups[source.table.find_group(number)];
    const std::int32_t end = row_range({source.table, group, number}).end;
    LeftOut{number, end < source.viewport.height ? end : source.viewport.height}.defer(source, row);
  }
}

}  // namespace spanline
