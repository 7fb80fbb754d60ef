#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <sstream>

#include "base/vector.hpp"
#include "tool.hpp"

/// Pictures between all kinds of near and far planes against a reference in doubles: the same triangle at every pixel
/// but for those within an eighth of a pixel of an edge, and depths by the planes asked for.
namespace spanline::sim::test {
namespace {

constexpr int width = 64, height = 48;
constexpr double move = 0.125;  ///< of pixels: twice what snapping to sixteenths does to an edge

/// A cube with a pyramid that pierces its front.
struct Solid {
  std::vector<Vector3> points{{-1, -1, -1}, {1, -1, -1}, {1, 1, -1},    {-1, 1, -1},     {-1, -1, 1},    {1, -1, 1},
                              {1, 1, 1},    {-1, 1, 1},  {0.1, 0, 1.6}, {-0.7, -0.6, 0}, {0.7, -0.6, 0}, {0, 0.8, 0}};
  std::vector<std::array<std::size_t, 3>> triangles{
      {4, 5, 6}, {4, 6, 7}, {1, 0, 3}, {1, 3, 2}, {0, 4, 7},  {0, 7, 3},   {5, 1, 2},  {5, 2, 6},
      {7, 6, 2}, {7, 2, 3}, {0, 1, 5}, {0, 5, 4}, {8, 9, 10}, {8, 10, 11}, {8, 11, 9}, {9, 11, 10}};
};

struct Seen {
  std::uint32_t id = 0;
  double z = 0;  ///< along the axis of view
};

/// A camera in units of the solid, and what it sees at points of the picture.
struct Reference {
  Vector3 eye;
  std::optional<double> ortho_height;
  double near_plane, far_plane;
  bool culled = true;

  /// What triangle `number` has at a point of the picture, its plane where `anywhere`.
  [[nodiscard]] std::optional<double> depth_of(std::size_t number, double u, double v, bool anywhere = false) const {
    const Vector3 backwards = normalised(eye), right = normalised(cross({0, 1, 0}, backwards));
    const Vector3 above = cross(backwards, right);
    const double tangent = std::tan(std::numbers::pi / 8);
    const double unit = ortho_height ? *ortho_height / height : 2 * tangent / height;
    const Vector3 aside = right * ((u - width / 2.0) * unit) + above * ((height / 2.0 - v) * unit);
    const Vector3 from = ortho_height ? eye + aside : eye;
    const Vector3 ray = ortho_height ? backwards * -1.0 : aside - backwards;
    const auto& [a, b, c] = solid.triangles[number];
    const Vector3 p = solid.points[a], q = solid.points[b], r = solid.points[c];
    const Vector3 normal = cross(q - p, r - p);
    if (culled && dot(normal, ray) >= 0) return std::nullopt;
    const double z = dot(p - from, normal) / dot(ray, normal);
    if (anywhere) return z;
    const Vector3 at = from + ray * z;
    if (z < near_plane || z > far_plane || dot(cross(q - p, at - p), normal) < 0 ||
        dot(cross(r - q, at - q), normal) < 0 || dot(cross(p - r, at - r), normal) < 0)
      return std::nullopt;
    return z;
  }

  [[nodiscard]] Seen at(double u, double v) const {
    Seen seen{0, std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < solid.triangles.size(); ++i) {
      const std::optional<double> z = depth_of(i, u, v);
      if (z && *z < seen.z) seen = {static_cast<std::uint32_t>(i + 1), *z};
    }
    return seen;
  }

  [[nodiscard]] double depth_integer(double z, int bits) const {
    const double share = ortho_height ? (z - near_plane) / (far_plane - near_plane)
                                      : (1 - near_plane / z) / (1 - near_plane / far_plane);
    return share * (std::ldexp(1, bits) - 1);
  }

  Solid solid;
};

class PlanesTest : public ToolTest {
 protected:
  [[nodiscard]] std::string solid_obj(double scale, const std::string& name = "solid.obj") const {
    const Solid solid;
    std::ostringstream text;
    text.precision(9);
    for (const Vector3 p : solid.points)
      text << "v " << p.x * scale << ' ' << p.y * scale << ' ' << p.z * scale << '\n';
    for (const auto& [a, b, c] : solid.triangles) text << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
    return make_file(name, text.str());
  }

