#pragma once
#include <cstdint>

#include "spanline/visibility/span/depth_order.hpp"

namespace spanline {

/// The polygon that is in front from some column on. It is visible up to `change`, where it ends or another polygon
/// passes in front.
struct FrontPolygon {
  AwakePolygon* polygon;
  std::int32_t end;     ///< column after the polygon's last
  std::int32_t change;  ///< column where the visible polygon changes, ≤ end

  static constexpr std::int32_t never = std::int32_t{1} << 30;  ///< `change` for the background, right of every picture
};

/// The in-polygon list IPL of a row (lecture 002): polygons that have begun, are not in front, and may still become
/// visible. The list is not sorted. A visibility decision walks it once and removes polygons that have ended.
template <class Order>
class InPolygonList {
 public:
  /// `order` compares polygons on the row that is swept.
  explicit InPolygonList(Order& order) : order_(order) {}

  void clear() {
    first_ = nullptr;
    nearest_ = ~std::uint32_t{0};
  }
  [[nodiscard]] bool empty() const { return first_ == nullptr; }
  /// Whether a member may be in front of a polygon with this farther bound somewhere.
  [[nodiscard]] bool reaches(std::uint32_t farthest) const { return nearest_ <= farthest; }
  void push(AwakePolygon& polygon) {
    polygon.next = first_;
    first_ = &polygon;
    if (polygon.nearest < nearest_) nearest_ = polygon.nearest;
  }

  /// Called where `front` ends or another polygon passes in front of it, at `column`. Returns the polygon that is in
  /// front from there on and removes it from the list; returns the background if there is none.
  [[nodiscard, gnu::noinline]] FrontPolygon next_front(AwakePolygon& front, std::int32_t end, std::int32_t column) {
    if (column < end) push(front);
    AwakePolygon* const next = take_front(column);
    if (next == nullptr) return {nullptr, 0, FrontPolygon::never};
    const std::int32_t next_end = next->right;
    return {next, next_end, reaches(next->farthest) ? first_crossing(*next, column, next_end) : next_end};
  }

  /// The first column in (column, end) where a member passes in front of `front`, which is in front at `column`; `end`
  /// if there is none.
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
  /// Removes the polygons that end at or left of `column`, and the one that is in front there, which is returned; null
  /// if none is left.
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

  AwakePolygon* first_ = nullptr;              ///< head of the list, linked by `next`
  std::uint32_t nearest_ = ~std::uint32_t{0};  ///< a lower bound of the members' `nearest`
  Order& order_;
};

}  // namespace spanline
