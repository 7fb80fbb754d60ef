#include "spanline/visibility/span/active_edge_table.hpp"

#include "spanline/raster/link.hpp"

namespace spanline {

void ActiveEdgeTable::begin_frame(std::span<AwakeKey> keys, std::byte* records, std::size_t capacity,
                                  std::size_t stride) {
  current_ = keys.data();
  next_ = keys.data() + capacity + 2;
  for (AwakeKey* array : {current_, next_}) {
    array[0] = 0;  // a sentinel below all keys, where insertion stops
    array[1] = array[capacity + 1] = awake_key::end;
  }
  entering_ = next_ + capacity + 1;
  records_ = records;
  capacity_ = capacity;
  stride_ = stride;
  free_ = nullptr;
  untouched_ = static_cast<std::uint32_t>(capacity);
  awake_ = peak_ = 0;
}

void ActiveEdgeTable::reap(std::int32_t row) {
  AwakeKey* write = current_ + 1;
  for (const AwakeKey* read = current_ + 1; *read != awake_key::end; ++read) {
    AwakePolygon& polygon = at(*read);
    if (polygon.end_row <= row)
      release(polygon);
    else
      *write++ = *read;
  }
  *write = awake_key::end;
}

void ActiveEdgeTable::stand_back(const PolygonSource& source, std::int32_t row) {
  for (const AwakeKey* key = current_ + 1; *key != awake_key::end; ++key) {
    AwakePolygon& polygon = at(*key);
    if (row < polygon.end_row) source.table.defer(row, polygon.number);
    release(polygon);
  }
  current_[1] = awake_key::end;
}

template <ActiveEdgeTable::Evicted Chosen>
AwakePolygon* ActiveEdgeTable::evict(std::uint32_t nearest, Link number) {
  // The low bits of a bound are the outcode of the nearest corner and are no part of its depth.
  const auto without_outcode = [](std::uint32_t bound) { return bound & ~std::uint32_t{0xff}; };
  nearest = without_outcode(nearest);
  AwakeKey* chosen = nullptr;
  const auto look = [&](AwakeKey* key) {
    const AwakePolygon& polygon = at(*key);
    const std::uint32_t bound = without_outcode(polygon.nearest);
    const bool in_front = bound < nearest || (bound == nearest && polygon.number < number);
    if (in_front != (Chosen == Evicted::nearest)) return;
    nearest = bound;
    number = polygon.number;
    chosen = key;
  };
  for (AwakeKey* key = current_ + 1; *key != awake_key::end; ++key) look(key);
  const AwakeKey* const first_entering = entering_;
  for (AwakeKey* key = entering_; *key != awake_key::end; ++key) look(key);
  if (chosen == nullptr) return nullptr;
  AwakePolygon& polygon = at(*chosen);
  if (chosen >= first_entering && chosen < next_ + capacity_ + 1) {
    for (; chosen != entering_; --chosen) chosen[0] = chosen[-1];
    ++entering_;
  } else {
    do chosen[0] = chosen[1];
    while (*chosen++ != awake_key::end);
  }
  return &polygon;
}
template AwakePolygon* ActiveEdgeTable::evict<ActiveEdgeTable::Evicted::farthest>(std::uint32_t nearest, Link number);
template AwakePolygon* ActiveEdgeTable::evict<ActiveEdgeTable::Evicted::nearest>(std::uint32_t nearest, Link number);

std::uint32_t ActiveEdgeTable::step(const PolygonSource& source, std::int32_t row) {
  std::uint32_t repairs = 0;
  std::byte* const records = records_;
  const AwakeKey* read = current_ + 1;
  AwakeKey* write = next_ + 1;
  const AwakeKey* entering = entering_;
  AwakeKey waiting = *entering;
  const auto insert = [&](AwakeKey key) __attribute__((always_inline)) {
    AwakeKey* place = write++;
    while (__builtin_expect(place[-1] > key, false)) {
      place[0] = place[-1];
      --place;
      ++repairs;
    }
    *place = key;
  };
  for (;;) {
    const AwakeKey old_key = *read++;
    if (old_key == awake_key::end) break;
    const std::size_t offset = awake_key::offset(old_key);
    AwakePolygon& polygon = *reinterpret_cast<AwakePolygon*>(records + offset);
    std::int32_t column;
    if (__builtin_expect(polygon.turn_row == row, false)) {
      if (!turn(polygon, source, row)) {
        release(polygon);
        continue;
      }
      column = polygon.fraction_bits != 0 ? place_columns(polygon) : cut_columns(polygon, source.viewport.width);
    } else if (__builtin_expect(polygon.fraction_bits != 0, true)) {
      polygon.fixed.left += polygon.fixed.left_step;
      polygon.fixed.right += polygon.fixed.right_step;
      column = place_columns(polygon);
    } else {
      polygon.large.left.next_row();
      polygon.large.right.next_row();
      column = cut_columns(polygon, source.viewport.width);
    }
    const AwakeKey key = awake_key::make(column, offset);
    while (waiting < key) {
      insert(waiting);
      waiting = *++entering;
    }
    insert(key);
  }
  while (waiting != awake_key::end) {
    insert(waiting);
    waiting = *++entering;
  }
  *write = awake_key::end;
  AwakeKey* const written = next_;
  next_ = current_;
  current_ = written;
  entering_ = next_ + capacity_ + 1;
  return repairs;
}

}  // namespace spanline