  /// Draws the solid in that scale; planes that are not given are chosen by the tool, and so are not looked at.
  [[nodiscard]] ToolRun draw(const std::string& model, double scale, const Reference& reference, bool with_near,
                             bool with_far, int bits, const std::string& sense = "smaller") const {
    const auto number = [scale](double value) {
      std::ostringstream text;
      text.precision(12);
      text << value * scale;
      return text.str();
    };
    std::vector<std::string> arguments{
        "render",
        model,
        "-o",
        in_folder("out.png"),
        "--ids-out",
        in_folder("ids.png"),
        "--depth-out",
        in_folder("depth.png"),
        "--eye",
        number(reference.eye.x) + "," + number(reference.eye.y) + "," + number(reference.eye.z),
        "--target",
        "0,0,0",
        "--size",
        "64x48",
        "--depth",
        std::to_string(bits),
        "--cull",
        reference.culled ? "back" : "none",
        "--depth-sense",
        sense};
    const auto add = [&](const char* option, double value) {
      arguments.emplace_back(option);
      arguments.push_back(number(value));
    };
    if (with_near) add("--near", reference.near_plane);
    if (with_far) add("--far", reference.far_plane);
    if (reference.ortho_height) add("--ortho", *reference.ortho_height);
    return run(arguments);
  }

