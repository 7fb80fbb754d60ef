#pragma once
#include <cstdint>

#include "spanline/visibility/span/active_edge_table.hpp"
#include "spanline/visibility/span/depth_order.hpp"

namespace spanline {

/// The see-through polygons of a row, laid over the spans that the opaque ones have left visible.
///
/// They have an active-edge table of their own and never hide anything, so that the sweep of the opaque polygons is the
/// one that there is without them. A visible span is cut where a layer begins or ends and where two layers, or a layer
/// and the opaque polygon, change places; inside a piece the order by (depth, number) is the same at every pixel, and
/// the layers in front of the opaque polygon are laid over it from the farthest to the nearest. Nobody sorts pixels.
///
/// Why neighbours suffice to find the next change: depths are integer-linear along the row and the order strict, so two
/// polygons change places once at most; neighbours of the order that are in order at both ends of a piece are so
/// between them, and with all neighbours everything is in order.
///
/// `Owner` takes pieces (`layer`), and is told of polygons that have columns on the row (`begins`).
template <class Owner>
class LayerSweep {
 public:
  explicit LayerSweep(Owner& owner) : owner_(owner), order_(owner, owner.target.counters) {}

  void begin_row(const ActiveEdgeTable& table, std::int32_t row) {
    keys_ = table.sorted();
    records_ = table.records();
    open_ = nullptr;
    order_.move_to(row);
  }

  /// Whether a layer may lie over columns left of `end`; asked from left to right.
  [[nodiscard]] bool reaches(std::int32_t end) const { return open_ != nullptr || awake_key::column(*keys_) < end; }

  /// Lays what is in front of `front`, the visible opaque polygon or null for the background, over [begin, end). Calls
  /// go from left to right.
  void over(AwakePolygon* front, std::int32_t begin, std::int32_t end) {
    while (begin < end) {
      std::int32_t stop = open_and_close(begin, end);
      if (open_ != nullptr) {
        sort(begin);
        stop = until_change(front, begin, stop);
        for (AwakePolygon* layer = first_before(front, begin); layer != nullptr; layer = layer->next)
          owner_.layer(*layer, begin, stop);
      }
      begin = stop;
    }
  }

 private:
  /// Takes in the layers that begin at `column` or left of it, and drops those that have ended. Output: where the next
  /// one begins or ends, `end` at most.
  std::int32_t open_and_close(std::int32_t column, std::int32_t end) {
    for (; awake_key::column(*keys_) <= column; ++keys_) {
      AwakePolygon& polygon = *reinterpret_cast<AwakePolygon*>(records_ + awake_key::offset(*keys_));
      if (polygon.right <= awake_key::column(*keys_)) continue;
      owner_.begins(polygon);
      polygon.next = open_;
      open_ = &polygon;
    }
    std::int32_t stop = awake_key::column(*keys_) < end ? awake_key::column(*keys_) : end;
    for (AwakePolygon** link = &open_; *link != nullptr;) {
      const std::int32_t right = (*link)->right;
      if (right <= column) {
        *link = (*link)->next;
        continue;
      }
      if (right < stop) stop = right;
      link = &(*link)->next;
    }
    return stop;
  }

  /// Sorts the open layers, the farthest first. They are nearly so from the piece before, or nearly the other way round
  /// where many begin at once: each is inserted near the one before it or at the head of a list with the nearest first,
  /// which is then turned round.
  void sort(std::int32_t column) {
    AwakePolygon *nearest = nullptr, *last = nullptr;
    while (open_ != nullptr) {
      AwakePolygon* const polygon = open_;
      open_ = polygon->next;
      AwakePolygon** link = &nearest;
      if (last != nullptr && order_.in_front(*last, *polygon, column)) link = &last->next;
      const bool before_all = last == nearest && link == &nearest;
      if (!before_all)
        while (*link != nullptr && order_.in_front(**link, *polygon, column)) link = &(*link)->next;
      polygon->next = *link;
      *link = last = polygon;
    }
    while (nearest != nullptr) {
      AwakePolygon* const polygon = nearest;
      nearest = polygon->next;
      polygon->next = open_;
      open_ = polygon;
    }
  }

  /// The farthest layer in front of `front` at `column`.
  [[nodiscard]] AwakePolygon* first_before(AwakePolygon* front, std::int32_t column) {
    AwakePolygon* layer = open_;
    if (front != nullptr)
      while (layer != nullptr && order_.in_front(*front, *layer, column)) layer = layer->next;
    return layer;
  }

  /// The first column right of `begin` and left of `end` where layers, sorted at `begin`, and `front` are in another
  /// order; `end` if there is none.
  [[nodiscard]] std::int32_t until_change(AwakePolygon* front, std::int32_t begin, std::int32_t end) {
    AwakePolygon* const before_front = first_before(front, begin);
    AwakePolygon* farther = nullptr;
    for (AwakePolygon* layer = open_;; layer = layer->next) {
      if (front != nullptr && layer == before_front) {
        if (farther != nullptr) end = until_exchange(*farther, *front, begin, end);
        farther = front;
      }
      if (layer == nullptr) return end;
      if (farther != nullptr) end = until_exchange(*farther, *layer, begin, end);
      farther = layer;
    }
  }
  [[nodiscard]] std::int32_t until_exchange(AwakePolygon& farther, AwakePolygon& nearer, std::int32_t begin,
                                            std::int32_t end) {
    const std::int32_t last = end - 1;
    if (last <= begin || !order_.in_front(farther, nearer, last)) return end;
    return order_.crossing(nearer, farther, begin, last);
  }

  Owner& owner_;
  DepthOrder<typename Owner::DepthFormat, Owner::counting> order_;
  const AwakeKey* keys_ = nullptr;  ///< the first that has not begun
  std::byte* records_ = nullptr;
  AwakePolygon* open_ = nullptr;  ///< begun and not seen to end; the farthest first where a piece was last sorted
};

}  // namespace spanline
