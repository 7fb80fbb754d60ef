#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "spanline/geometry/outline_layout.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/visibility/screen_surface.hpp"
#include "support/exact_triangle.hpp"
#include "support/screen_triangle.hpp"

namespace spanline::test {

/// A polygon table that owns its memory, of triangles and outlines given on screen, with the exact triangles that say
/// which pixels they cover.
class PolygonsOnScreen {
 public:
  PolygonsOnScreen(Viewport viewport, int depth_bits, std::size_t most)
      : viewport_(viewport), depth_bits_(depth_bits), vertices_(most * Outline::most_corners) {
    references_.resize(most);
    records_.resize(most * 3 * FanRecords::numbers_in_record);
    table_.references = references_;
    table_.fans = FanRecords(records_);
    group_.vertices = vertices_.data();
    group_.scissored = true;
    table_.groups = {&group_, 1};
    table_.buckets = {&bucket_, 1};
    table_.clear();
    table_.group_count = 1;
  }
  PolygonsOnScreen(const PolygonsOnScreen&) = delete;
  PolygonsOnScreen& operator=(const PolygonsOnScreen&) = delete;
  PolygonsOnScreen(PolygonsOnScreen&&) = delete;
  PolygonsOnScreen& operator=(PolygonsOnScreen&&) = delete;
  ~PolygonsOnScreen() = default;

  /// Adds a triangle, or an outline of more corners. False if the renderer would not: it has no area, or is to be a
  /// fan.
  bool add(std::span<const Corner> corners) {
    const Link first = used_vertices_;
    std::vector<Link> numbers;
    for (const Corner& c : corners) {
      numbers.push_back(static_cast<Link>(first + numbers.size()));
      vertices_[numbers.back()] = vertex_of(c, depth_bits_, viewport_.width, viewport_.height);
    }
    std::vector<ExactTriangle> fan;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      fan.push_back(ExactTriangle({corners[0], corners[i], corners[i + 1]}));
    if (corners.size() == 3) {
      if (fan.front().area() == 0) return false;
      append(table_.fans.append({{numbers[0], numbers[1], numbers[2]}, 0, 0}));
    } else {
      const Outline outline(vertices_.data(), numbers.data(), static_cast<unsigned>(numbers.size()));
      OutlineLayout layout;
      if (lay_out(outline, Cull::none, depth_bits_, layout) != OutlineFate::whole) return false;
      append(table_.fans.append(outline, layout, 0, 0));
    }
    used_vertices_ = static_cast<Link>(first + corners.size());
    fans_.push_back(fan);
    return true;
  }
  void clear() {
    table_.clear();
    table_.group_count = 1;
    used_vertices_ = 0;
    fans_.clear();
  }

  [[nodiscard]] PolygonTable& table() { return table_; }
  [[nodiscard]] PolygonEntry entry(Link number) const { return {table_, group_, number}; }

  [[nodiscard]] bool covers(Link number, int x, int y) const {
    return std::ranges::any_of(fans_[number], [&](const ExactTriangle& t) { return t.covers(x, y); });
  }
  /// Calls f(x, y) for every pixel of the viewport that the polygon covers.
  template <class F>
  void for_each_pixel(Link number, F f) const {
    for (const ExactTriangle& t : fans_[number]) t.for_each_pixel(viewport_.width, viewport_.height, f);
  }
  /// The depth words of the polygon's plane, in the format's sense.
  template <class Depth>
  [[nodiscard]] LinearFunction plane(Link number) const {
    const PolygonEntry polygon = entry(number);
    return plane_equation_of(polygon, polygon.corners(), polygon.is_outline(), viewport_).template depth<Depth>();
  }

 private:
  void append(Link record) { table_.append(0, static_cast<Link>(record | fan_flag)); }

  Viewport viewport_;
  int depth_bits_;
  std::vector<ScreenVertex> vertices_;
  std::vector<PolygonReference> references_;
  std::vector<Link> records_;
  PolygonGroup group_;
  Link bucket_ = no_link;
  PolygonTable table_;
  Link used_vertices_ = 0;
  std::vector<std::vector<ExactTriangle>> fans_;
};

}  // namespace spanline::test
