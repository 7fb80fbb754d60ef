#pragma once
#include <cstdint>

#include "spanline/raster/active_triangle.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/raster/screen_vertex.hpp"

namespace spanline {

/// The corners of a convex polygon on screen, in order, either way round: numbers of vertices in a table.
class Outline {
 public:
  static constexpr unsigned most_corners = 8;

  Outline(const ScreenVertex* vertices, const Link* numbers, unsigned count)
      : vertices_(vertices), numbers_(numbers), count_(count) {}

  /// The number of corners, [3, most_corners].
  [[nodiscard]] unsigned count() const { return count_; }
  [[nodiscard]] const ScreenVertex& operator[](unsigned i) const { return vertices_[numbers_[i]]; }
  /// The number of a corner's vertex.
  [[nodiscard]] Link number(unsigned i) const { return numbers_[i]; }
  /// The same outline, whose number of corners is known to the compiler.
  template <unsigned Count>
  [[nodiscard]] Outline of_count() const {
    return {vertices_, numbers_, Count};
  }
  [[nodiscard]] const Link* numbers() const { return numbers_; }
  /// Other corners of the same table.
  [[nodiscard]] Outline with(const Link* numbers, unsigned count) const { return {vertices_, numbers, count}; }
  /// The corner after corner `i`.
  [[nodiscard]] unsigned after(unsigned i) const { return i + 1 < count_ ? i + 1 : 0; }

 private:
  const ScreenVertex* vertices_;
  const Link* numbers_;
  unsigned count_;
};

/// How the edges and the plane of an outline are stepped.
struct OutlineLayout {
  ActiveTriangle::Size size;  ///< the class of its edges; only `small` has its plane from the set-up of small triangles
  bool clockwise;             ///< on screen
  unsigned reference;         ///< the reference triangle has corners 0, `reference` and `reference` + 1
  unsigned top;               ///< the first of its topmost corners
  unsigned slack;             ///< the plane word differs from corners' depth words by at most 2^slack; below 31
  std::int32_t first_row, end_row;  ///< its rows [first_row, end_row), biased; not cut to the viewport
  std::int32_t origin;              ///< biased column where the columns of edges are 0; 0 if they are large
};

}  // namespace spanline
