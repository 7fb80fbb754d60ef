#include "spanline/geometry/polygon_assembly.hpp"

#include <algorithm>

#include "spanline/cpu/triangle_area.hpp"
#include "spanline/geometry/vertex_store.hpp"
#include "spanline/geometry/vertex_transform.hpp"
#include "spanline/model/cull.hpp"
#include "spanline/raster/link.hpp"

namespace spanline {
namespace {

/// A number with the sign of the signed area on screen. Inside the viewport (at most 2,047 pixels) the products fit 32
/// bits; in the guard band they do not.
template <bool Scissored>
inline std::int32_t orientation(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c) {
  constexpr std::uint32_t leaves = outcode_left | outcode_right | outcode_top | outcode_bottom;
  if constexpr (Scissored) {
    if (((a.depth_word | b.depth_word | c.depth_word) & leaves) != 0) {
      const auto area = signed_area<std::int64_t>(a, b, c);
      return (area > 0) - (area < 0);
    }
  }
  return narrow_area(a, b, c);
}

/// These take their operands by value. std::min and std::max take references, for which the compiler stores the
/// operands in memory.
inline std::int32_t least(std::int32_t a, std::int32_t b, std::int32_t c) {
  const std::int32_t d = a < b ? a : b;
  return d < c ? d : c;
}
inline std::int32_t greatest(std::int32_t a, std::int32_t b, std::int32_t c) {
  const std::int32_t d = a > b ? a : b;
  return d > c ? d : c;
}

}  // namespace

inline void PolygonAssembly::append(std::int32_t band, Link source) {
  if (table_.polygon_count < table_.references.size())
    table_.append(band, source);
  else
    ++polygons_wanted;
}

void PolygonAssembly::append_fan(std::int32_t band, const FanTriangle& fan) {
  if (!table_.fans.has_room(1)) {
    ++fans_wanted;
    return;
  }
  if (table_.polygon_count >= table_.references.size()) {
    ++polygons_wanted;
    return;
  }
  table_.append(band, static_cast<Link>(fan_flag | table_.fans.append(fan)));
}

/// Whether a triangle without clip codes is to be drawn. Output: `band`, where it starts. Increments `back` if it is
/// culled by its orientation.
template <bool Scissored>
inline bool PolygonAssembly::take(Cull cull, const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c,
                                  std::int32_t& band, std::uint32_t& back) const {
  const std::int32_t area = orientation<Scissored>(a, b, c);
  if (area >= 0) {
    if (area == 0) return false;
    if (cull == Cull::back) {
      ++back;
      return false;
    }
  } else if (cull == Cull::front) {
    ++back;
    return false;
  }
  const std::int32_t ay = biased_y(a), by = biased_y(b), cy = biased_y(c);
  std::int32_t first = row_at(least(ay, by, cy));
  std::int32_t end = row_at(greatest(ay, by, cy));
  if constexpr (Scissored) {
    first = std::max<std::int32_t>(first, row_bias);
    end = std::min(end, viewport_.height + row_bias);
  }
  if (first >= end) return false;  // no row of pixel centres lies inside
  band = band_of_row_(first - row_bias);
  return true;
}

template <bool Scissored, Cull Culled>
void PolygonAssembly::run_triangles(const Mesh& mesh, const ScreenVertex* vertices, const ClipContext& clip,
                                    const PolygonRange& range) {
  const std::uint16_t* index = mesh.indices.data() + range.first_index;
  const std::uint32_t end = range.first + range.count;
  counts.total += range.count;
  std::uint32_t back = 0;
  for (std::uint32_t triangle = range.first; triangle < end; ++triangle, index += 3) {
    const ScreenVertex& a = vertices[index[0]];
    const ScreenVertex& b = vertices[index[1]];
    const ScreenVertex& c = vertices[index[2]];
    if constexpr (Scissored) {
      const std::uint32_t all = a.depth_word & b.depth_word & c.depth_word;
      if ((all & 0xff) != 0) {
        ++counts.outside;
        continue;
      }
      if (((a.depth_word | b.depth_word | c.depth_word) & outcode_clip) != 0) {
        const Link corners[3] = {index[0], index[1], index[2]};
        clip_triangle(mesh, clip, {vertices, corners, 3}, static_cast<Link>(triangle), static_cast<Link>(triangle));
        continue;
      }
    }
    std::int32_t band;
    if (take<Scissored>(Culled, a, b, c, band, back)) append(band, static_cast<Link>(triangle));
  }
  counts.back += back;
}

// Not inlined, so that meshes of polygons do not have its variables on the stack.
template <bool Scissored>
[[gnu::noinline]] void PolygonAssembly::run_triangles(const Mesh& mesh, const ScreenVertex* vertices,
                                                      const ClipContext& clip, const PolygonRange& range) {
  switch (cull_) {
    case Cull::back:
      return run_triangles<Scissored, Cull::back>(mesh, vertices, clip, range);
    case Cull::front:
      return run_triangles<Scissored, Cull::front>(mesh, vertices, clip, range);
    case Cull::none:
      return run_triangles<Scissored, Cull::none>(mesh, vertices, clip, range);
  }
}

bool PolygonAssembly::take_outside(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c,
                                   std::int32_t& band, std::uint32_t& back) const {
  return take<true>(cull_, a, b, c, band, back);
}

/// Takes triangle `i` of a polygon's fan, counted from 1, which needs no clipping.
void PolygonAssembly::take_fan_triangle(const Outline& outline, unsigned i, Link triangle, Link polygon) {
  std::int32_t band;
  if (take_outside(outline[0], outline[i], outline[i + 1], band, counts.back))
    append_fan(band, {{outline.number(0), outline.number(i), outline.number(i + 1)}, triangle, polygon});
}

void PolygonAssembly::run(const Mesh& mesh, const ScreenVertex* vertices, bool scissored, const ClipContext& clip,
                          const PolygonRange& range) {
  if (!mesh.corners.empty())
    run_polygons(mesh, vertices, scissored, clip, range);
  else if (scissored)
    run_triangles<true>(mesh, vertices, clip, range);
  else
    run_triangles<false>(mesh, vertices, clip, range);
}

void PolygonAssembly::run_screen(std::span<const ScreenVertex> vertices) {
  const auto triangles = static_cast<std::uint32_t>(vertices.size() / 3);
  const Cull cull = cull_;
  counts.total += triangles;
  std::uint32_t back = 0;
  const ScreenVertex* v = vertices.data();
  for (std::uint32_t triangle = 0; triangle < triangles; ++triangle, v += 3) {
    std::int32_t band;
    const bool leaves = ((v[0].depth_word | v[1].depth_word | v[2].depth_word) & 0xff) != 0;
    if (leaves && (v[0].depth_word & v[1].depth_word & v[2].depth_word & 0xff) != 0) {
      ++counts.outside;
    } else if (leaves ? take<true>(cull, v[0], v[1], v[2], band, back)
                      : take<false>(cull, v[0], v[1], v[2], band, back)) {
      append(band, static_cast<Link>(triangle));
    }
  }
  counts.back += back;
}

}  // namespace spanline
