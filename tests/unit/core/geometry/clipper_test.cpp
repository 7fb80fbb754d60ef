// Promise 4 where edges are clipped: triangles that share an edge get the same points on it, to the last bit, whichever
// way round each of them goes.
#include "spanline/geometry/clipper.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <tuple>

#include "spanline/geometry/vertex_transform.hpp"
#include "support/effort.hpp"
#include "support/random_instance.hpp"

namespace spanline::test {
namespace {

using Bits =
    std::tuple<std::int64_t, std::int64_t, std::int64_t, std::int32_t, std::int32_t, std::int32_t, std::uint32_t>;

/// The corners that clipping leaves of an edge that is walked there and back, as two triangles walk it.
std::set<Bits> corners_of_edge(const Clipper& clipper, const ClipVertex& a, const ClipVertex& b) {
  ClipPolygon polygon;
  for (const ClipVertex* corner : {&a, &b, &b}) polygon.append(*corner);
  clipper.clip(polygon);
  std::set<Bits> corners;
  for (unsigned i = 0; i < polygon.count(); ++i) {
    const ClipVertex& v = polygon[i];
    corners.insert({v.point.x, v.point.y, v.point.z, v.s, v.t, v.r, v.shade});
  }
  return corners;
}

TEST(Clipper, BothSidesOfASharedEdgeGetTheSamePoints) {
  Random random(1);
  int cuts = 0;
  for (int i = 0; i < rounds(4000); ++i) {
    const RandomInstance r(random, {.wide = random.chance(2),
                                    .orthographic = random.chance(3),
                                    .closest = 0.1,
                                    .farthest = 8,
                                    .aside = 3,
                                    .range_around = false,
                                    .vertices = 3});
    const ViewTransform transform(r.view, r.mesh, r.transform);
    const Clipper clipper(r.view, transform, vertex_shade::Kind::intensity);
    std::array<ClipVertex, 2> ends;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto coordinate = [&] { return random.between(-1'000'000, 1'000'000); };
      const auto shade = static_cast<std::uint32_t>(random.between(64, 65471));
      ends[k].point = view_point(transform, r.mesh, k);
      ends[k].shade = shade;
      ends[k].s = coordinate();
      ends[k].t = coordinate();
      ends[k].r = coordinate();
    }
    const std::set<Bits> left = corners_of_edge(clipper, ends[0], ends[1]);
    ASSERT_LE(left.size(), 2U) << "the edge has other points on its way back, round " << i;
    ASSERT_EQ(left, corners_of_edge(clipper, ends[1], ends[0])) << "round " << i;
    for (const Bits& corner : left)
      cuts += std::get<0>(corner) != ends[0].point.x && std::get<0>(corner) != ends[1].point.x ? 1 : 0;
  }
  EXPECT_GT(cuts, rounds(4000) / 8) << "hardly any edge was cut";
}

}  // namespace
}  // namespace spanline::test
