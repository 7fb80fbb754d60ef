// Large polygons in front of smaller ones, for algorithms that set hidden polygons aside: what is hidden may come out
// again where an edge bends, ends or crosses, and where the one in front is itself hidden or ends.
#include "generators.hpp"
#include "sizes.hpp"

namespace spanline::contract {
namespace {

/// A triangle that hides others: large, upright, or with edges on the picture's border or beyond it.
Corners front(Random& random, const Scene& scene, std::int32_t depth) {
  const int right = 16 * scene.width, bottom = 16 * scene.height;
  const int slope = random.chance(2) ? 0 : 1 << random.between(0, 18);
  const auto corner = [&](int x, int y) { return corner_near(x, y, depth + random.between(-slope, slope)); };
  const auto any_x = [&] { return random.between(0, right); };
  const auto any_y = [&] { return random.between(0, bottom); };
  switch (random.between(0, 5)) {
    case 0:  // an upright edge on the left border
      return {corner(0, random.between(-100, bottom / 4)), corner(0, bottom), corner(any_x(), any_y())};
    case 1:  // and on the right one
      return {corner(right, random.between(-100, bottom / 4)), corner(right, bottom), corner(any_x(), any_y())};
    case 2:  // edges beyond the borders on both sides
      return {corner(random.between(-guard, 0), random.between(-600, bottom / 2)),
              corner(random.between(right, guard), random.between(-600, bottom / 2)),
              corner(any_x(), bottom + random.between(0, 3000))};
    case 3:  // an edge that leaves the picture on the way down
      return {corner(any_x(), 0), corner(right + random.between(-600, 600), bottom), corner(any_x() - 200, bottom)};
    case 4:
      return {corner(any_x(), random.between(-50, 50)), corner(any_x(), any_y()),
              corner(any_x(), bottom + random.between(-50, 50))};
    default:
      return {corner(random.between(-500, right + 500), random.between(-500, bottom + 500)),
              corner(random.between(-500, right + 500), random.between(-500, bottom + 500)),
              corner(random.between(-500, right + 500), random.between(-500, bottom + 500))};
  }
}

/// A point of a triangle, 64ths of the way to its corners.
Corner inside(const Corners& t, int a, int b) {
  const auto mixed = [&](int p, int q, int r) {
    const std::int64_t sum = std::int64_t{p} * a + std::int64_t{q} * b + std::int64_t{r} * (64 - a - b);
    return static_cast<int>(sum / 64);
  };
  return {mixed(t[0].x, t[1].x, t[2].x), mixed(t[0].y, t[1].y, t[2].y), 0};
}
Corner anywhere_inside(Random& random, const Corners& t) {
  const int a = random.between(0, 64);
  return inside(t, a, random.between(0, 64 - a));
}

/// A triangle that lies within another, or nearly.
Corners behind(Random& random, const Corners& hider) {
  Corners t;
  switch (random.between(0, 6)) {
    case 0:  // equal edges
      t = hider;
      break;
    case 1:  // one edge in common
      t = hider;
      t[static_cast<std::size_t>(random.between(0, 2))] = anywhere_inside(random, hider);
      break;
    case 2: {  // smaller, edges parallel
      const Corner middle = anywhere_inside(random, hider);
      const int part = random.between(8, 60);
      for (std::size_t i = 0; i < 3; ++i)
        t[i] = {middle.x + (hider[i].x - middle.x) * part / 64, middle.y + (hider[i].y - middle.y) * part / 64, 0};
      break;
    }
    case 3: {  // moved a little: sticks out at one side
      t = hider;
      const int dx = random.between(-24, 24), dy = random.between(-24, 24);
      for (Corner& c : t) {
        c.x += dx;
        c.y += dy;
      }
      break;
    }
    case 4:  // one corner comes out, sooner or later
      for (Corner& c : t) c = anywhere_inside(random, hider);
      t[0].x += random.between(-400, 400);
      t[0].y += random.between(0, 400);
      break;
    case 5:  // corners on edges
      for (Corner& c : t) {
        const int part = random.between(0, 64);
        c = inside(hider, part, random.chance(2) ? 64 - part : 0);
      }
      break;
    default:
      for (Corner& c : t) c = anywhere_inside(random, hider);
  }
  return t;
}

}  // namespace

Scene nested_polygons(Random& random) {
  Scene scene = sized(random);
  if (random.chance(4)) scene.height = 240;
  const int fronts = random.between(1, 5);
  for (int i = 0; i < fronts; ++i) {
    const std::int32_t depth = random.between(1 << 19, 8 << 20);
    const Corners hider = front(random, scene, depth);
    scene.triangles.push_back(hider);
    const int count = random.between(1, 25);
    Corners last = hider;
    for (int k = 0; k < count; ++k) {
      // Hidden ones hide others in turn.
      Corners t = behind(random, random.chance(3) ? last : hider);
      const std::int32_t distance = random.between(6000, 6 << 20), slope = random.chance(2) ? 0 : distance / 3;
      for (Corner& c : t)
        c = corner_near(c.x, c.y, std::int64_t{depth} + (1 << 18) + distance + random.between(-slope, slope));
      scene.triangles.push_back(t);
      last = t;
    }
  }
  if (!random.chance(3)) shuffle(random, scene.triangles);
  return scene;
}

/// Pairs with level upper edges on pixel centres and one upper corner in common, the farther within the nearer on that
/// row: edges that are at one place there and go on alike or apart, by whole pixels a row as well.
Scene shared_corners(Random& random) {
  Scene scene = sized(random);
  const int right = 16 * scene.width, bottom = 16 * scene.height;
  const int pairs = random.between(1, 8);
  for (int i = 0; i < pairs; ++i) {
    const int y = 16 * random.between(-2, scene.height / 2) + 8, x0 = random.between(-200, right - 64),
              x1 = random.between(x0 + 64, right + 400),
              tall = random.between(16 * 16, random.chance(2) ? bottom : 8000);
    const int apex = random.between(0, 2 * right) - right / 2, depth = random.between(1 << 12, 1 << 22);
    scene.triangles.push_back(
        {corner_near(x0, y, depth), corner_near(x1, y, depth), corner_near(apex, y + tall, depth)});
    const bool left = random.chance(2);
    const int shared = left ? x0 : x1, inner = random.between(x0 + 16, x1 - 16);
    int low = apex, high = tall;
    switch (random.between(0, 3)) {
      case 0:  // as many sixteenths a row more or less
        low += tall * random.between(-2, 2);
        break;
      case 1:  // nearly alike
        low += random.between(-20, 20);
        break;
      case 2:  // another height at the same slope, or nearly
        high = random.between(tall / 2, tall * 2);
        low = shared + (apex - shared) * high / tall + random.between(-1, 1);
        break;
      default:
        low = random.between(0, 2 * right) - right / 2;
    }
    const std::int64_t farther = depth + random.between(1, 1 << 20);
    scene.triangles.push_back({corner_near(left ? shared : inner, y, farther),
                               corner_near(left ? inner : shared, y, farther), corner_near(low, y + high, farther)});
  }
  if (random.chance(2)) shuffle(random, scene.triangles);
  return scene;
}

}  // namespace spanline::contract
