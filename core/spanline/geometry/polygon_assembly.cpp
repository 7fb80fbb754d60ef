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
  if (table_.fan_count >= table_.fans.size()) {
    ++fans_wanted;
    return;
  }
  if (table_.polygon_count >= table_.references.size()) {
    ++polygons_wanted;
    return;
  }
  table_.fans[table_.fan_count] = fan;
  table_.append(band, static_cast<Link>(fan_flag | table_.fan_count++));
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
        clip_triangle(mesh, clip, vertices, {index[0], index[1], index[2]}, static_cast<Link>(triangle),
                      static_cast<Link>(triangle));
        continue;
      }
    }
    std::int32_t band;
    if (take<Scissored>(Culled, a, b, c, band, back)) append(band, static_cast<Link>(triangle));
  }
  counts.back += back;
}

template <bool Scissored>
void PolygonAssembly::run_triangles(const Mesh& mesh, const ScreenVertex* vertices, const ClipContext& clip,
                                    const PolygonRange& range) {
  switch (cull_) {
    case Cull::back:
      return run_triangles<Scissored, Cull::back>(mesh, vertices, clip, range);
    case Cull::front:
      return run_triangles<Scissored, Cull::front>(mesh, vertices, clip, range);
    case Cull::none:
      return run_triangles<Scissored, Cull::none>(mesh, vertices, clip, range);
  }
}

void PolygonAssembly::run_polygons(const Mesh& mesh, const ScreenVertex* vertices, bool scissored,
                                   const ClipContext& clip, const PolygonRange& range) {
  const std::uint16_t* index = mesh.indices.data() + range.first_index;
  auto triangle = static_cast<Link>(range.first_triangle);
  const std::uint32_t end = range.first + range.count;
  for (auto polygon = static_cast<Link>(range.first); polygon < end; ++polygon) {
    const unsigned corners = mesh.corner_count(polygon);
    for (unsigned i = 1; i + 1 < corners; ++i, ++triangle) {
      ++counts.total;
      const Link corner[3] = {index[0], index[i], index[i + 1]};
      const ScreenVertex &a = vertices[corner[0]], &b = vertices[corner[1]], &c = vertices[corner[2]];
      const std::uint32_t all = a.depth_word & b.depth_word & c.depth_word;
      if (scissored && (all & 0xff) != 0) {
        ++counts.outside;
      } else if (scissored && ((a.depth_word | b.depth_word | c.depth_word) & outcode_clip) != 0) {
        clip_triangle(mesh, clip, vertices, corner, triangle, polygon);
      } else {
        std::int32_t band;
        if (take<true>(cull_, a, b, c, band, counts.back))
          append_fan(band, {{corner[0], corner[1], corner[2]}, triangle, polygon});
      }
    }
    index += corners;
  }
}

void PolygonAssembly::clip_triangle(const Mesh& mesh, const ClipContext& clip, const ScreenVertex* vertices,
                                    const Link (&corner)[3], Link triangle, Link polygon) {
  VertexStore& store = *clip.store;
  ClipPolygon piece;
  for (unsigned i = 0; i < 3; ++i) {
    const bool textured = !store.textures.empty();
    piece.append({view_point(*clip.transform, mesh, corner[i]), store.shades.empty() ? 0 : store.shades[corner[i]],
                  textured ? store.textures[corner[i]].s : 0, textured ? store.textures[corner[i]].t : 0,
                  store.thirds.empty() ? 0 : store.thirds[corner[i]], corner[i],
                  (vertices[corner[i]].depth_word & (outcode_near | outcode_guard)) == 0});
  }
  clip.clipper->clip(piece);
  if (piece.count() == 0) {
    ++counts.outside;
    return;
  }
  Link number[ClipPolygon::most_corners];
  ScreenVertex screen[ClipPolygon::most_corners];
  std::uint32_t all = 0xff;
  for (unsigned i = 0; i < piece.count(); ++i) {
    // A vertex at the edge of the guard band may survive clipping although its outcode says that it lies outside. It
    // has no screen position and is projected again.
    const Link original = piece[i].original;
    const bool usable = original != no_link && (vertices[original].depth_word & outcode_clip) == 0;
    number[i] = usable ? original : no_link;
    screen[i] = usable ? vertices[original] : clip.projection->clipped(piece[i].point);
    all &= screen[i].depth_word;
  }
  if (all != 0) {
    ++counts.outside;
    return;
  }
  bool back = false, front = false;
  for (unsigned i = 1; i + 1 < piece.count(); ++i) {
    std::uint32_t culled = 0;
    std::int32_t band;
    const bool drawn = take<true>(cull_, screen[0], screen[i], screen[i + 1], band, culled);
    (culled != 0 ? back : front) = true;
    if (!drawn) continue;
    for (const unsigned j : {0u, i, i + 1}) {
      if (number[j] != no_link) continue;
      if (store.count >= store.vertices.size()) {
        ++store.wanted_vertices;
        continue;
      }
      number[j] = store.count++;
      store.vertices[number[j]] = screen[j];
      if (!store.shades.empty()) store.shades[number[j]] = piece[j].shade;
      if (!store.textures.empty())
        store.textures[number[j]] =
            clip.textures.make(*clip.textures.nearness, piece[j].point.z, piece[j].s, piece[j].t);
      if (!store.thirds.empty()) store.thirds[number[j]] = piece[j].r;
    }
    if (number[0] != no_link && number[i] != no_link && number[i + 1] != no_link)
      append_fan(band, {{number[0], number[i], number[i + 1]}, triangle, polygon});
  }
  if (back && !front) ++counts.back;
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
