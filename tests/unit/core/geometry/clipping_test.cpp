// Clipping to the near plane, the far plane and the guard band: closed meshes stay closed, every pixel is written once.
#include <gtest/gtest.h>
#include <spanline/model/cull.hpp>

#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "support/effort.hpp"
#include "support/exact_view.hpp"
#include "support/random_instance.hpp"
#include "support/ready_made_studios.hpp"

namespace spanline::test {
namespace {

/// A convex polyhedron with faces of random shape: a subdivided octahedron, its vertices pushed out to a sphere.
OwnedMesh ball(int subdivisions, int radius) {
  OwnedMesh mesh;
  std::vector<RealPoint> points{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<std::array<std::size_t, 3>> faces{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < subdivisions; ++level) {
    std::vector<std::array<std::size_t, 3>> finer;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t a, std::size_t b) {
      const auto [at, made] = middles.try_emplace(std::minmax(a, b), points.size());
      if (made) {
        const RealPoint m{points[a].x + points[b].x, points[a].y + points[b].y, points[a].z + points[b].z};
        const Real length = std::sqrt(m.x * m.x + m.y * m.y + m.z * m.z);
        points.push_back({m.x / length, m.y / length, m.z / length});
      }
      return at->second;
    };
    for (const auto& f : faces) {
      const std::size_t ab = middle(f[0], f[1]), bc = middle(f[1], f[2]), ca = middle(f[2], f[0]);
      for (const auto& part : {std::array{f[0], ab, ca}, {ab, f[1], bc}, {ca, bc, f[2]}, {ab, bc, ca}})
        finer.push_back(part);
    }
    faces = std::move(finer);
  }
  for (const RealPoint& p : points) {
    const auto c = [radius](Real v) { return static_cast<std::int16_t>(std::lround(v * radius)); };
    mesh.vertices.push_back({c(p.x), c(p.y), c(p.z)});
  }
  for (const auto& f : faces) mesh.triangle(f[0], f[1], f[2]);
  mesh.fit_bounds();
  return mesh;
}

/// The planes of a convex polyhedron around the eye, in view space: n · p = away.
struct Face {
  double x, y, z, away;
};

std::vector<Face> faces_of(const Mesh& mesh, const ExactView& exact) {
  std::vector<Face> faces;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const RealPoint a = exact(mesh.indices[i]).view, b = exact(mesh.indices[i + 1]).view,
                    c = exact(mesh.indices[i + 2]).view;
    const RealPoint u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
    const RealPoint n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    faces.push_back({static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z),
                     static_cast<double>(n.x * a.x + n.y * a.y + n.z * a.z)});
  }
  return faces;
}

/// Where the ray (x, y, 1) leaves the polyhedron, as a distance along the axis of view.
double exit_distance(const std::vector<Face>& faces, double x, double y) {
  double inverse = 0;
  for (const Face& f : faces) {
    // A positive quotient: the plane lies before the eye.
    inverse = std::max(inverse, (f.x * x + f.y * y + f.z) / f.away);
  }
  return 1 / inverse;
}

struct Room {
  FrameSettings settings;
  Transform transform;
  OwnedMesh owned;
  int width, height;

  /// The eye somewhere inside a ball of radius 1, with a wide view, the near plane cutting into the ball.
  Room(Random& random, double smallest_near, double greatest_near, double far)
      : owned(ball(random.between(0, 3), 8192)) {
    width = random.between(60, 200);
    height = random.between(50, 150);
    settings.camera.axes = random_rotation(random);
    settings.camera.eye = {nearest<Q16_16>(random.real(-0.3, 0.3)), nearest<Q16_16>(random.real(-0.3, 0.3)),
                           nearest<Q16_16>(random.real(-0.3, 0.3))};
    settings.camera.focal = nearest<Q16_16>(std::exp2(random.real(3, 9)));
    settings.camera.near_plane = nearest<Q16_16>(random.real(smallest_near, greatest_near));
    settings.camera.far_plane = nearest<Q16_16>(far);
    transform.rotation = random_rotation(random);
  }

  [[nodiscard]] Picture<Ids> draw(Cull cull, std::uint64_t& fragments) {
    settings.cull = cull;
    Studio<Ids> studio(mesh_capacity(width, height, 1, owned.vertices.size(), owned.indices.size() / 3));
    const Mesh mesh = owned.view();
    studio.begin(settings);
    studio.add(mesh, transform, {});
    auto picture = studio.draw();
    EXPECT_TRUE(studio.status().ok()) << to_string(studio.status().pool);
    fragments = studio.statistics().visibility.depth_tests;
    return picture;
  }
};

