#pragma once
#include <cstdint>

#include "spanline/cpu/triangle_area.hpp"
#include "spanline/geometry/outline_layout.hpp"
#include "spanline/math/bits.hpp"

namespace spanline {

/// The parts of `lay_out` that find turn, reference triangle and slack, for four corners inside the viewport.
[[nodiscard]] OutlineFate lay_plane_of_quad(const Outline& quad, Cull cull, int depth_bits, OutlineLayout& layout,
                                            std::int32_t& area);

/// The same for a parallelogram, which needs one area alone.
[[nodiscard, gnu::always_inline]] inline OutlineFate lay_plane_of_parallelogram(const Outline& quad, Cull cull,
                                                                                int depth_bits, OutlineLayout& layout,
                                                                                std::int32_t& area) {
  area = narrow_area(quad[0], quad[1], quad[2]);
  if (area == 0) return OutlineFate::fan;
  layout.clockwise = area > 0;
  if (cull == (layout.clockwise ? Cull::back : Cull::front)) return OutlineFate::culled;
  const int shift = 32 - depth_bits;
  const auto depth = [&](unsigned i) { return static_cast<std::int32_t>(quad[i].depth_word >> shift); };
  const std::int32_t last = depth(3), off = depth(0) + depth(2) - depth(1) - last;
  unsigned slack = 0;
  while ((off < 0 ? -off : off) > 1 << slack) ++slack;
  if (outline_layout::reaches_out(last, last, slack, depth_bits)) return OutlineFate::fan;
  layout.slack = slack + static_cast<unsigned>(shift);
  layout.reference = 1;
  return OutlineFate::whole;
}

/// `lay_out` in a way of its own, for four corners inside the viewport.
[[nodiscard, gnu::always_inline]] inline OutlineFate lay_out_quad(const Outline& quad, Cull cull, int depth_bits,
                                                                  OutlineLayout& layout) {
  const ScreenVertex &a = quad[0], &b = quad[1], &c = quad[2], &d = quad[3];
  std::int32_t area;
  OutlineFate fate;
  // x and y are the halves of a word, and a carry from one to the other does no harm.
  if (position_word(a) + position_word(c) == position_word(b) + position_word(d)) {
    fate = lay_plane_of_parallelogram(quad, cull, depth_bits, layout, area);
  } else {
    OutlineLayout plane;
    std::int32_t own_area = 0;
    const Outline copy = quad;
    fate = lay_plane_of_quad(copy, cull, depth_bits, plane, own_area);
    layout = plane;
    area = own_area;
  }
  if (fate != OutlineFate::whole) return fate;

  outline_layout::Box box;
  box.begin(a.x, biased_y(a));
  box.add(1, b.x, biased_y(b));
  box.add(2, c.x, biased_y(c));
  box.add(3, d.x, biased_y(d));
  const std::int32_t top_x = quad[box.top_corner].x;
  ActiveTriangle::Size size = ActiveTriangle::Size::small;
  if (!box.is_small(top_x, area)) {
    const Outline copy = quad;
    size = outline_layout::wide_class_of(copy, box.right - box.left, box.bottom - box.top);
  }
  outline_layout::place(box, size, top_x, layout);
  return OutlineFate::whole;
}

}  // namespace spanline
