// Both ways of a vertex to the screen against floating point, within the errors that their headers state.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "spanline/geometry/instance.hpp"
#include "support/effort.hpp"
#include "support/exact_view.hpp"
#include "support/random_instance.hpp"

namespace spanline::test {
namespace {

/// The greatest differences from the exact vertex, before rounding to sixteenths and units.
struct Errors {
  Real inside = 0;    ///< sixteenths of a pixel, vertices inside the viewport
  Real anywhere = 0;  ///< sixteenths of a pixel, vertices inside the guard band
  Real depth = 0;     ///< units of the depth format
  long vertices = 0;

  void note(const ExactVertex& exact, const ScreenVertex& got, const FrameView& view) {
    // Rounding to a sixteenth is not an error: what is beyond half a one is.
    const auto off = [](Real a, Real b) { return std::max<Real>(0, std::fabs(a - b) - 0.5L); };
    const Real error = std::max(off(exact.x, got.x_sixteenths()), off(exact.y, got.y_sixteenths()));
    anywhere = std::max(anywhere, error);
    const bool seen =
        exact.x >= 0 && exact.y >= 0 && exact.x <= view.viewport.width * 16 && exact.y <= view.viewport.height * 16;
    if (seen) inside = std::max(inside, error);
    const Real wanted = std::clamp<Real>(exact.depth, view.nearest_depth, view.farthest_depth);
    depth = std::max(depth, std::fabs(wanted - static_cast<Real>(got.depth_word >> (32 - view.depth_bits))));
    ++vertices;
  }
  void print(const char* what) const {
    std::printf(
        "%s: %ld vertices; beyond rounding 1/%.0f pixel inside the picture, 1/%.0f anywhere; depth %.3Lf units\n", what,
        vertices, static_cast<double>(16 / std::max<Real>(inside, 1e-9L)),
        static_cast<double>(16 / std::max<Real>(anywhere, 1e-9L)), depth);
  }
};

bool in_guard_band(const ExactVertex& v) {
  constexpr Real guard = ScreenVertex::guard_pixels * 16 - 1;
  return std::fabs(v.x) < guard && std::fabs(v.y) < guard;
}

Errors fast_errors(int depth_bits, int wanted) {
  Random random(static_cast<std::uint32_t>(depth_bits));
  Errors errors;
  for (int i = 0; i < wanted; ++i) {
    const RandomInstance r(random, {.aside = 2.5, .depth_bits = depth_bits});
    const ViewTransform transform(r.view, r.mesh, r.transform);
    const Placement placement = place(r.view, transform);
    if (!VertexTransform::takes(r.view, transform, r.mesh, placement)) continue;
    std::vector<ScreenVertex> out(r.mesh.vertex_count());
    VertexTransform(r.view, transform).run(r.mesh.vertices, out.data(), true);
    const ExactView exact(r.view, r.mesh, r.transform);
    for (std::size_t k = 0; k < out.size(); ++k) errors.note(exact(k), out[k], r.view);
  }
  return errors;
}

TEST(VertexTransform, IsWithinItsStatedErrorsAt24Bits) {
  const Errors errors = fast_errors(24, rounds(60000));
  errors.print("fast, 24 bits");
  EXPECT_GT(errors.vertices, rounds(60000) * 8) << "the generator hardly ever meets the conditions of the fast way";
  EXPECT_LE(errors.anywhere, 16.0L / 32);
  EXPECT_LE(errors.depth, 2.5L);
}

TEST(VertexTransform, IsWithinItsStatedErrorsAt16Bits) {
  const Errors errors = fast_errors(16, rounds(30000));
  errors.print("fast, 16 bits");
  EXPECT_LE(errors.anywhere, 16.0L / 32);
  EXPECT_LE(errors.depth, 1.0L);
}

Errors wide_errors(const RandomInstance::Wish& wish, int wanted) {
  Random random(77);
  Errors errors;
  for (int i = 0; i < wanted; ++i) {
    const RandomInstance r(random, wish);
    const ViewTransform transform(r.view, r.mesh, r.transform);
    const PointProjection projection(r.view, transform);
    const ExactView exact(r.view, r.mesh, r.transform);
    for (std::size_t k = 0; k < r.mesh.vertex_count(); ++k) {
      const ExactVertex want = exact(k);
      const ScreenVertex got = projection(view_point(transform, r.mesh, k));
      if ((got.outcode() & outcode_clip) != 0 || !in_guard_band(want)) continue;
      errors.note(want, got, r.view);
    }
  }
  return errors;
}

/// Its header states none, so these are what it was found to keep, with a little room: 1/256 pixel, 1 unit at 16 bits
/// and 3 units at 24 (views that begin a thousandth of the way to what they show).
void check_wide(bool orthographic) {
  for (const bool wide : {false, true})
    for (const int bits : {16, 24}) {
      const double closest = orthographic ? 0.1 : 0.5;
      const Errors errors =
          wide_errors({.wide = wide, .orthographic = orthographic, .closest = closest, .aside = 2, .depth_bits = bits},
                      rounds(5000));
      errors.print(wide ? "wide way, 32-bit vertices" : "wide way, 16-bit vertices");
      EXPECT_LE(errors.anywhere, 16.0L / 256);
      EXPECT_LE(errors.depth, bits == 16 ? 1.0L : 3.0L);
    }
}

TEST(PointProjection, PerspectiveIsNearlyExactForBothVertexForms) { check_wide(false); }
TEST(PointProjection, OrthographicIsNearlyExactForBothVertexForms) { check_wide(true); }

/// The greatest error of view coordinates as a share of what `extent` says of an instance.
template <class Extent>
Real worst_share(bool wide, Extent extent) {
  Random random(99);
  Real worst = 0;
  for (int i = 0; i < rounds(10000); ++i) {
    const RandomInstance r(random, {.wide = wide, .closest = 0.1, .aside = 3});
    const ViewTransform transform(r.view, r.mesh, r.transform);
    const ExactView exact(r.view, r.mesh, r.transform);
    const Real unit = std::ldexp(Real{1}, -transform.exponent());
    for (std::size_t k = 0; k < r.mesh.vertex_count(); k += 7) {
      const RealPoint want = exact(k).view;
      const ViewPoint got = view_point(transform, r.mesh, k);
      const auto off = [unit](Real a, std::int64_t b) { return std::fabs(a - static_cast<Real>(b) * unit); };
      const Real error = std::max({off(want.x, got.x), off(want.y, got.y), off(want.z, got.z)});
      worst = std::max(worst, error / extent(r, want));
    }
  }
  return worst;
}

Real instance_extent(const RandomInstance& r, const RealPoint& view) {
  const auto steps = [](std::int32_t v) { return std::fabs(static_cast<Real>(v)); };
  const Real own = std::max({static_cast<Real>(r.owned.bounds.radius), steps(r.owned.offset.x), steps(r.owned.offset.y),
                             steps(r.owned.offset.z)}) *
                   static_cast<Real>(r.step_size());
  return std::max({own, std::fabs(view.x), std::fabs(view.y), std::fabs(view.z)});
}

TEST(ViewTransform, ShortVerticesAreWithin2ToTheMinus28OfTheInstancesExtent) {
  const Real worst = worst_share(false, instance_extent);
  std::printf("view space, 16-bit vertices: 2^%.2Lf of the extent at most\n", std::log2(worst));
  EXPECT_LE(worst, 0x1p-28L);
}

TEST(ViewTransform, WideVerticesAreWithin2ToTheMinus26OfTheReachOfTheView) {
  const Real worst = worst_share(true, [](const RandomInstance& r, const RealPoint& view) {
    return std::max(instance_extent(r, view), real(r.view.camera.far_plane));
  });
  std::printf("view space, 32-bit vertices: 2^%.2Lf of the reach at most\n", std::log2(worst));
  EXPECT_LE(worst, 0x1p-26L);
}

}  // namespace
}  // namespace spanline::test
