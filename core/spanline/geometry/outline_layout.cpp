#include "spanline/geometry/outline_layout.hpp"

#include <algorithm>

#include "spanline/raster/signed_area.hpp"

namespace spanline {
namespace {

std::int64_t magnitude_of(std::int64_t value) { return value < 0 ? -value : value; }

// The parts of `lay_out` are not inlined, so that their variables are not on the stack together.

/// Finds the slack of the plane, in units of the depth. False if the plane could leave the range of depths.
[[gnu::noinline]] bool plane_stays_in_range(const Outline& outline, const OutlineShape& shape, int depth_bits,
                                            unsigned& slack) {
  const ScreenVertex &a = outline[0], &b = outline[shape.reference], &c = outline[shape.reference + 1];
  const auto depth = [&](const ScreenVertex& v) {
    return static_cast<std::int32_t>(v.depth_word >> (32 - depth_bits));
  };
  const auto area = [](const ScreenVertex& p, const ScreenVertex& q, const ScreenVertex& r) {
    return signed_area<std::int64_t>(p, q, r);
  };
  // Depths are below 2^24 and areas below 2^34, so the sum of three products is below 2^60.
  const std::int32_t z = depth(a), to_b = depth(b) - z, to_c = depth(c) - z;
  slack = 0;
  std::int32_t low = 1 << 24, high = 0;
  for (unsigned i = 1; i < outline.count(); ++i) {
    if (i == shape.reference || i == shape.reference + 1) continue;
    const ScreenVertex& p = outline[i];
    low = std::min(low, depth(p));
    high = std::max(high, depth(p));
    const std::int64_t off = to_b * area(a, p, c) + to_c * area(a, b, p) - (depth(p) - z) * shape.area;
    while (magnitude_of(off) > magnitude_of(shape.area) << slack) {
      if (++slack == static_cast<unsigned>(depth_bits)) return false;
    }
  }
  return !outline_layout::reaches_out(low, high, slack, depth_bits);
}

}  // namespace

OutlineShape shape_of(const Outline& outline) {
  const auto area = [&](unsigned a, unsigned b, unsigned c) {
    return signed_area<std::int64_t>(outline[a], outline[b], outline[c]);
  };
  const unsigned last = outline.count() - 1;
  bool clockwise = false, counter_clockwise = false;
  const auto note = [&](std::int64_t doubled) {
    clockwise |= doubled > 0;
    counter_clockwise |= doubled < 0;
  };
  unsigned reference = 1;
  std::int64_t reference_area = 0, largest = -1;
  for (unsigned i = 1; i < last; ++i) {
    const std::int64_t doubled = area(0, i, i + 1), size = magnitude_of(doubled);
    note(doubled);
    if (size > largest) {
      largest = size;
      reference = i;
      reference_area = doubled;
    }
  }
  // The turns at corners 1 and `last` are those of the fan's first and last triangles.
  for (unsigned i = 1; i + 2 <= last; ++i) note(area(i, i + 1, i + 2));
  note(area(last, 0, 1));
  Turn turn = Turn::none;
  if (clockwise != counter_clockwise) turn = clockwise ? Turn::clockwise : Turn::counter_clockwise;
  return {turn, reference, reference_area};
}

ActiveTriangle::Size outline_layout::wide_class_of(const Outline& outline, std::int32_t width, std::int32_t height) {
  if (width > medium_triangle::max_width || height > medium_triangle::max_height) return ActiveTriangle::Size::large;
  for (unsigned i = 0; i < outline.count(); ++i) {
    const ScreenVertex &a = outline[i], &b = outline[outline.after(i)];
    if (!medium_triangle::steep(b.x - a.x, b.y - a.y)) return ActiveTriangle::Size::large;
  }
  return ActiveTriangle::Size::medium;
}

namespace {

/// Completes the layout of an outline whose reference triangle has this area.
[[gnu::noinline]] void place_by_box(const Outline& outline, std::int64_t area, OutlineLayout& layout) {
  using Size = ActiveTriangle::Size;
  outline_layout::Box box;
  box.begin(outline[0].x, outline[0].y);
  std::uint32_t codes = outline[0].depth_word;
  for (unsigned i = 1; i < outline.count(); ++i) {
    box.add(i, outline[i].x, outline[i].y);
    codes |= outline[i].depth_word;
  }
  constexpr std::uint32_t leaves = outcode_left | outcode_right | outcode_top | outcode_bottom;
  const std::int32_t top_x = outline[box.top_corner].x;
  Size size = Size::large;
  if ((codes & leaves) == 0)
    size = box.is_small(top_x, static_cast<std::int32_t>(area))
               ? Size::small
               : outline_layout::wide_class_of(outline, box.right - box.left, box.bottom - box.top);
  outline_layout::place(box, size, top_x, layout);
}

}  // namespace

OutlineFate lay_out(const Outline& outline, Cull cull, int depth_bits, OutlineLayout& layout) {
  const OutlineShape shape = shape_of(outline);
  if (shape.turn == Turn::none) return OutlineFate::fan;
  layout.clockwise = shape.turn == Turn::clockwise;
  if (cull == (layout.clockwise ? Cull::back : Cull::front)) return OutlineFate::culled;
  unsigned slack = 0;
  if (!plane_stays_in_range(outline, shape, depth_bits, slack)) return OutlineFate::fan;
  layout.slack = slack + static_cast<unsigned>(32 - depth_bits);
  layout.reference = shape.reference;

  place_by_box(outline, shape.area, layout);
  return OutlineFate::whole;
}

namespace {

/// Whether a plane meets a value at a corner. The shares are the areas that the corner makes with the other two of the
/// reference triangle. Values are below 2^16 and areas below 2^34.
struct Meeting {
  std::int64_t whole, share_b, share_c;

  [[nodiscard, gnu::noinline]] bool holds(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t value) const {
    constexpr std::int64_t tolerance = 256;
    const std::int64_t met = a * whole + (b - a) * share_b + (c - a) * share_c;
    const std::int64_t size = magnitude_of(whole), at = whole < 0 ? -met : met;
    return magnitude_of(at - value * size) <= tolerance * size && at >= vertex_shade::lowest_intensity * size &&
           at <= vertex_shade::highest_intensity * size;
  }
};

}  // namespace

bool shades_are_linear(const Outline& outline, unsigned reference, const std::uint32_t* shades,
                       vertex_shade::Kind kind) {
  bool equal = true;
  for (unsigned i = 1; i < outline.count(); ++i) equal = equal && shades[i] == shades[0];
  if (equal) return true;
  const ScreenVertex &a = outline[0], &b = outline[reference], &c = outline[reference + 1];
  const auto area = [](const ScreenVertex& p, const ScreenVertex& q, const ScreenVertex& r) {
    return signed_area<std::int64_t>(p, q, r);
  };
  for (unsigned i = 1; i < outline.count(); ++i) {
    if (i == reference || i == reference + 1) continue;
    const Meeting meeting{area(a, b, c), area(a, outline[i], c), area(a, b, outline[i])};
    for (unsigned channel = 0; channel < vertex_shade::channels(kind); ++channel) {
      const auto value = [&](unsigned corner) { return vertex_shade::channel_16(kind, shades[corner], channel); };
      if (!meeting.holds(value(0), value(reference), value(reference + 1), value(i))) return false;
    }
  }
  return true;
}

}  // namespace spanline