void check_room(Room& room, long& pixels, long& near_misses) {
  std::uint64_t shown = 0, turned = 0;
  const auto picture = room.draw(Cull::back, turned);
  const auto inside = room.draw(Cull::front, shown);
  // From inside, all faces are seen from behind: what is left after culling the front shows the room. Rounding to
  // sixteenths may turn a sliver over; its pixels are then covered once too often on one side and once on the other.
  EXPECT_EQ(inside.drawn_count(), shown - turned) << "each pixel once";
  const Mesh mesh = room.owned.view();
  const FrameView view{room.settings.camera, {room.width, room.height}, 16, 0, 65534};
  const ExactView exact(view, mesh, room.transform);
  const std::vector<Face> faces = faces_of(mesh, exact);
  const auto number = [](Q16_16 q) { return static_cast<double>(real(q)); };
  const double focal = number(view.camera.focal), near = number(view.camera.near_plane),
               far = number(view.camera.far_plane);
  for (int y = 0; y < room.height; ++y)
    for (int x = 0; x < room.width; ++x) {
      // The picture's y runs down, view space's up.
      const auto hit = [&](double px, double py) {
        return exit_distance(faces, (px - room.width * 0.5) / focal, (room.height * 0.5 - py) / focal);
      };
      double low = hit(x + 0.5, y + 0.5), high = low;
      for (const double dx : {-0.2, 0.2})
        for (const double dy : {-0.2, 0.2}) {
          const double z = hit(x + 0.5 + dx, y + 0.5 + dy);
          low = std::min(low, z);
          high = std::max(high, z);
        }
      ++pixels;
      // Within a fifth of a pixel of the cut, snapped corners decide.
      const bool surely = low > near * 1.0001 && high < far * 0.9999,
                 surely_not = high < near * 0.9999 || low > far * 1.0001;
      if (!surely && !surely_not) {
        ++near_misses;
        continue;
      }
      ASSERT_EQ(inside.drawn(x, y), surely)
          << "pixel " << x << ", " << y << ": the room ends at " << low << " … " << high << ", near " << near;
    }
}

void check_rooms(std::uint32_t seed, int wanted, double smallest_near, double greatest_near, double far) {
  Random random(seed);
  long pixels = 0, near_misses = 0;
  for (int i = 0; i < rounds(wanted); ++i) {
    Room room(random, smallest_near, greatest_near, far);
    check_room(room, pixels, near_misses);
    if (::testing::Test::HasFailure()) {
      ADD_FAILURE() << "room " << i << ", focal " << room.settings.camera.focal.raw() << ", near "
                    << room.settings.camera.near_plane.raw() << ", " << room.width << " x " << room.height;
      return;
    }
  }
  std::printf("%ld pixels, %ld of them too near a cut to judge\n", pixels, near_misses);
}

TEST(Clipping, ARoomHasNoGapWhereTheNearPlaneCutsIt) { check_rooms(1, 60, 0.2, 0.8, 10); }
TEST(Clipping, ARoomHasNoGapWhereTheFarPlaneCutsIt) { check_rooms(2, 40, 0.05, 0.1, 0.7); }
TEST(Clipping, ARoomHasNoGapWhereFacesReachFarBeyondTheGuardBand) { check_rooms(3, 60, 0.001, 0.01, 10); }

/// A sheet over the whole picture whose middle column of corners lies on an edge of the guard band, to a tenth of a
/// pixel, and its last column beyond it.
OwnedMesh sheet_at_guard_edge(Random& random, int width, int height, bool perspective) {
  OwnedMesh owned;
  const bool along_y = random.chance(2), low_side = random.chance(2);
  const auto point = [&](double across, double along) {
    // Screen to view space: at z = 100 a unit is a pixel, and farther points move out with their distance.
    const double z = 100 + random.real(0, 60), scale = perspective ? z / 100 : 1;
    const double x = (along_y ? along : across) - width * 0.5, y = height * 0.5 - (along_y ? across : along);
    const auto steps = [](double v) { return static_cast<std::int32_t>(std::lround(v * 8192)); };
    owned.wide_vertices.push_back({steps(x * scale), steps(y * scale), steps(-z)});
  };
  const double before = low_side ? (along_y ? height : width) + 200 : -200, edge = low_side ? -2047 : 2047,
               beyond = low_side ? -3000 : 3000;
  constexpr int rows = 12;
  for (int r = 0; r <= rows; ++r) {
    const double along = -1500 + 3300.0 * r / rows;
    point(before + random.real(-90, 90), along + random.real(-60, 60));
    point(edge + random.real(-0.1, 0.1), along + random.real(-60, 60));
    point(beyond + random.real(-500, 500), along + random.real(-60, 60));
  }
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < 2; ++c) {
      const std::size_t corner = r * 3 + c;
      owned.triangle(corner, corner + 1, corner + 4);
      owned.triangle(corner, corner + 4, corner + 3);
    }
  owned.fit_bounds();
  return owned;
}

