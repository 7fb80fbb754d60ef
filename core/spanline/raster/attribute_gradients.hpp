#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "spanline/raster/active_triangle.hpp"
#include "spanline/raster/gradients.hpp"
#include "spanline/raster/linear_function.hpp"
#include "spanline/raster/plane_equation.hpp"
#include "spanline/raster/screen_vertex.hpp"
#include "spanline/raster/triangle.hpp"

namespace spanline {

/// Computes linear functions of attributes for a triangle that has just been set up, or for the reference triangle of
/// an outline, with the set-up of small triangles where size and slope allow it and the wide set-up otherwise. Only
/// `set_up` and `set_up_outline` make objects of this class.
class AttributeGradients {
 public:
  AttributeGradients(const Triangle& t, std::int64_t area, const ActiveTriangle& active,
                     const ScreenVertex* first_vertex, Viewport viewport)
      : t_(t), area_(area), active_(active), first_vertex_(first_vertex), viewport_(viewport) {}

  /// Number of a corner within its group.
  [[nodiscard]] std::size_t index(const ScreenVertex* v) const { return static_cast<std::size_t>(v - first_vertex_); }

  /// The corners, in the order in which `fit_fine` takes their values; twice the area in square sixteenths of a pixel;
  /// the screen column and row of the functions' origin.
  [[nodiscard]] std::array<const ScreenVertex*, 3> corners() const { return {t_.a, t_.b, t_.c}; }
  [[nodiscard]] std::int64_t doubled_area() const { return area_; }
  [[nodiscard]] std::int32_t origin() const { return active_.origin; }
  [[nodiscard]] std::int32_t row() const { return active_.row - row_bias; }

  /// The function through values of `bits` bits, with 32 − bits guard bits, for attributes that need more precision
  /// than `fit` gives.
  void fit_fine(const std::array<std::int32_t, 3>& values, int bits, LinearFunction& function) const;

  /// The function through the values that `value_of` returns for the corners, in [0, 65535]. It has 16 guard bits and
  /// begins at the active triangle's row and origin.
  template <class ValueOf>
  void fit(ValueOf value_of, LinearFunction& function) const {
    const std::int32_t a = value_of(t_.a), b = value_of(t_.b), c = value_of(t_.c);
    if (active_.flags.small_triangle() &&
        fit_small_attribute(t_, static_cast<std::int32_t>(area_), a, b, c, 16 * active_.row + 8 - t_.ay, function))
      return;
    fit_wide(a, b, c, function);
  }
  /// As `fit`, for an outline, or a triangle that is not small or whose slope is too steep for the small set-up.
  void fit_wide(std::int32_t a, std::int32_t b, std::int32_t c, LinearFunction& function) const;

 private:
  Triangle t_;
  std::int64_t area_;
  const ActiveTriangle& active_;
  const ScreenVertex* first_vertex_;
  Viewport viewport_;
};

/// As AttributeGradients, for a small triangle inside its set-up. All members stay in registers; only where the wide
/// set-up is needed is an AttributeGradients object made in memory.
class SmallAttributeGradients {
 public:
  SmallAttributeGradients(const Triangle& t, std::int32_t area, std::int32_t row_offset, const ActiveTriangle& active,
                          const ScreenVertex* first_vertex, const Viewport& viewport)
      : t_(t),
        area_(area),
        row_offset_(row_offset),
        active_(active),
        first_vertex_(first_vertex),
        viewport_(viewport) {}

  [[nodiscard]] std::size_t index(const ScreenVertex* v) const { return static_cast<std::size_t>(v - first_vertex_); }
  template <class ValueOf>
  [[gnu::always_inline]] inline void fit(ValueOf value_of, LinearFunction& function) const {
    const std::int32_t a = value_of(t_.a), b = value_of(t_.b), c = value_of(t_.c);
    if (fit_small_attribute(t_, area_, a, b, c, row_offset_, function)) return;
    AttributeGradients(*this).fit_wide(a, b, c, function);
  }
  /// For surfaces that need more than `fit`.
  [[gnu::always_inline]] inline operator AttributeGradients() const {
    const Triangle kept = t_;
    return {kept, area_, active_, first_vertex_, viewport_};
  }

 private:
  const Triangle& t_;
  std::int32_t area_;
  std::int32_t row_offset_;
  const ActiveTriangle& active_;
  const ScreenVertex* first_vertex_;
  const Viewport& viewport_;
};

}  // namespace spanline
