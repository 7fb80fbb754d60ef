#pragma once
#include <cstdint>
#include <utility>

#include "spanline/raster/screen_vertex.hpp"

namespace spanline {

/// A triangle as the rasteriser takes it. `a` is a topmost vertex; b and c are ordered so that a → b is the right edge
/// and a → c the left one (clockwise on screen, y down). Differences are in sixteenths of a pixel, |d| ≤ 65,535.
struct Triangle {
  const ScreenVertex* a;
  const ScreenVertex* b;
  const ScreenVertex* c;
  std::int32_t ax, ay;    ///< biased position of a, sixteenths of a pixel
  std::int32_t dx1, dy1;  ///< b − a; dy1 ≥ 0
  std::int32_t dx2, dy2;  ///< c − a; dy2 ≥ 0

  /// Makes a triangle from corners in any rotation: the topmost vertex becomes `a`, and the orientation is kept.
  [[nodiscard]] static inline Triangle from(const ScreenVertex* p, const ScreenVertex* q, const ScreenVertex* r) {
    if (q->y < p->y) {
      if (r->y < q->y) {
        std::swap(p, r);
        std::swap(q, r);
      } else {
        std::swap(p, q);
        std::swap(q, r);
      }
    } else if (r->y < p->y) {
      std::swap(p, r);
      std::swap(q, r);
    }
    const std::int32_t ax = p->x, ay = p->y;
    return {p, q, r, ax, ay, q->x - ax, q->y - ay, r->x - ax, r->y - ay};
  }

  /// Twice the signed area in square sixteenths of a pixel, positive if clockwise. Requires |d| < 2^15.
  [[nodiscard]] std::int32_t doubled_area() const { return dx1 * dy2 - dx2 * dy1; }
  [[nodiscard]] std::int64_t wide_doubled_area() const {
    return static_cast<std::int64_t>(dx1) * dy2 - static_cast<std::int64_t>(dx2) * dy1;
  }

  /// Exchanges b and c, which reverses the orientation.
  void flip() {
    std::swap(b, c);
    std::swap(dx1, dx2);
    std::swap(dy1, dy2);
  }
};

/// The edge between b and c, which follows a → b on the right or a → c on the left. All lengths are in sixteenths of a
/// pixel.
struct ThirdEdge {
  bool on_right;
  std::int32_t x, y;    ///< its upper end, relative to a
  std::int32_t dx, dy;  ///< from its upper to its lower end; dy ≥ 0

  [[nodiscard]] static inline ThirdEdge of(const Triangle& t) {
    if (t.dy1 < t.dy2) return {true, t.dx1, t.dy1, t.dx2 - t.dx1, t.dy2 - t.dy1};
    return {false, t.dx2, t.dy2, t.dx1 - t.dx2, t.dy1 - t.dy2};
  }
};

}  // namespace spanline
