#include "spanline/geometry/outline_layout.hpp"
#include "spanline/geometry/polygon_assembly.hpp"
#include "spanline/geometry/vertex_store.hpp"
#include "spanline/geometry/vertex_transform.hpp"

namespace spanline {

/// A polygon after clipping: its corners on the screen, and their numbers in the vertex store as far as they have any.
struct PolygonAssembly::ClippedPolygon {
  ClipPolygon piece;
  Link number[ClipPolygon::most_corners];
  ScreenVertex screen[ClipPolygon::most_corners];

  /// Clips a polygon of the mesh. False if nothing of it is visible.
  /// Inlined, since the stack is deepest while it clips.
  [[gnu::always_inline]] inline bool clip(const Mesh& mesh, const ClipContext& clip, const Outline& polygon) {
    const VertexStore& store = *clip.store;
    for (unsigned i = 0; i < polygon.count(); ++i) {
      const Link corner = polygon.number(i);
      const bool textured = !store.textures.empty();
      piece.append({view_point(*clip.transform, mesh, corner), store.shades.empty() ? 0 : store.shades[corner],
                    textured ? store.textures[corner].s : 0, textured ? store.textures[corner].t : 0,
                    store.thirds.empty() ? 0 : store.thirds[corner], corner,
                    (polygon[i].depth_word & (outcode_near | outcode_guard)) == 0});
    }
    clip.clipper->clip(piece);
    if (piece.count() == 0) return false;
    std::uint32_t all = 0xff;
    for (unsigned i = 0; i < piece.count(); ++i) {
      // A vertex at the edge of the guard band may survive clipping although its outcode says that it lies outside. It
      // has no screen position and is projected again.
      const Link original = piece[i].original;
      const bool usable = original != no_link && (store.vertices[original].depth_word & outcode_clip) == 0;
      number[i] = usable ? original : no_link;
      screen[i] = usable ? store.vertices[original] : clip.projection->clipped(piece[i].point);
      all &= screen[i].depth_word;
    }
    return all == 0;
  }

  /// Puts a corner that has no number into the vertex store, if there is room.
  void store_corner(const ClipContext& clip, unsigned i) {
    VertexStore& store = *clip.store;
    if (number[i] != no_link) return;
    if (store.count >= store.vertices.size()) {
      ++store.wanted_vertices;
      return;
    }
    number[i] = store.count++;
    store.vertices[number[i]] = screen[i];
    if (!store.shades.empty()) store.shades[number[i]] = piece[i].shade;
    if (!store.textures.empty())
      store.textures[number[i]] = clip.textures.make(*clip.textures.nearness, piece[i].point.z, piece[i].s, piece[i].t);
    if (!store.thirds.empty()) store.thirds[number[i]] = piece[i].r;
  }
};

[[gnu::noinline]] void PolygonAssembly::clip_triangle(const Mesh& mesh, const ClipContext& clip, const Outline& corners,
                                                      Link triangle, Link polygon) {
  ClippedPolygon clipped;
  if (!clipped.clip(mesh, clip, corners)) {
    ++counts.outside;
    return;
  }
  bool back = false, front = false;
  for (unsigned i = 1; i + 1 < clipped.piece.count(); ++i) {
    std::uint32_t culled = 0;
    std::int32_t band;
    const bool drawn = take_outside(clipped.screen[0], clipped.screen[i], clipped.screen[i + 1], band, culled);
    (culled != 0 ? back : front) = true;
    if (!drawn) continue;
    for (const unsigned j : {0u, i, i + 1}) clipped.store_corner(clip, j);
    const Link *number = clipped.number, a = number[0], b = number[i], c = number[i + 1];
    if (a != no_link && b != no_link && c != no_link) append_fan(band, {{a, b, c}, triangle, polygon});
  }
  if (back && !front) ++counts.back;
}

/// As `take_planar`, for an outline that needs clipping.
[[gnu::noinline]] bool PolygonAssembly::clip_outline(const Mesh& mesh, const ClipContext& clip, const Outline& corners,
                                                     Link triangle, Link polygon) {
  ClippedPolygon clipped;
  const bool visible = clipped.clip(mesh, clip, corners);
  if (clipped.piece.overflowed() || clipped.piece.count() > Outline::most_corners) return false;
  if (visible) return take_clipped(clipped, clip, corners, triangle, polygon);
  counts.outside += corners.count() - 2;
  return true;
}

/// What `clip_outline` does with a visible outline. Not inlined, so that its variables are not on the stack while
/// polygons are clipped.
[[gnu::noinline]] bool PolygonAssembly::take_clipped(ClippedPolygon& clipped, const ClipContext& clip,
                                                     const Outline& corners, Link triangle, Link polygon) {
  constexpr Link order[Outline::most_corners] = {0, 1, 2, 3, 4, 5, 6, 7};
  const unsigned count = clipped.piece.count();
  const Outline outline(clipped.screen, order, count);
  OutlineLayout layout;
  const OutlineFate fate = lay_out(outline, cull_, depth_bits_, layout);
  if (fate == OutlineFate::fan) return false;
  if (fate == OutlineFate::culled) {
    counts.back += corners.count() - 2;
    return true;
  }
  if (!clip.store->shades.empty()) {
    std::uint32_t shades[Outline::most_corners];
    for (unsigned i = 0; i < count; ++i) shades[i] = clipped.piece[i].shade;
    if (!shades_are_linear(outline, layout.reference, shades, shade_kind_)) return false;
  }
  bool stored = true;
  for (unsigned i = 0; i < count; ++i) {
    clipped.store_corner(clip, i);
    stored = stored && clipped.number[i] != no_link;
  }
  if (!stored) return true;
  const Outline entered(clip.store->vertices.data(), clipped.number, count);
  if (clip.fan_lines.make == nullptr) {
    enter(entered, layout, triangle, polygon);
  } else {
    // The lines are made later, when the clipped polygon is no longer on the stack.
    undivided_ = enter_with_lines(entered, layout, triangle, polygon, corners.count() - 3);
    clockwise_ = layout.clockwise;
  }
  return true;
}

/// Makes the lines of the outline that `clip_outline` has entered, if it has.
[[gnu::noinline]] void PolygonAssembly::divide_clipped(const Mesh& mesh, const ClipContext& clip,
                                                       const Outline& corners) {
  for (unsigned i = 2; i + 1 < corners.count(); ++i)
    table_.fans.set_line(undivided_, i - 2,
                         clip.fan_lines.make(*clip.fan_lines.view, *clip.transform, mesh, corners, i, clockwise_));
  undivided_ = no_link;
}

}  // namespace spanline
