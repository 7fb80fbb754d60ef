#pragma once
#include <algorithm>
#include <cstdint>

#include "spanline/visibility/span/active_edge_table.hpp"
#include "spanline/visibility/span/depth_order.hpp"
#include "spanline/visibility/span/in_polygon_list.hpp"

namespace spanline {

/// Finds the visible spans of a row (lecture 002, "Spanning Scan Line Algorithm"), with one visibility decision for
/// each span. Depths are compared only where bounds cannot decide. Where two polygons cross, the exact pixel is found
/// (a false edge of lecture 002).
///
/// Invariant: `front` is the nearest polygon on [begin, change), and the in-polygon list holds every other polygon that
/// has begun and may still become visible. Depth is integer-linear along the row and the order by (depth, number) is
/// strict, so two polygons exchange places at most once.
///
/// `Owner` is the `PolygonSource`. It draws spans (`span`, and `background` where there is no polygon), may put a
/// polygon to sleep that another one hides (`hidden`), and is notified of each polygon that has columns on the row
/// (`begins`).
template <class Owner>
class RowSweep {
 public:
  RowSweep(Owner& owner, std::int32_t width) : owner_(owner), order_(owner, owner.target.counters), width_(width) {}

  /// Sweeps the sorted polygons of a row.
  void run(const ActiveEdgeTable& table, std::int32_t row) {
    const AwakeKey* keys = table.sorted();
    std::byte* const records = table.records();
    order_.move_to(row);
    list_.clear();
    AwakePolygon* front = nullptr;
    std::int32_t begin = 0, end = 0, change = FrontPolygon::never;
    for (;;) {
      const AwakeKey key = *keys++;
      const std::int32_t left = awake_key::column(key);
      while (change <= left) {
        owner_.span(*front, begin, change);
        begin = change;
        if (__builtin_expect(change == end && list_.empty(), true)) {
          front = nullptr;
          change = FrontPolygon::never;
          break;
        }
        const FrontPolygon next = list_.next_front(*front, end, change);
        front = next.polygon;
        end = next.end;
        change = next.change;
      }
      if (key == awake_key::end) break;
      AwakePolygon& polygon = *reinterpret_cast<AwakePolygon*>(records + awake_key::offset(key));
      const std::int32_t right = polygon.right;
      if (left >= right) continue;
      owner_.begins(polygon);
      if (front == nullptr) {
        if (left > begin) owner_.background(begin, left);
        front = &polygon;
        begin = left;
        change = end = right;
        continue;
      }
      if (polygon.nearest > front->farthest) {
        if (right > end)
          list_.push(polygon);
        else
          owner_.hidden(polygon, *front);
        continue;
      }
      bool front_at_end = true;  // whether the new polygon is in front at the last column that both have
      const bool surely = polygon.farthest < front->nearest;
      if (!surely) {
        const std::int32_t last = (right < end ? right : end) - 1;
        const bool front_at_left = order_.nearer(polygon, *front, left);
        front_at_end = last > left ? order_.nearer(polygon, *front, last) : front_at_left;
        if (!front_at_left) {
          if (front_at_end) change = std::min(change, order_.crossing(*front, polygon, left, last));
          if (front_at_end || right > end) list_.push(polygon);
          continue;
        }
      }
      if (left > begin) span_before(*front, begin, left);
      if (!front_at_end || end > right)
        list_.push(*front);
      else if (surely && left == begin)
        owner_.hidden(*front, polygon);
      front = &polygon;
      begin = left;
      change = end = right;
      if (list_.reaches(polygon.farthest)) change = list_.first_crossing(polygon, left, end);
    }
    if (begin < width_) owner_.background(begin, width_);
  }

 private:
  /// Draws a span that ends because another polygon passes in front. Not inlined, since the loop already contains one
  /// inlined call of `span`.
  [[gnu::noinline]] void span_before(AwakePolygon& front, std::int32_t begin, std::int32_t end) {
    owner_.span(front, begin, end);
  }

  Owner& owner_;
  using Order = DepthOrder<typename Owner::DepthFormat, Owner::counting, Owner::crossings_counter>;
  Order order_;
  InPolygonList<Order> list_{order_};
  std::int32_t width_;
};

}  // namespace spanline