// Whether a corner on the very edge of the guard band is clipped must not depend on the triangle.
TEST(Clipping, CornersAtTheEdgeOfTheGuardBandLeaveNoGap) {
  constexpr int width = 320, height = 240;
  Random random(6);
  for (int i = 0; i < rounds(600); ++i) {
    FrameSettings settings;
    settings.cull = Cull::none;
    const bool perspective = random.chance(2);
    settings.camera.projection = perspective ? Projection::perspective : Projection::orthographic;
    settings.camera.focal = Q16_16::from_int(perspective ? 100 : 1);
    settings.camera.near_plane = Q16_16::from_int(1);
    settings.camera.far_plane = Q16_16::from_int(1000);
    const OwnedMesh owned = sheet_at_guard_edge(random, width, height, perspective);
    Studio<Ids> studio(mesh_capacity(width, height, 1, owned.wide_vertices.size(), owned.indices.size() / 3));
    const Mesh mesh = owned.view();
    studio.begin(settings);
    studio.add(mesh, {}, {});
    const auto picture = studio.draw();
    ASSERT_TRUE(studio.status().ok());
    ASSERT_EQ(picture.drawn_count(), std::size_t{width} * height) << "gaps in round " << i;
    ASSERT_EQ(studio.statistics().visibility.depth_tests, picture.drawn_count()) << "covered twice in round " << i;
  }
}

TEST(Clipping, NothingCrashesAtAnyPlacementAndRangesOfAnyKind) {
  Random random(4);
  for (int i = 0; i < rounds(2000); ++i) {
    const RandomInstance r(random, {.wide = random.chance(2),
                                    .orthographic = random.chance(3),
                                    .closest = 0.01,
                                    .farthest = 20,
                                    .aside = 6,
                                    .range_around = false,
                                    .vertices = 30,
                                    .depth_bits = 16});
    Studio<Ids> studio(mesh_capacity(r.view.viewport.width, r.view.viewport.height, 1, r.mesh.vertex_count(),
                                     r.mesh.triangle_count()));
    FrameSettings settings;
    settings.camera = r.view.camera;
    settings.cull = Cull::none;
    studio.begin(settings);
    if (!studio.status().ok()) continue;
    studio.add(r.mesh, r.transform, {});
    (void)studio.draw();
    ASSERT_TRUE(studio.status().ok()) << to_string(studio.status().fault) << ' ' << to_string(studio.status().pool);
  }
}

TEST(Clipping, NothingCrashesAtTheEndsOfEveryRange) {
  Random random(5);
  const auto extreme = [&](std::int32_t low, std::int32_t high) {
    return random.chance(3) ? random.between(low, high) : random.chance(2) ? low : high;
  };
  constexpr std::int32_t limit = 1 << 30;
  for (int i = 0; i < rounds(6000); ++i) {
    OwnedMesh owned;
    const bool wide = random.chance(2);
    for (int k = 0; k < 9; ++k) {
      if (wide)
        owned.wide_vertices.push_back({extreme(-limit, limit), extreme(-limit, limit), extreme(-limit, limit)});
      else
        owned.vertices.push_back({static_cast<std::int16_t>(extreme(-32768, 32767)),
                                  static_cast<std::int16_t>(extreme(-32768, 32767)),
                                  static_cast<std::int16_t>(extreme(-32768, 32767))});
    }
    for (std::size_t k = 0; k < 9; k += 3) owned.triangle(k, k + 1, k + 2);
    owned.fit_bounds();
    owned.offset = random.chance(2)
                       ? Vec3<std::int32_t>{}
                       : Vec3<std::int32_t>{extreme(-limit, limit), extreme(-limit, limit), extreme(-limit, limit)};
    owned.step_exponent = static_cast<std::int8_t>(extreme(-30, 14));
    Transform transform;
    transform.rotation = random_rotation(random);
    transform.scale = Fixed<24>::from_raw(random.chance(2) ? 1 << 24 : extreme(1, 0x7fffffff));
    constexpr std::int32_t ends = 0x7fffffff;
    const auto position = [&] { return random.chance(2) ? Q16_16{} : Q16_16::from_raw(extreme(-ends, ends)); };
    transform.translation = {position(), position(), position()};
    FrameSettings settings;
    settings.cull = Cull::none;
    Camera& camera = settings.camera;
    camera.projection = random.chance(3) ? Projection::orthographic : Projection::perspective;
    camera.eye = {position(), position(), position()};
    camera.axes = random_rotation(random);
    camera.focal = Q16_16::from_raw(extreme(1, 0x7ffeffff));
    camera.near_plane = Q16_16::from_raw(random.chance(2) ? 1 << random.between(0, 29) : extreme(1, ends - 1));
    camera.far_plane = Q16_16::from_raw(random.between(camera.near_plane.raw() + 1, ends));
    Studio<Ids> studio(mesh_capacity(64, 48, 1, 9, 3));
    const Mesh mesh = owned.view();
    studio.begin(settings);
    ASSERT_TRUE(studio.status().ok());
    studio.add(mesh, transform, {});
    (void)studio.draw();
    ASSERT_TRUE(studio.status().ok()) << to_string(studio.status().pool);
  }
}

}  // namespace
}  // namespace spanline::test
