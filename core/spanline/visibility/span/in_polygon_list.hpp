#pragma once
#include <cstdint>

#include "spanline/visibility/span/depth_order.hpp"

namespace spanline {

/// The polygon in front from some column on: it shows until `change`, where it ends or another comes before it.
struct FrontPolygon {
  AwakePolygon* polygon;
  std::int32_t end;     ///< its own last column + 1
  std::int32_t change;  ///< ≤ end

  static constexpr std::int32_t never = std::int32_t{1} << 30;  ///< `change` of the background
};

/// The in-polygon list IPL of a row: polygons that have begun, have not been seen to end, and are not the one in front.
/// Unsorted: a visibility decision walks it once and unlinks what has ended on the way.
template <class Order>
class InPolygonList {
 public:
  /// `order` stands on the row that is swept.
  explicit InPolygonList(Order& order) : order_(order) {}

  void clear() {
    first_ = nullptr;
    nearest_ = ~std::uint32_t{0};
  }
  [[nodiscard]] bool empty() const { return first_ == nullptr; }
  /// Whether a member may come before a polygon with this farther bound.
  [[nodiscard]] bool reaches(std::uint32_t farthest) const { return nearest_ <= farthest; }
  void push(AwakePolygon& polygon) {
    polygon.next = first_;
    first_ = &polygon;
    if (polygon.nearest < nearest_) nearest_ = polygon.nearest;
  }

  /// `front` ended at `column`, or another polygon comes before it there: the polygon that is in front from there on,
  /// taken out of the list; the background if there is none.
  [[nodiscard, gnu::noinline]] FrontPolygon next_front(AwakePolygon& front, std::int32_t end, std::int32_t column) {
    if (column < end) push(front);
    AwakePolygon* const next = take_front(column);
    if (next == nullptr) return {nullptr, 0, FrontPolygon::never};
    const std::int32_t next_end = next->right;
    return {next, next_end, reaches(next->farthest) ? first_crossing(*next, column, next_end) : next_end};
  }

  /// The first column right of `column` and left of `end` where a member comes before `front`, which is in front at
  /// `column`; `end` if there is none.
  [[nodiscard, gnu::noinline]] std::int32_t first_crossing(AwakePolygon& front, std::int32_t column,
                                                           std::int32_t end) const {
    for (AwakePolygon* polygon = first_; polygon != nullptr; polygon = polygon->next) {
      if (polygon->nearest > front.farthest) continue;
      const std::int32_t last = (polygon->right < end ? polygon->right : end) - 1;
      if (last > column && order_.nearer(*polygon, front, last)) end = order_.crossing(front, *polygon, column, last);
    }
    return end;
  }

 private:
  /// Takes out the polygon that is in front at `column`, and all that end there or left of it; null if none is left.
  AwakePolygon* take_front(std::int32_t column) {
    AwakePolygon *kept = nullptr, *front = nullptr;
    std::uint32_t nearest = ~std::uint32_t{0};
    for (AwakePolygon* polygon = first_; polygon != nullptr;) {
      AwakePolygon* const following = polygon->next;
      if (polygon->right > column) {
        if (front == nullptr) {
          front = polygon;
        } else {
          AwakePolygon* behind = polygon;
          if (order_.in_front(*polygon, *front, column)) {
            behind = front;
            front = polygon;
          }
          behind->next = kept;
          kept = behind;
          if (behind->nearest < nearest) nearest = behind->nearest;
        }
      }
      polygon = following;
    }
    first_ = kept;
    nearest_ = nearest;
    return front;
  }

  AwakePolygon* first_ = nullptr;
  std::uint32_t nearest_ = ~std::uint32_t{0};  ///< no member's nearer bound is less
  Order& order_;
};

}  // namespace spanline
