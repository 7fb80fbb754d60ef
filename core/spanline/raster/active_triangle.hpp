#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

#include "spanline/raster/depth_format.hpp"
#include "spanline/raster/edge.hpp"
#include "spanline/raster/gradients.hpp"
#include "spanline/raster/linear_function.hpp"
#include "spanline/raster/medium_triangle.hpp"
#include "spanline/raster/plane_equation.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/raster/small_triangle.hpp"
#include "spanline/raster/triangle.hpp"

namespace spanline {

/// Edges of a triangle of any size: two that are walked; the third is made when its first row comes.
struct LargeEdges {
  Edge left, right;

  void skip_rows(std::int32_t rows) {
    for (; rows > 0; --rows) {
      left.next_row();
      right.next_row();
    }
  }
};

/// A triangle between its first row and its last: an entry of the active-edge table, with its plane equation. It is
/// made when the triangle becomes active and lives while it is.
struct ActiveTriangle {
  LinearFunction depth;          ///< plane word on the current row, at column `origin`
  std::int32_t origin;           ///< screen column that columns of edges and functions count from
  std::int32_t row;              ///< current row, biased
  std::int32_t rows_to_bend;     ///< rows until the left or right edge gives way to the third
  std::int32_t rows_after_bend;  ///< rows of the third edge
  enum class Size : std::uint8_t { small, medium, large };

  /// One word, so that set-up writes it at once.
  class Flags {
   public:
    Flags() = default;
    Flags(Size size, bool right_bends, bool clipped)
        : bits_(static_cast<std::uint32_t>(size) | (right_bends ? right_bends_bit : 0) | (clipped ? clipped_bit : 0)) {}
    /// `large` edges are in `large`, others in `fixed`.
    [[nodiscard]] Size size() const { return static_cast<Size>(bits_ & size_mask); }
    /// The third edge is on the right.
    [[nodiscard]] bool right_bends() const { return (bits_ & right_bends_bit) != 0; }
    /// Runs must be cut to the viewport's columns.
    [[nodiscard]] bool clipped() const { return (bits_ & clipped_bit) != 0; }
    /// The third edge is in place.
    [[nodiscard]] bool bent() const { return (bits_ & bent_bit) != 0; }
    void set_bent() { bits_ |= bent_bit; }

   private:
    static constexpr std::uint32_t size_mask = 3, right_bends_bit = 4, clipped_bit = 8, bent_bit = 16;
    std::uint32_t bits_;
  } flags;

  union {
    FixedEdges fixed;
    LargeEdges large;
  };

  /// Copies what a triangle of its size has.
  void assign(const ActiveTriangle& other) {
    depth = other.depth;
    origin = other.origin;
    row = other.row;
    rows_to_bend = other.rows_to_bend;
    rows_after_bend = other.rows_after_bend;
    flags = other.flags;
    if (flags.size() == Size::large)
      large = other.large;
    else
      fixed = other.fixed;
  }

  /// Steps a small or medium triangle over rows before and after its bend, where its counts of rows allow it.
  void skip_rows(std::int32_t before, std::int32_t after) {
    fixed.skip_rows(before);
    if (after > 0) {
      if (!flags.bent()) {
        fixed.bend(flags.right_bends());
        flags.set_bent();
      }
      fixed.skip_rows(after);
    }
    depth.skip_rows(before + after);
  }
  [[nodiscard]] std::int32_t end_row() const { return row + rows_to_bend + rows_after_bend; }
};

/// Fits attribute functions for a triangle that has just been set up, by whichever of the two ways the class of the
/// triangle and the slope allow. Made by `set_up` alone.
class AttributeGradients {
 public:
  AttributeGradients(const Triangle& t, std::int64_t area, const ActiveTriangle& active,
                     const ScreenVertex* first_vertex, Viewport viewport)
      : t_(t), area_(area), active_(active), first_vertex_(first_vertex), viewport_(viewport) {}

  /// Number of a corner within its group.
  [[nodiscard]] std::size_t index(const ScreenVertex* v) const { return static_cast<std::size_t>(v - first_vertex_); }

  /// The corners, in the order in which `fit_fine` takes their values; twice the area in square sixteenths; the screen
  /// column and row from which the functions count.
  [[nodiscard]] std::array<const ScreenVertex*, 3> corners() const { return {t_.a, t_.b, t_.c}; }
  [[nodiscard]] std::int64_t doubled_area() const { return area_; }
  [[nodiscard]] std::int32_t origin() const { return active_.origin; }
  [[nodiscard]] std::int32_t row() const { return active_.row - row_bias; }

