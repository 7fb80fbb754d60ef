#include "textbook_depth_sort.hpp"

#include <algorithm>
#include <utility>

#include "spanline/math/bits.hpp"
#include "spanline/raster/plane_equation.hpp"

namespace spanline::contract {
namespace {

/// How far the words of two planes may lie beyond their corners' depths, together.
constexpr std::int32_t rounding = 8;

}  // namespace

TextbookDepthSort::Fragment::Fragment(std::uint32_t own_id, std::vector<Pixel> own_pixels)
    : id(own_id), pixels(std::move(own_pixels)) {
  const auto [first, last] =
      std::minmax_element(pixels.begin(), pixels.end(), [](Pixel a, Pixel b) { return a.x < b.x; });
  left = first->x;
  right = last->x;
  top = pixels.front().y;
  bottom = pixels.back().y;
}

bool TextbookDepthSort::Fragment::holds(Pixel pixel) const {
  return std::binary_search(pixels.begin(), pixels.end(), pixel,
                            [](Pixel a, Pixel b) { return std::pair(a.y, a.x) < std::pair(b.y, b.x); });
}

std::uint32_t TextbookDepthSort::Polygon::depth(Pixel pixel) const {
  return plane.at(pixel.x) + plane.dy * word(pixel.y);
}

TextbookDepthSort::TextbookDepthSort(const Scene& scene) {
  drawing_.width = scene.width;
  drawing_.height = scene.height;
  drawing_.pixels.assign(scene.pixel_count(), 0);
  drawing_.depths.assign(scene.pixel_count(), Depth24<>::clear);
  polygons_.push_back({test::ExactTriangle({}), {}, 0, 0});
  Fragments list;
  const auto vertices = test::vertices_of(scene.triangles, 24, scene.width, scene.height);
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    const Corners& t = scene.triangles[i];
    Polygon polygon{test::ExactTriangle(t), {}, std::min({t[0].z, t[1].z, t[2].z}), std::max({t[0].z, t[1].z, t[2].z})};
    std::vector<Pixel> pixels;
    polygon.exact.for_each_pixel(scene.width, scene.height, [&](int x, int y) { pixels.push_back({x, y}); });
    if (!pixels.empty()) {
      const ScreenVertex* v = &vertices[3 * i];
      polygon.plane = PlaneEquation(v, v + 1, v + 2, vertices.data(), {scene.width, scene.height}).depth<Depth24<>>();
      list.emplace_back(static_cast<std::uint32_t>(i + 1), std::move(pixels));
    }
    polygons_.push_back(polygon);
  }
  // 1. Sort by [minz … maxz] of each polygon.
  list.sort([&](const Fragment& a, const Fragment& b) { return polygons_[a.id].nearest < polygons_[b.id].nearest; });
  // 2. Resolve the ambiguities.
  Fragments front_to_back;
  while (!list.empty()) {
    settle_first(list);
    if (!list.empty()) front_to_back.splice(front_to_back.end(), list, list.begin());
  }
  // 3. Render polygons in a back-to-front order.
  for (auto f = front_to_back.rbegin(); f != front_to_back.rend(); ++f) paint(*f);
}

/// By the words that a z-buffer compares; where only one of the polygons is, by its depth and the other one's plane.
bool TextbookDepthSort::in_front(std::uint32_t a, std::uint32_t b, Pixel pixel) const {
  const auto [x, y] = pixel;
  const Polygon &p = polygons_[a], &q = polygons_[b];
  if (p.exact.covers(x, y) && q.exact.covers(x, y)) {
    const std::uint32_t depth_p = p.depth(pixel), depth_q = q.depth(pixel);
    return depth_p < depth_q || (depth_p == depth_q && a < b);
  }
  const double depth_p = p.exact.depth(x, y), depth_q = q.exact.depth(x, y);
  return depth_p < depth_q || (!(depth_q < depth_p) && a < b);
}

bool TextbookDepthSort::all_in_front(const Fragment& f, std::uint32_t plane) const {
  return std::all_of(f.pixels.begin(), f.pixels.end(), [&](Pixel pixel) { return in_front(f.id, plane, pixel); });
}
bool TextbookDepthSort::all_behind(const Fragment& f, std::uint32_t plane) const {
  return std::none_of(f.pixels.begin(), f.pixels.end(), [&](Pixel pixel) { return in_front(f.id, plane, pixel); });
}

bool TextbookDepthSort::overlap_in_depth(const Fragment& p, const Fragment& q) const {
  return polygons_[q.id].nearest <= polygons_[p.id].farthest + rounding;
}
bool TextbookDepthSort::overlap_in_projection(const Fragment& p, const Fragment& q) {
  return std::any_of(p.pixels.begin(), p.pixels.end(), [&](Pixel pixel) { return q.holds(pixel); });
}

TextbookDepthSort::Order TextbookDepthSort::rearrange(const Fragment& p, const Fragment& q) const {
  if (p.right < q.left || q.right < p.left) return Order::kept;  // no overlapping x-extents
  if (p.bottom < q.top || q.bottom < p.top) return Order::kept;  // no overlapping y-extents
  if (all_behind(q, p.id)) return Order::kept;                   // all Q on the opposite side of P from the eye
  if (all_in_front(p, q.id)) return Order::kept;                 // all P on the same side of Q as the eye
  if (!overlap_in_projection(p, q)) return Order::kept;
  if (all_in_front(q, p.id)) return Order::exchanged;  // all Q on the same side of P as the eye
  if (all_behind(p, q.id)) return Order::exchanged;    // all P on the opposite side of Q from the eye
  return Order::split;
}

void TextbookDepthSort::split(Fragments& list, Fragments::iterator p, const Fragment& q) {
  ++splits_;
  // Q's plane splits P. If it does not, since P lies behind all of it, the sides of Q do, and nothing can be seen of
  // the part that lies behind Q itself.
  const bool by_plane = !all_behind(*p, q.id);
  std::vector<Pixel> parts[2];
  for (const Pixel pixel : p->pixels)
    if (by_plane)
      parts[in_front(p->id, q.id, pixel) ? 0 : 1].push_back(pixel);
    else if (!q.holds(pixel))
      parts[0].push_back(pixel);
  for (auto& part : parts)
    if (!part.empty()) list.emplace(p, p->id, std::move(part));
  list.erase(p);
}

void TextbookDepthSort::settle_first(Fragments& list) {
  for (auto p = list.begin(), q = p; p != list.end();) {
    if (++q == list.end()) return;
    const Order order = overlap_in_depth(*p, *q) ? rearrange(*p, *q) : Order::kept;
    if (order == Order::kept) continue;
    if (order == Order::exchanged && !q->was_moved) {
      ++moves_;
      q->was_moved = true;
      list.splice(p, list, q);
    } else {
      // What was moved already and shall be moved again is in a cycle.
      split(list, p, *q);
    }
    p = q = list.begin();
  }
}

void TextbookDepthSort::paint(const Fragment& fragment) {
  for (const Pixel pixel : fragment.pixels) {
    const std::size_t at = drawing_.at(pixel.x, pixel.y);
    drawing_.pixels[at] = fragment.id;
    drawing_.depths[at] = polygons_[fragment.id].depth(pixel);
  }
}

}  // namespace spanline::contract
