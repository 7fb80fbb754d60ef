#pragma once
#include <cstdint>

#include "spanline/visibility/span/active_edge_table.hpp"
#include "spanline/visibility/span/depth_order.hpp"

namespace spanline {

/// Draws the see-through polygons (layers) of a row over the visible spans of the opaque polygons.
///
/// Layers have their own active-edge table and hide nothing, so the sweep of the opaque polygons runs as without them.
/// A visible span is cut into pieces where a layer begins or ends, and where two layers, or a layer and the opaque
/// polygon, cross in depth. Inside a piece the order by (depth, number) is the same at every pixel. The layers in front
/// of the opaque polygon are drawn over it from the farthest to the nearest, so no sorting per pixel is needed.
///
/// It suffices to compare neighbours in the order to find the next change. Depths are integer-linear along the row and
/// the order is strict, so two polygons exchange places at most once. Neighbours that are in order at both ends of a
/// piece are therefore in order throughout, and then so are all layers.
///
/// `Owner` draws the pieces (`layer`) and is notified of each polygon that has columns on the row (`begins`).
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

  /// Whether a layer may cover columns left of `end`. Calls go from left to right.
  [[nodiscard]] bool reaches(std::int32_t end) const { return open_ != nullptr || awake_key::column(*keys_) < end; }

  /// Draws the layers in front of `front` over [begin, end). `front` is the visible opaque polygon, or null for the
  /// background. Calls go from left to right.
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
  /// Opens the layers that begin at or left of `column`, and removes those that have ended. Output: the column where
  /// the next layer begins or ends, at most `end`.
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

  /// Sorts the open layers at `column`, the farthest first, by insertion. They are nearly sorted after the previous
  /// piece, and nearly in reverse order where many begin at once. So the search for a layer's place starts at the layer
  /// inserted last, or else at the head of a list with the nearest first, which is reversed at the end.
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

  /// The farthest layer in front of `front` at `column`; null if there is none.
  [[nodiscard]] AwakePolygon* first_before(AwakePolygon* front, std::int32_t column) {
    AwakePolygon* layer = open_;
    if (front != nullptr)
      while (layer != nullptr && order_.in_front(*front, *layer, column)) layer = layer->next;
    return layer;
  }

  /// The first column in (begin, end) where the order of the layers and `front` differs from that at `begin`; `end` if
  /// there is none. Layers are sorted at `begin`.
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
  /// As until_change, for two neighbours.
  [[nodiscard]] std::int32_t until_exchange(AwakePolygon& farther, AwakePolygon& nearer, std::int32_t begin,
                                            std::int32_t end) {
    const std::int32_t last = end - 1;
    if (last <= begin || !order_.in_front(farther, nearer, last)) return end;
    return order_.crossing(nearer, farther, begin, last);
  }

  Owner& owner_;
  DepthOrder<typename Owner::DepthFormat, Owner::counting, Owner::crossings_counter> order_;
  const AwakeKey* keys_ = nullptr;  ///< key of the first layer that is not open yet
  std::byte* records_ = nullptr;
  AwakePolygon* open_ = nullptr;  ///< layers that have begun and may not have ended; sorted by `sort`
};

}  // namespace spanline
