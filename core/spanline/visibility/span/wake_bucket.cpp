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

/// Wakes a layer; where the table is full the nearest joins those that wait.
void wake_layer(ActiveEdgeTable& layers, const PolygonSource& source, Link number, std::int32_t row, BoundMargin margin,
                Link& waiting) {
  if (AwakePolygon* record = layers.take(); record != nullptr) {
    layers.enter(*record, wake(*record, source, number, row, margin));
    return;
  }
  layers.reap(row);
  AwakePolygon candidate;
  const std::int32_t column = wake(candidate, source, number, row, margin);
  AwakePolygon* record = layers.take();
  if (record == nullptr) {
    record = layers.evict_nearest(candidate.nearest, number);
    const Link waits = record == nullptr ? number : record->number;
    source.table.references[waits].next = waiting;
    waiting = waits;
  }
  if (record != nullptr) {
    *record = candidate;
    layers.enter(*record, column);
  }
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
    else if (!wake_in_full_table(edges, source, number, row, margin))
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
    const auto [a, b, c] = source.table.corners(source.table.groups[source.table.find_group(number)], number).corner;
    const std::int32_t end = row_at(a->y > b->y ? (a->y > c->y ? a->y : c->y) : (b->y > c->y ? b->y : c->y)) - row_bias;
    if (row + 1 < (end < source.viewport.height ? end : source.viewport.height)) source.table.defer(row + 1, number);
  }
}

}  // namespace spanline
