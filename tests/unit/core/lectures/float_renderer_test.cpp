// Against a conventional renderer in floating point: corners where they fall, edge functions, depth linear on screen, a
// z-buffer of doubles. At most one pixel in a hundred may differ (snapping to sixteenths, depth in whole units).
#include <gtest/gtest.h>
#include <spanline/frame/ready_made_traits.hpp>
#include <spanline/model/cull.hpp>

#include <cmath>
#include <vector>

#include "support/effort.hpp"
#include "support/random_instance.hpp"
#include "support/ready_made_studios.hpp"

namespace spanline::test {
namespace {

struct Point {
  double x, y, z;
};

/// Draws triangles given in view space (z the distance) into a picture of ids.
class FloatRenderer {
 public:
  FloatRenderer(int width, int height, double focal, double near)
      : width_(width),
        height_(height),
        focal_(focal),
        near_(near),
        ids_(static_cast<std::size_t>(width * height)),
        depth_(ids_.size(), 2.0) {}

  void draw(const Point (&t)[3], std::uint32_t id) {
    // Clipped to the near plane as a polygon, then drawn as a fan.
    std::vector<Point> polygon;
    for (int i = 0; i < 3; ++i) {
      const Point &a = t[i], &b = t[(i + 1) % 3];
      if (a.z >= near_) polygon.push_back(a);
      if ((a.z >= near_) != (b.z >= near_)) {
        const double s = (near_ - a.z) / (b.z - a.z);
        polygon.push_back({a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), near_});
      }
    }
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) fill(polygon[0], polygon[i], polygon[i + 1], id);
  }
  [[nodiscard]] const std::vector<std::uint32_t>& ids() const { return ids_; }

 private:
  [[nodiscard]] Point project(const Point& p) const {
    return {width_ * 0.5 + focal_ * p.x / p.z, height_ * 0.5 - focal_ * p.y / p.z, 1 - near_ / p.z};
  }
  void fill(const Point& pa, const Point& pb, const Point& pc, std::uint32_t id) {
    Point a = project(pa), b = project(pb), c = project(pc);
    double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (area == 0) return;
    if (area < 0) {
      std::swap(b, c);
      area = -area;
    }
    const auto range = [](double low, double high, int size) {
      return std::pair{std::max(0, static_cast<int>(std::max(-1.0, std::floor(low)))),
                       std::min(size - 1, static_cast<int>(std::min(size * 1.0, std::ceil(high))))};
    };
    const auto [x0, x1] = range(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), width_);
    const auto [y0, y1] = range(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), height_);
    const auto edge = [](const Point& p, const Point& q, double x, double y) {
      return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
    };
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        const double wa = edge(b, c, x + 0.5, y + 0.5), wb = edge(c, a, x + 0.5, y + 0.5),
                     wc = edge(a, b, x + 0.5, y + 0.5);
        if (wa < 0 || wb < 0 || wc < 0) continue;
        const double z = (wa * a.z + wb * b.z + wc * c.z) / area;
        const auto p = static_cast<std::size_t>(y * width_ + x);
        if (z < depth_[p]) {
          depth_[p] = z;
          ids_[p] = id;
        }
      }
  }

  int width_, height_;
  double focal_, near_;
  std::vector<std::uint32_t> ids_;
  std::vector<double> depth_;
};

constexpr int width = 320, height = 240;
constexpr double focal = 240, near = 1, far = 100;

struct Shares {
  double different;  ///< of all pixels
  double drawn;      ///< of all pixels
};

/// The share of pixels that differ over soups of triangles of one size, pixels.
template <class Depth>
Shares differing_share(double size, int triangles, int soups) {
  Random random(static_cast<std::uint32_t>(size * 8));
  std::size_t different = 0, drawn = 0, pixels = 0;
  for (int i = 0; i < soups; ++i) {
    OwnedMesh owned;
    owned.step_exponent = -10;
    FloatRenderer reference(width, height, focal, near);
    for (int k = 0; k < triangles; ++k) {
      const double z = random.real(1.2, 30), reach = size * z / focal;
      const Point middle{random.real(-0.7, 0.7) * z, random.real(-0.5, 0.5) * z, z};
      Point corners[3];
      for (Point& c : corners) {
        const auto steps = [](double v) { return static_cast<std::int32_t>(std::lround(v * 1024)); };
        const Vertex32 v{steps(middle.x + random.real(-reach, reach)), steps(middle.y + random.real(-reach, reach)),
                         steps(-middle.z + random.real(-reach, reach))};
        owned.wide_vertices.push_back(v);
        c = {v.x / 1024.0, v.y / 1024.0, -v.z / 1024.0};
      }
      const auto first = static_cast<std::size_t>(3 * k);
      owned.triangle(first, first + 1, first + 2);
      reference.draw(corners, static_cast<std::uint32_t>(k) + 1);
    }
    owned.fit_bounds();
    Studio<IdTraits<Depth>> studio(
        mesh_capacity(width, height, 1, owned.wide_vertices.size(), static_cast<std::size_t>(triangles)));
    FrameSettings settings;
    settings.cull = Cull::none;
    settings.camera.focal = nearest<Q16_16>(focal);
    settings.camera.near_plane = nearest<Q16_16>(near);
    settings.camera.far_plane = nearest<Q16_16>(far);
    const Mesh mesh = owned.view();
    studio.begin(settings);
    studio.add(mesh, {}, {});
    const auto picture = studio.draw();
    EXPECT_TRUE(studio.status().ok()) << to_string(studio.status().pool);
    for (std::size_t p = 0; p < picture.pixels.size(); ++p)
      different += picture.pixels[p] != reference.ids()[p] ? 1U : 0U;
    drawn += picture.drawn_count();
    pixels += picture.pixels.size();
  }
  const auto share = [pixels](std::size_t count) { return static_cast<double>(count) / static_cast<double>(pixels); };
  return {share(different), share(drawn)};
}

template <class Depth>
void check_sizes() {
  const struct {
    double size;
    int triangles;
  } soups[] = {{2, 4000}, {4, 2500}, {8, 1200}, {16, 500}, {32, 250}, {64, 120}, {160, 60}, {400, 40}, {1500, 25}};
  for (const auto& soup : soups) {
    const Shares share = differing_share<Depth>(soup.size, soup.triangles, rounds(6));
    std::printf("%d bits, %d triangles of %.0f pixels: %.3f %% of the pixels differ, %.0f %% are drawn\n", Depth::bits,
                soup.triangles, soup.size, 100 * share.different, 100 * share.drawn);
    EXPECT_LE(share.different, 0.01) << soup.size;
  }
}

TEST(FloatRenderer, AtMostOnePixelInAHundredDiffersAt16Bits) { check_sizes<Depth16<>>(); }
TEST(FloatRenderer, AtMostOnePixelInAHundredDiffersAt24Bits) { check_sizes<Depth24<>>(); }

}  // namespace
}  // namespace spanline::test
