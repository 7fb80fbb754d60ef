#include "brute_force.hpp"

#include <algorithm>
#include <utility>

#include "spanline/raster/plane_equation.hpp"
#include "support/exact_triangle.hpp"

namespace spanline::contract {
namespace {

using test::ExactTriangle;

/// A triangle of the polygon table, with all that a pixel must know of it.
struct Candidate {
  std::uint32_t id;
  ExactTriangle exact;
  LinearFunction plane;
  std::int32_t nearest;  ///< of its corners
  int first_row, end_row;
};

/// Rows whose pixel centres lie in [top, bottom) sixteenths.
int row_below(int sixteenths) { return (sixteenths + 7) >> 4; }

/// Whether all corners lie beyond the same border: such a triangle does not come into the table.
bool is_outside(const Corners& t, const Scene& scene) {
  const auto all = [&](auto test) { return test(t[0]) && test(t[1]) && test(t[2]); };
  return all([](const Corner& c) { return c.x < 0; }) || all([](const Corner& c) { return c.y < 0; }) ||
         all([&](const Corner& c) { return c.x > 16 * scene.width; }) ||
         all([&](const Corner& c) { return c.y > 16 * scene.height; });
}

std::vector<Candidate> candidates_of(const Scene& scene) {
  std::vector<Candidate> all;
  const std::vector<ScreenVertex> vertices = test::vertices_of(scene.triangles, 24, scene.width, scene.height);
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    const Corners& t = scene.triangles[i];
    const ExactTriangle exact(t);
    if (exact.area() == 0 || is_outside(t, scene)) continue;
    const ScreenVertex* v = &vertices[3 * i];
    const PlaneEquation equation(v, v + 1, v + 2, vertices.data(), {scene.width, scene.height});
    all.push_back({static_cast<std::uint32_t>(i + 1), exact, equation.depth<Depth24<>>(),
                   std::min({t[0].z, t[1].z, t[2].z}), row_below(std::min({t[0].y, t[1].y, t[2].y})),
                   row_below(std::max({t[0].y, t[1].y, t[2].y}))});
  }
  return all;
}

}  // namespace

Drawing brute_force(const Scene& scene, std::size_t kept) {
  Drawing drawing;
  drawing.width = scene.width;
  drawing.height = scene.height;
  drawing.pixels.assign(scene.pixel_count(), 0);
  drawing.depths.assign(scene.pixel_count(), Depth24<>::clear);
  const std::vector<Candidate> candidates = candidates_of(scene);
  for (int y = 0; y < scene.height; ++y) {
    std::vector<const Candidate*> here;
    for (const Candidate& c : candidates)
      if (c.first_row <= y && y < c.end_row) here.push_back(&c);
    std::stable_sort(here.begin(), here.end(),
                     [](const Candidate* a, const Candidate* b) { return a->nearest < b->nearest; });
    here.resize(std::min(here.size(), kept));
    std::sort(here.begin(), here.end(), [](const Candidate* a, const Candidate* b) { return a->id < b->id; });
    for (int x = 0; x < scene.width; ++x)
      for (const Candidate* c : here) {
        const std::size_t pixel = drawing.at(x, y);
        const std::uint32_t depth = c->plane.at(x) + c->plane.dy * static_cast<std::uint32_t>(y);
        if (depth >= drawing.depths[pixel] || !c->exact.covers(x, y)) continue;
        drawing.depths[pixel] = depth;
        drawing.pixels[pixel] = c->id;
      }
  }
  return drawing;
}

std::size_t garbage_pixels(const Scene& scene, const Drawing& ids) {
  std::vector<ExactTriangle> exact(scene.triangles.begin(), scene.triangles.end());
  std::size_t count = 0;
  for (int y = 0; y < ids.height; ++y)
    for (int x = 0; x < ids.width; ++x) {
      const std::uint32_t id = ids.pixels[ids.at(x, y)];
      if (id != 0 && (id > exact.size() || !exact[id - 1].covers(x, y))) ++count;
    }
  return count;
}

}  // namespace spanline::contract
