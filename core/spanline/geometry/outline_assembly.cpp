#include <algorithm>

#include "spanline/geometry/outline_layout.hpp"
#include "spanline/geometry/polygon_assembly.hpp"
#include "spanline/geometry/quad_layout.hpp"

namespace spanline {
namespace {

/// The outcodes of all corners and of any corner.
struct Codes {
  std::uint32_t all = 0xff, any = 0;
};
Codes codes_of(const Outline& outline) {
  Codes codes;
  for (unsigned i = 0; i < outline.count(); ++i) {
    codes.all &= outline[i].depth_word;
    codes.any |= outline[i].depth_word;
  }
  return codes;
}
bool is_outside(const Outline& outline) { return codes_of(outline).all != 0; }
bool needs_clipping(const Outline& outline) {
  const Codes codes = codes_of(outline);
  return codes.all == 0 && (codes.any & outcode_clip) != 0;
}

}  // namespace

OutlineFate lay_plane_of_quad(const Outline& quad, Cull cull, int depth_bits, OutlineLayout& layout,
                              std::int32_t& area) {
  const ScreenVertex &a = quad[0], &b = quad[1], &c = quad[2], &d = quad[3];
  // The four triangles of corners. Areas inside a viewport are below 2^30, and bcd = abc + acd − abd.
  const std::int32_t abc = narrow_area(a, b, c), acd = narrow_area(a, c, d), abd = narrow_area(a, b, d);
  const std::int32_t bcd = signed_word(word(abc) + word(acd) - word(abd));
  if ((abc | acd | abd | bcd) > 0)
    layout.clockwise = true;
  else if ((-abc | -acd | -abd | -bcd) > 0)
    layout.clockwise = false;
  else
    return OutlineFate::fan;
  if (cull == (layout.clockwise ? Cull::back : Cull::front)) return OutlineFate::culled;

  const auto size = [](std::int64_t value) { return value < 0 ? -value : value; };
  const auto depth = [&](unsigned i) { return static_cast<std::int32_t>(quad[i].depth_word >> (32 - depth_bits)); };
  const std::int32_t from = depth(0), depth_b = depth(1), depth_d = depth(3);
  const bool second = size(acd) > size(abc);
  area = second ? acd : abc;
  // The distance is the same number, of corner d from the plane of abc and of corner b from that of acd.
  const std::int64_t off =
      std::int64_t{depth(2) - from} * abd - std::int64_t{depth_b - from} * acd - std::int64_t{depth_d - from} * abc;
  unsigned slack = 0;
  while (size(off) > size(area) << slack) {
    if (++slack == static_cast<unsigned>(depth_bits)) return OutlineFate::fan;
  }
  const std::int32_t other = second ? depth_b : depth_d;
  if (outline_layout::reaches_out(other, other, slack, depth_bits)) return OutlineFate::fan;
  layout.slack = slack + static_cast<unsigned>(32 - depth_bits);
  layout.reference = second ? 2 : 1;
  return OutlineFate::whole;
}

/// Enters an outline into the table by `append`, if it has rows in the viewport and so many records are free.
template <class Append>
[[gnu::always_inline]] inline void PolygonAssembly::enter_by(const OutlineLayout& layout, Link records, Append append) {
  const std::int32_t bottom = viewport_.height + row_bias;
  const std::int32_t first = layout.first_row < row_bias ? row_bias : layout.first_row;
  if (first >= (layout.end_row < bottom ? layout.end_row : bottom)) return;
  if (!table_.fans.has_room(records)) {
    fans_wanted += records;
    return;
  }
  if (table_.polygon_count >= table_.references.size()) {
    ++polygons_wanted;
    return;
  }
  table_.append(band_of_row_(first - row_bias), static_cast<Link>(fan_flag | append()));
  ++counts.whole;
}

[[gnu::always_inline]] inline void PolygonAssembly::enter_inlined(const Outline& outline, const OutlineLayout& layout,
                                                                  Link triangle, Link polygon) {
  enter_by(
      layout, FanRecords::records_of_outline(outline.count()), [&]() __attribute__((always_inline)) {
        return table_.fans.append(outline, layout, triangle, polygon);
      });
}

/// As `enter`, for an outline that clipping has made, with room for the lines of its diagonals. Output: its record, or
/// no_link if it was not entered.
Link PolygonAssembly::enter_with_lines(const Outline& outline, const OutlineLayout& layout, Link triangle, Link polygon,
                                       unsigned lines) {
  Link record = no_link;
  enter_by(layout, FanRecords::records_of_outline(outline.count(), lines),
           [&] { return record = table_.fans.append(outline, layout, triangle, polygon, lines); });
  return record;
}

void PolygonAssembly::enter(const Outline& outline, const OutlineLayout& layout, Link triangle, Link polygon) {
  enter_inlined(outline, layout, triangle, polygon);
}

/// As `take_planar`, for four corners. Inlined, since most polygons that are one entry are such quads.
[[gnu::always_inline]] inline bool PolygonAssembly::take_quad(const Outline& quad, Link triangle, Link polygon) {
  if (((quad[0].depth_word | quad[1].depth_word | quad[2].depth_word | quad[3].depth_word) & 0xff) != 0) {
    const Outline copy = quad;
    return take_any_planar(copy, triangle, polygon);
  }
  OutlineLayout layout;
  const OutlineFate fate = lay_out_quad(quad, cull_, depth_bits_, layout);
  if (fate == OutlineFate::whole) {
    if (!shades_.empty()) {
      const Outline copy = quad;
      if (!has_linear_shades(copy, layout.reference)) return false;
    }
    enter_inlined(quad, layout, triangle, polygon);
    return true;
  }
  if (fate == OutlineFate::culled) counts.back += 2;
  return fate == OutlineFate::culled;
}

/// Takes a planar polygon as one entry, or rejects it as a whole. False if it has to be a fan: it needs clipping,
/// its corners are concave after snapping, their shades are not linear, or its plane could leave the range of depths.
bool PolygonAssembly::take_planar(const Outline& outline, Link triangle, Link polygon) {
  if (outline.count() != 4) return take_any_planar(outline, triangle, polygon);
  return take_quad(outline.of_count<4>(), triangle, polygon);
}

bool PolygonAssembly::has_linear_shades(const Outline& outline, unsigned reference) const {
  std::uint32_t shades[Outline::most_corners];
  for (unsigned i = 0; i < outline.count(); ++i) shades[i] = shades_[outline.number(i)];
  return shades_are_linear(outline, reference, shades, shade_kind_);
}

/// As `take_planar`, for an outline with any number of corners, some of which may lie outside the viewport or the range
/// of depths.
[[gnu::noinline]] bool PolygonAssembly::take_any_planar(const Outline& outline, Link triangle, Link polygon) {
  const Codes codes = codes_of(outline);
  if (codes.all != 0) {
    counts.outside += outline.count() - 2;
    return true;
  }
  if ((codes.any & outcode_clip) != 0) return false;
  OutlineLayout layout;
  const OutlineFate fate = lay_out(outline, cull_, depth_bits_, layout);
  if (fate == OutlineFate::whole) {
    if (!shades_.empty() && !has_linear_shades(outline, layout.reference)) return false;
    enter(outline, layout, triangle, polygon);
  }
  if (fate == OutlineFate::culled) counts.back += outline.count() - 2;
  return fate != OutlineFate::fan;
}

void PolygonAssembly::run_polygons(const Mesh& mesh, const ScreenVertex* vertices, bool scissored,
                                   const ClipContext& clip, const PolygonRange& range) {
  const std::uint16_t* index = mesh.indices.data() + range.first_index;
  auto triangle = static_cast<Link>(range.first_triangle);
  const std::uint32_t end = range.first + range.count;
  for (auto polygon = static_cast<Link>(range.first); polygon < end; ++polygon) {
    const unsigned corners = mesh.corner_count(polygon);
    Link number[Outline::most_corners];
    for (unsigned i = 0; i < corners; ++i) number[i] = index[i];
    const Outline outline(vertices, number, corners);
    bool taken = false;
    if (is_planar(mesh.corners[polygon])) {
      if (scissored && needs_clipping(outline)) {
        taken = clip_outline(mesh, clip, outline, triangle, polygon);
        if (undivided_ != no_link) divide_clipped(mesh, clip, outline);
      } else {
        taken = take_planar(outline, triangle, polygon);
      }
    }
    for (unsigned i = 1; i + 1 < corners && !taken; ++i) {
      const Link corner[3] = {number[0], number[i], number[i + 1]};
      const Outline part(vertices, corner, 3);
      const auto number_in_group = static_cast<Link>(triangle + i - 1);
      if (scissored && needs_clipping(part))
        clip_triangle(mesh, clip, part, number_in_group, polygon);
      else if (scissored && is_outside(part))
        ++counts.outside;
      else
        take_fan_triangle(outline, i, number_in_group, polygon);
    }
    triangle = static_cast<Link>(triangle + corners - 2);
    index += corners;
    counts.total += corners - 2;
  }
}

void PolygonAssembly::run_screen(std::span<const ScreenVertex> vertices, std::span<const std::uint8_t> corner_counts) {
  Link first = 0, triangle = 0;
  for (std::size_t i = 0; i < corner_counts.size(); ++i) {
    const auto polygon = static_cast<Link>(i);
    const unsigned corners = corner_counts[i] & ~unsigned{Mesh::planar};
    const bool planar = is_planar(corner_counts[i]);
    if (!planar || corners != 4 || !take_screen_quad(vertices.data(), first, triangle, polygon)) {
      Link number[Outline::most_corners];
      for (unsigned k = 0; k < corners; ++k) number[k] = static_cast<Link>(first + k);
      const Outline outline(vertices.data(), number, corners);
      if (!planar || corners == 4 || !take_any_planar(outline, triangle, polygon))
        take_screen_fan(outline, triangle, polygon);
    }
    first = static_cast<Link>(first + corners);
    triangle = static_cast<Link>(triangle + corners - 2);
  }
  counts.total += triangle;
}

[[gnu::always_inline]] inline bool PolygonAssembly::take_screen_quad(const ScreenVertex* vertices, Link first,
                                                                     Link triangle, Link polygon) {
  const Link number[] = {first, static_cast<Link>(first + 1), static_cast<Link>(first + 2),
                         static_cast<Link>(first + 3)};
  return take_quad({vertices, number, 4}, triangle, polygon);
}

[[gnu::noinline]] void PolygonAssembly::take_screen_fan(const Outline& outline, Link triangle, Link polygon) {
  for (unsigned i = 1; i + 1 < outline.count(); ++i) {
    const Link corner[3] = {outline.number(0), outline.number(i), outline.number(i + 1)};
    if (is_outside(outline.with(corner, 3)))
      ++counts.outside;
    else
      take_fan_triangle(outline, i, static_cast<Link>(triangle + i - 1), polygon);
  }
}

}  // namespace spanline
