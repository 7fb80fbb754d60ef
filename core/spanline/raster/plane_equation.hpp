#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "spanline/raster/depth_format.hpp"
#include "spanline/raster/gradients.hpp"
#include "spanline/raster/linear_function.hpp"
#include "spanline/raster/small_triangle.hpp"
#include "spanline/raster/triangle.hpp"

namespace spanline {

/// Whether a corner lies outside the viewport. Such triangles take the wide set-up whatever their size.
[[nodiscard]] inline bool leaves_viewport(const Triangle& t) {
  return ((t.a->depth_word | t.b->depth_word | t.c->depth_word) &
          (outcode_left | outcode_right | outcode_top | outcode_bottom)) != 0;
}

/// Whether a triangle that does not leave the viewport is in the small class. If so, `area` becomes its signed doubled
/// area.
[[nodiscard, gnu::always_inline]] inline bool is_small(const Triangle& t, std::int32_t& area) {
  return small_triangle::fits(t) && (magnitude(area = t.doubled_area()) >> 16) == 0;
}

/// Computes the depth function of a small triangle for its first row, from its column of origin; smaller is nearer.
/// False if the wide set-up is needed. `area` is positive.
template <class Depth>
[[nodiscard, gnu::always_inline]] inline bool fit_small_depth(const Triangle& t, std::int32_t area,
                                                              std::int32_t row_offset, LinearFunction& function) {
  if constexpr (Depth::bits == 16)
    return small_triangle::Gradients(word(area))
        .fit<small_triangle::Precision::depth>(t, t.a->depth<Depth>(), t.b->depth<Depth>(), t.c->depth<Depth>(),
                                               row_offset, function);
  return false;
}

/// As fit_small_depth, for an attribute of 16 bits.
[[nodiscard, gnu::always_inline]] inline bool fit_small_attribute(const Triangle& t, std::int32_t area, std::int32_t a,
                                                                  std::int32_t b, std::int32_t c,
                                                                  std::int32_t row_offset, LinearFunction& function) {
  return small_triangle::Gradients(word(area)).fit<small_triangle::Precision::shade>(t, a, b, c, row_offset, function);
}

/// The plane equation of a triangle, for depth and for every attribute, as functions of the whole screen with their
/// origin at column 0 of row 0. They depend on the three corners and the viewport alone, so algorithms that use this
/// class and those that set up an ActiveTriangle get the same word at every pixel.
class PlaneEquation {
 public:
  /// `first_vertex` is the first vertex of the corners' group.
  PlaneEquation(const ScreenVertex* p, const ScreenVertex* q, const ScreenVertex* r, const ScreenVertex* first_vertex,
                Viewport viewport);
  /// For a polygon that extends beyond this triangle: its plane is fitted by the wide set-up.
  void extend() { small_ = false; }

  /// Twice the area in square sixteenths of a pixel. If it is 0, the triangle has no plane, and the functions below
  /// must not be called.
  [[nodiscard]] std::int64_t doubled_area() const { return area_; }
  /// The triangle, clockwise.
  [[nodiscard]] const Triangle& triangle() const { return triangle_; }

  /// The plane words of depth, in the sense of the depth format.
  template <class Depth>
  [[nodiscard]] LinearFunction depth() const {
    LinearFunction function;
    if (small_ && fit_small_depth<Depth>(triangle_, small_area(), row_offset(), function))
      function = moved_from_small_origin(function);
    else
      function =
          wide(triangle_.a->depth<Depth>(), triangle_.b->depth<Depth>(), triangle_.c->depth<Depth>(), Depth::bits);
    return Depth::smaller ? function : function.complemented();
  }

  /// Number of a corner within its group.
  [[nodiscard]] std::size_t index(const ScreenVertex* v) const { return static_cast<std::size_t>(v - first_vertex_); }

  /// The corners, in the order in which `fit_fine` takes their values; the screen column and row of the functions'
  /// origin.
  [[nodiscard]] std::array<const ScreenVertex*, 3> corners() const { return {triangle_.a, triangle_.b, triangle_.c}; }
  [[nodiscard]] static std::int32_t origin() { return 0; }
  [[nodiscard]] static std::int32_t row() { return 0; }

  /// The function through values of `bits` bits, with 32 − bits guard bits, for attributes that need more precision
  /// than `fit` gives.
  void fit_fine(const std::array<std::int32_t, 3>& values, int bits, LinearFunction& function) const {
    function = wide(values[0], values[1], values[2], bits);
  }

  /// The function through the values that `value_of` returns for the corners, in [0, 65535], with 16 guard bits.
  /// Shaders make their surfaces from such functions.
  template <class ValueOf>
  void fit(ValueOf value_of, LinearFunction& function) const {
    function = attribute(value_of(triangle_.a), value_of(triangle_.b), value_of(triangle_.c));
  }
  /// The same through values of the corners of `triangle()`.
  [[nodiscard]] LinearFunction attribute(std::int32_t a, std::int32_t b, std::int32_t c) const;

 private:
  [[nodiscard]] std::int32_t small_area() const { return static_cast<std::int32_t>(area_); }
  [[nodiscard]] std::int32_t row_offset() const { return 16 * row_at(triangle_.ay) + 8 - triangle_.ay; }
  [[nodiscard]] LinearFunction moved_from_small_origin(LinearFunction function) const;
  [[nodiscard]] LinearFunction wide(std::int32_t a, std::int32_t b, std::int32_t c, int bits) const;

  Triangle triangle_;
  const ScreenVertex* first_vertex_;
  std::int64_t area_;  ///< twice the area, square sixteenths of a pixel
  Viewport viewport_;
  bool small_;  ///< whether the set-up of small triangles applies
};

}  // namespace spanline
