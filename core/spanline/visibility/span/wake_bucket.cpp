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

}  // namespace

bool wake_bucket(ActiveEdgeTable& edges, const PolygonSource& source, std::int32_t row, BoundMargin margin) {
  PolygonTable& table = source.table;
  const Link last = table.buckets[static_cast<std::size_t>(row)];
  if (last == no_link) return true;
  bool room = true;
  Link number = table.references[last].next;
  for (;;) {
    const Link following = table.references[number].next;  // waking may defer the polygon
    if (AwakePolygon* record = edges.take(); __builtin_expect(record != nullptr, true))
      edges.enter(*record, wake(*record, source, number, row, margin));
    else if (!wake_in_full_table(edges, source, number, row, margin))
      room = false;
    if (number == last) return room;
    number = following;
  }
}

// A loop of its own: the choice of a table would cost opaque renderers some instructions a row.
WokenWithLayers wake_bucket(ActiveEdgeTable& edges, ActiveEdgeTable& layers, const PolygonSource& source,
                            std::int32_t row, BoundMargin margin) {
  WokenWithLayers woken{true, true};
  PolygonTable& table = source.table;
  const Link last = table.buckets[static_cast<std::size_t>(row)];
  if (last == no_link) return woken;
  for (Link number = table.references[last].next;;) {
    const Link following = table.references[number].next;
    const bool is_layer = table.groups[table.find_group(number)].see_through;
    ActiveEdgeTable& entered = is_layer ? layers : edges;
    if (AwakePolygon* record = entered.take(); record != nullptr)
      entered.enter(*record, wake(*record, source, number, row, margin));
    else if (!wake_in_full_table(entered, source, number, row, margin))
      (is_layer ? woken.all_layers : woken.all_opaque) = false;
    if (number == last) return woken;
    number = following;
  }
}

}  // namespace spanline