  void expect_right(const Reference& reference, bool planes_given, int bits, bool larger = false) const {
    const Picture ids = read_png(in_folder("ids.png")), depths = read_png(in_folder("depth.png"));
    int wrong_ids = 0, wrong_depths = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const double u = x + 0.5, v = y + 0.5;
        const std::uint32_t id = number_of(ids.at(x, y));
        std::vector<Seen> around;
        for (const double dx : {0.0, -move, move})
          for (const double dy : {0.0, -move, move}) around.push_back(reference.at(u + dx, v + dy));
        if (std::none_of(around.begin(), around.end(), [id](const Seen& seen) { return seen.id == id; })) ++wrong_ids;
        if (id == 0 || !planes_given || around[0].id != id) continue;
        const double want = reference.depth_integer(around[0].z, bits);
        double slack = 2;
        for (const double dx : {-move, move})
          for (const double dy : {-move, move}) {
            const std::optional<double> z = reference.depth_of(id - 1, u + dx, v + dy, true);
            if (z) slack = std::max(slack, 2 + std::fabs(reference.depth_integer(*z, bits) - want));
          }
        const double greatest = std::ldexp(1, bits) - 1;
        const double got = larger ? greatest - number_of(depths.at(x, y)) : number_of(depths.at(x, y));
        // The formats keep 16 depths free at both ends.
        if (std::fabs(got - std::clamp(want, bits == 16 ? 0.0 : 16.0, greatest - 17)) > slack + (bits == 16 ? 16 : 0))
          ++wrong_depths;
      }
    EXPECT_EQ(wrong_ids, 0);
    EXPECT_EQ(wrong_depths, 0);
  }
};

TEST_F(PlanesTest, OfAllKindsGiveTheRightPictureAndItsDepths) {
  constexpr double none = -1;
  unsigned number = 0;
  const std::string small_model = solid_obj(1e-3, "small.obj"), large_model = solid_obj(1e6, "large.obj");
  for (const double ortho : {none, 3.1})
    for (const double near_plane : {none, 1e-12, 1e-3, 1.0, 3.4, 30.0})
      for (const double far_plane : {none, 1e-9, 4.3, 9.0, 300.0, 30000.0, 1e9, 1e15}) {
        if (near_plane != none && far_plane != none && near_plane >= far_plane) continue;
        ++number;
        const double scale = number % 2 == 0 ? 1e-3 : 1e6;
        const int bits = number / 2 % 2 == 0 ? 16 : 24;
        const std::string& model = number % 2 == 0 ? small_model : large_model;
        SCOPED_TRACE("scale " + std::to_string(scale) + " ortho " + std::to_string(ortho) + " near " +
                     std::to_string(near_plane) + " far " + std::to_string(far_plane));
        Reference reference{{0.9, 0.7, 4}, {}, near_plane, far_plane, true, {}};
        if (ortho != none) reference.ortho_height = ortho;
        // The least that the tool may choose is a thousandth of where the model ends.
        if (near_plane == none) reference.near_plane = ortho == none ? std::min(0.006, far_plane) : -1e9;
        if (near_plane == none && far_plane != none && far_plane < 1) reference.near_plane = far_plane / 2;
        if (far_plane == none) reference.far_plane = 1e9;
        const ToolRun result = draw(model, scale, reference, near_plane != none, far_plane != none, bits);
        ASSERT_EQ(result.exit_code, 0) << result.errors;
        EXPECT_EQ(result.errors, "");
        expect_right(reference, near_plane != none && far_plane != none, bits);
      }
}

TEST_F(PlanesTest, DepthsOfTheOtherSenseAreThoseOfThePlanesAskedForAsWell) {
  const std::string model = solid_obj(1);
  const Reference reference{{0.9, 0.7, 4}, {}, 0.5, 1e7, true, {}};
  for (const int bits : {16, 24}) {
    ASSERT_EQ(draw(model, 1, reference, true, true, bits, "larger").exit_code, 0);
    expect_right(reference, true, bits, true);
  }
}

TEST_F(PlanesTest, InsideAModelANearPlaneIsTakenOrRefusedByItsName) {
  const std::string model = solid_obj(1);
  for (const double near_plane : {1e-12, 1e-9, 1e-6, 1e-3, 0.01, 0.1}) {
    SCOPED_TRACE(near_plane);
    const Reference reference{{0.3, 0.2, 0.4}, {}, near_plane, 1e6, false, {}};
    const auto before = files();
    const ToolRun result = draw(model, 1, reference, true, true, 24);
    if (result.exit_code == 0) {
      expect_right(reference, false, 24);
      continue;
    }
    EXPECT_LT(near_plane, 1e-3);
    expect_refused(result, 2, before);
    EXPECT_TRUE(result.errors.starts_with("spanline: error: --near: ")) << result.errors;
  }
}

TEST_F(PlanesTest, ATargetFarAwayCostsNoPrecision) {
  const std::string model = solid_obj(1);
  const auto picture = [&](const std::string& target) {
    EXPECT_EQ(run({"render", model, "-o", in_folder("out.png"), "--eye", "0,0,4", "--target", target}).errors, "");
    return read_png(in_folder("out.png"));
  };
  EXPECT_EQ(picture("0,0,-1e9"), picture("0,0,0"));
}

TEST_F(PlanesTest, WhatIsTooNarrowIsTheViewThatWasAskedFor) {
  const std::string model = solid_obj(1);
  const auto before = files();
  for (const std::vector<std::string>& view : {std::vector<std::string>{"--ortho", "1e-9"}, {"--fov", "1e-7"}})
    for (const std::string far_plane : {"10", "1e9"}) {
      const ToolRun result = run({"render", model, "-o", in_folder("out.png"), view[0], view[1], "--far", far_plane});
      expect_refused(result, 2, before);
      EXPECT_TRUE(result.errors.starts_with("spanline: error: " + view[0] + ": ")) << result.errors;
    }
}

TEST_F(PlanesTest, WhatLiesTooFarAwayIsTheEyeOrTheTarget) {
  const std::string model = solid_obj(1);
  const auto before = files();
  for (const auto& [option, place] :
       {std::pair{"--eye", "1e30,0,0"}, {"--eye", "1e300,0,0"}, {"--target", "1e30,0,0"}, {"--target", "1e300,0,0"}}) {
    const ToolRun result = run({"render", model, "-o", in_folder("out.png"), option, place});
    expect_refused(result, 2, before);
    EXPECT_TRUE(result.errors.starts_with(std::string("spanline: error: ") + option + ": ")) << result.errors;
  }
}

}  // namespace
}  // namespace spanline::sim::test