  /// Through values of up to `bits` bits, with 32 − bits guard bits: attributes that want more than `fit` gives.
  void fit_fine(const std::array<std::int32_t, 3>& values, int bits, LinearFunction& function) const;

  /// `value_of` gives a value in [0, 65535] for a corner; the function has 16 guard bits and stands at the active
  /// triangle's row and origin.
  template <class ValueOf>
  void fit(ValueOf value_of, LinearFunction& function) const {
    const std::int32_t a = value_of(t_.a), b = value_of(t_.b), c = value_of(t_.c);
    if (active_.flags.size() == ActiveTriangle::Size::small &&
        fit_small_attribute(t_, static_cast<std::int32_t>(area_), a, b, c, 16 * active_.row + 8 - t_.ay, function))
      return;
    fit_wide(a, b, c, function);
  }
  /// The same for a triangle that is not of the small class, or whose slope is too steep for it.
  void fit_wide(std::int32_t a, std::int32_t b, std::int32_t c, LinearFunction& function) const;

 private:
  Triangle t_;
  std::int64_t area_;
  const ActiveTriangle& active_;
  const ScreenVertex* first_vertex_;
  Viewport viewport_;
};

/// The same for a small triangle, in set-up itself: everything stays in registers, and an object that others may look
/// into is made where the wide functions are asked for.
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
  /// For surfaces that want more than `fit`.
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

/// Sets up a triangle of any size or position as medium or large. False if it has no rows in the viewport or no
/// area.
[[nodiscard]] bool set_up_large(Triangle& t, bool scissored, Viewport viewport, int depth_bits, ActiveTriangle& active,
                                std::int64_t& area);

/// The wide depth function of a small triangle that is too thin or too steep for the small class's precision.
void fit_wide_depth(const Triangle& t, std::int64_t area, Viewport viewport, int depth_bits, ActiveTriangle& active);

/// Puts the third edge of a large triangle in place.
void bend_large(const PolygonCorners& polygon, ActiveTriangle& active);

/// Activates a polygon: edges and plane on its first row inside the viewport. `make_surface` is called with attribute
/// gradients of either class once it is certain that the triangle has rows. False if there is nothing to draw.
template <class Depth, class MakeSurface>
[[nodiscard, gnu::always_inline]] inline bool set_up(const ScreenVertex* p, const ScreenVertex* q,
                                                     const ScreenVertex* r, const PolygonGroup& group,
                                                     const Viewport& viewport, ActiveTriangle& active,
                                                     MakeSurface make_surface) {
  Triangle t = Triangle::from(p, q, r);
  const bool scissored = group.scissored && leaves_viewport(t);
  std::int32_t area = 0;
  if (!scissored && is_small(t, area)) {
    if (area < 0) {
      t.flip();
      area = -area;
    }
    const ThirdEdge third = ThirdEdge::of(t);
    const std::int32_t first = row_at(t.ay), bend_row = row_at(t.ay + third.y);
    const std::int32_t end = row_at(t.ay + third.y + third.dy);
    if (first >= end || area == 0) return false;
    const std::int32_t row_offset = 16 * first + 8 - t.ay;
    active.flags = {ActiveTriangle::Size::small, third.on_right, false};
    active.origin = small_triangle::origin_of(t);
    active.row = first;
    active.rows_to_bend = bend_row - first;
    active.rows_after_bend = end - bend_row;
    small_triangle::set_edges(t, third, row_offset, 16 * bend_row + 8 - t.ay - third.y, active.fixed);
    if (!fit_small_depth<Depth>(t, area, row_offset, active.depth)) {
      // A copy, so that the triangle itself stays in registers on the usual way.
      const Triangle kept = t;
      fit_wide_depth(kept, area, viewport, Depth::bits, active);
    }
    make_surface(SmallAttributeGradients(t, area, row_offset, active, group.vertices, viewport));
  } else {
    Triangle kept = t;
    std::int64_t wide_area;
    if (!set_up_large(kept, scissored, viewport, Depth::bits, active, wide_area)) return false;
    make_surface(AttributeGradients(kept, wide_area, active, group.vertices, viewport));
  }
  if constexpr (!Depth::smaller) active.depth = active.depth.complemented();
  return true;
}

}  // namespace spanline
