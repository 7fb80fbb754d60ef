#include "spanline/raster/plane_equation.hpp"

namespace spanline {

PlaneEquation::PlaneEquation(const ScreenVertex* p, const ScreenVertex* q, const ScreenVertex* r,
                             const ScreenVertex* first_vertex, Viewport viewport)
    : triangle_(Triangle::from(p, q, r)), first_vertex_(first_vertex), viewport_(viewport) {
  std::int32_t narrow = 0;
  small_ = !leaves_viewport(triangle_) && is_small(triangle_, narrow);
  area_ = small_ ? narrow : triangle_.wide_doubled_area();
  if (area_ < 0) {
    triangle_.flip();
    area_ = -area_;
  }
}

LinearFunction PlaneEquation::moved_from_small_origin(LinearFunction function) const {
  function.at_origin -= function.dx * word(small_triangle::origin_of(triangle_));
  function.skip_rows(row_bias - row_at(triangle_.ay));
  return function;
}

LinearFunction PlaneEquation::attribute(std::int32_t a, std::int32_t b, std::int32_t c) const {
  LinearFunction function;
  if (small_ && fit_small_attribute(triangle_, small_area(), a, b, c, row_offset(), function))
    return moved_from_small_origin(function);
  return wide(a, b, c, 16);
}

LinearFunction PlaneEquation::wide(std::int32_t a, std::int32_t b, std::int32_t c, int bits) const {
  return Gradients(triangle_, area_, viewport_).fit(a, b, c, bits, row_bias);
}

}  // namespace spanline
