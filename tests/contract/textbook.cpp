#include "textbook.hpp"

#include <algorithm>

#include "spanline/math/bits.hpp"
#include "spanline/raster/plane_equation.hpp"
#include "support/exact_triangle.hpp"
#include "support/screen_triangle.hpp"

namespace spanline::contract {

int Textbook::Edge::column(int y) const {
  // ⌈(X − 8) / 16⌉ of X = x0 + (16y + 8 − y0)·dx/dy: the first pixel centre at or right of the edge.
  const std::int64_t numerator = (x0 - 8) * dy + (16 * y + 8 - y0) * dx, denominator = 16 * dy;
  const std::int64_t quotient = numerator / denominator;
  return static_cast<int>(quotient + (numerator % denominator > 0 ? 1 : 0));
}

Textbook::Textbook(const Scene& scene) : scene_(scene) {
  const auto vertices = test::vertices_of(scene.triangles, 24, scene.width, scene.height);
  planes_.resize(scene.triangles.size() + 1);
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    const Corners& t = scene.triangles[i];
    if (test::ExactTriangle(t).area() == 0) continue;
    const auto id = static_cast<std::uint32_t>(i + 1);
    const ScreenVertex* v = &vertices[3 * i];
    planes_[id] = PlaneEquation(v, v + 1, v + 2, vertices.data(), {scene.width, scene.height}).depth<Depth24<>>();
    for (std::size_t k = 0; k < 3; ++k) {
      std::size_t upper = k, lower = (k + 1) % 3;
      if (t[lower].y < t[upper].y) std::swap(upper, lower);
      const int first = (t[upper].y + 7) >> 4, end = (t[lower].y + 7) >> 4;
      if (first < end)
        edges_.push_back(
            {id, upper, lower, first, end, t[upper].x, t[upper].y, t[lower].x - t[upper].x, t[lower].y - t[upper].y});
    }
  }
}

std::uint32_t Textbook::depth(std::uint32_t id, int x, int y) const {
  return planes_[id].at(x) + planes_[id].dy * word(y);
}

bool Textbook::in_front(std::uint32_t a, std::uint32_t b, int x, int y) const {
  const std::uint32_t depth_a = depth(a, x, y), depth_b = depth(b, x, y);
  return depth_a < depth_b || (depth_a == depth_b && a < b);
}

std::uint32_t Textbook::closest(const std::vector<std::uint32_t>& list, int x, int y) const {
  return list.empty() ? 0 : *std::min_element(list.begin(), list.end(), [&](std::uint32_t a, std::uint32_t b) {
    return in_front(a, b, x, y);
  });
}

Textbook::Row Textbook::row(int y) const {
  std::vector<ActiveEdge> active;
  for (const Edge& edge : edges_)
    if (edge.first_row <= y && y < edge.end_row)
      active.push_back({std::clamp(edge.column(y), 0, scene_.width), edge.polygon, edge.upper, edge.lower});
  std::stable_sort(active.begin(), active.end(),
                   [](const ActiveEdge& a, const ActiveEdge& b) { return a.column < b.column; });
  active.push_back({scene_.width});
  Row row;
  row.edges.push_back({0});
  std::vector<std::uint32_t> inside;
  for (const ActiveEdge& next : active) {
    // Up to the next edge the list holds the same polygons: where another of them is closest there is a false edge.
    for (;;) {
      const int begin = row.edges.back().column;
      std::sort(inside.begin(), inside.end(),
                [&](std::uint32_t a, std::uint32_t b) { return in_front(a, b, begin, y); });
      row.inside.push_back(inside);
      int crossing = begin;
      while (crossing < next.column && closest(inside, crossing, y) == closest(inside, begin, y)) ++crossing;
      if (crossing >= next.column) break;
      row.edges.push_back({.column = crossing, .is_false = true});
    }
    row.edges.push_back(next);
    // The polygon's flag turns.
    if (const auto found = std::find(inside.begin(), inside.end(), next.polygon); found != inside.end())
      inside.erase(found);
    else
      inside.push_back(next.polygon);
  }
  return row;
}

Drawing Textbook::draw() const {
  Drawing drawing;
  drawing.width = scene_.width;
  drawing.height = scene_.height;
  drawing.pixels.assign(scene_.pixel_count(), 0);
  drawing.depths.assign(scene_.pixel_count(), Depth24<>::clear);
  for (int y = 0; y < scene_.height; ++y) {
    const Row here = row(y);
    for (std::size_t i = 0; i + 1 < here.edges.size(); ++i) {
      if (here.inside[i].empty()) continue;
      const std::uint32_t id = here.inside[i].front();
      for (int x = here.edges[i].column; x < here.edges[i + 1].column; ++x) {
        drawing.pixels[drawing.at(x, y)] = id;
        drawing.depths[drawing.at(x, y)] = depth(id, x, y);
      }
    }
  }
  return drawing;
}

}  // namespace spanline::contract
