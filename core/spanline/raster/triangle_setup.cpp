#include "spanline/raster/triangle_setup.hpp"

#include "spanline/raster/attribute_gradients.hpp"
#include "spanline/raster/polygon_corners.hpp"
#include "spanline/raster/polygon_table.hpp"

namespace spanline {
namespace {

template <class Depth>
LinearFunction depth_function(const Gradients& gradients, const Triangle& t, std::int32_t row) {
  return gradients.fit(t.a->depth<Depth>(), t.b->depth<Depth>(), t.c->depth<Depth>(), Depth::bits, row);
}

LinearFunction fit_depth(const Triangle& t, std::int64_t area, Viewport viewport, int depth_bits, std::int32_t row) {
  const Gradients gradients(t, area, viewport);
  return depth_bits == 16 ? depth_function<Depth16<>>(gradients, t, row) : depth_function<Depth24<>>(gradients, t, row);
}

}  // namespace

void AttributeGradients::fit_wide(std::int32_t a, std::int32_t b, std::int32_t c, LinearFunction& function) const {
  if (active_.flags.outline() && active_.flags.size() == ActiveTriangle::Size::small) {
    const PlaneEquation plane(t_.a, t_.b, t_.c, first_vertex_, viewport_);
    function = active_.moved_here(plane.attribute(a, b, c));
    return;
  }
  fit_fine({a, b, c}, 16, function);
}

void AttributeGradients::fit_fine(const std::array<std::int32_t, 3>& values, int bits, LinearFunction& function) const {
  function = Gradients(t_, area_, viewport_).fit(values[0], values[1], values[2], bits, active_.row);
  function.at_origin += function.dx * word(active_.origin);
}

void fit_wide_depth(const Triangle& t, std::int64_t area, Viewport viewport, int depth_bits, ActiveTriangle& active) {
  active.depth = fit_depth(t, area, viewport, depth_bits, active.row);
  active.depth.at_origin += active.depth.dx * word(active.origin);
}

void fit_wide_outline_depth(Triangle t, Viewport viewport, int depth_bits, ActiveTriangle& active) {
  std::int64_t area = t.wide_doubled_area();
  if (area < 0) {
    t.flip();
    area = -area;
  }
  fit_wide_depth(t, area, viewport, depth_bits, active);
}

AttributeGradients outline_gradients(const PolygonCorners& corners, const ActiveTriangle& active,
                                     const ScreenVertex* first_vertex, const Viewport& viewport) {
  Triangle t = Triangle::from(corners.corner[0], corners.corner[1], corners.corner[2]);
  std::int64_t area = t.wide_doubled_area();
  if (area < 0) {
    t.flip();
    area = -area;
  }
  return {t, area, active, first_vertex, viewport};
}

bool set_up_large(Triangle& t, bool scissored, Viewport viewport, int depth_bits, ActiveTriangle& active,
                  std::int64_t& area) {
  area = t.wide_doubled_area();
  if (area == 0) return false;
  if (area < 0) {
    t.flip();
    area = -area;
  }
  const std::int32_t bottom = viewport.height + row_bias;
  const ThirdEdge third = ThirdEdge::of(t);
  const std::int32_t first = std::max(row_at(t.ay), row_bias);
  const std::int32_t end = std::min(row_at(t.ay + third.y + third.dy), bottom);
  if (first >= end) return false;
  const bool medium = !scissored && medium_triangle::fits(t);
  active.flags = {medium ? ActiveTriangle::Size::medium : ActiveTriangle::Size::large, third.on_right, scissored};
  const std::int32_t knee_row = std::clamp(row_at(t.ay + third.y), first, end);
  active.origin = 0;
  active.row = first;
  active.rows_to_knee = knee_row - first;
  active.rows_after_knee = end - knee_row;
  if (medium) {
    const std::int32_t origin = medium_triangle::origin_of(t);
    active.origin = origin - row_bias;
    medium_triangle::set_edges(t, third, origin, 16 * first + 8 - t.ay, 16 * knee_row + 8 - t.ay - third.y,
                               active.fixed);
    fit_wide_depth(t, area, viewport, depth_bits, active);
    return true;
  }
  active.large = {};
  if (active.rows_to_knee != 0) {
    active.large.left = Edge::between(*t.a, *t.c, first);
    active.large.right = Edge::between(*t.a, *t.b, first);
  } else if (third.on_right) {
    active.large.left = Edge::between(*t.a, *t.c, first);
  } else {
    active.large.right = Edge::between(*t.a, *t.b, first);
  }
  active.depth = fit_depth(t, area, viewport, depth_bits, first);
  return true;
}

void put_third_large_edge(const PolygonCorners& polygon, ActiveTriangle& active) {
  Triangle t = Triangle::from(polygon.corner[0], polygon.corner[1], polygon.corner[2]);
  if (t.wide_doubled_area() < 0) t.flip();
  if (active.flags.third_on_right()) {
    active.large.right = Edge::between(*t.b, *t.c, active.row);
  } else {
    active.large.left = Edge::between(*t.c, *t.b, active.row);
  }
}

}  // namespace spanline
