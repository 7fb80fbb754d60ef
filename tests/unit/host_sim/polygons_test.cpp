// Polygons of a file stay polygons on their way to the core's meshes, where the core may draw them as one.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <set>
#include <sstream>

#include "convert/flash_mesh.hpp"
#include "import/model_file.hpp"
#include "model_files.hpp"
#include "render_fixture.hpp"
#include "room_obj.hpp"
#include "scene/core_mesh.hpp"
#include "scene/displacement.hpp"
#include "scene/scene_bytes.hpp"
#include "spanline/model/validate.hpp"

namespace spanline::sim::test {
namespace {

constexpr std::uint8_t whole(unsigned corners) { return static_cast<std::uint8_t>(corners | Mesh::planar); }
using Counts = std::vector<std::uint8_t>;

/// An upright prism about the y axis: two polygons of so many corners, and as many quadrilaterals.
std::string prism_obj(int corners) {
  std::ostringstream text;
  for (int i = 0; i < 2 * corners; ++i) {
    const double turn = 2 * std::numbers::pi * (i % corners) / corners;
    text << "v " << std::cos(turn) << ' ' << (i < corners ? 0 : 1.7) << ' ' << -std::sin(turn) << '\n';
  }
  text << 'f';
  for (int i = corners; i > 0; --i) text << ' ' << i;
  text << "\nf";
  for (int i = 1; i <= corners; ++i) text << ' ' << corners + i;
  text << '\n';
  for (int i = 0; i < corners; ++i) {
    const int a = i + 1, b = (i + 1) % corners + 1;
    text << "f " << a << ' ' << b << ' ' << corners + b << ' ' << corners + a << '\n';
  }
  return text.str();
}

class PolygonsTest : public RenderTest {
 protected:
  [[nodiscard]] Scene scene_of(const std::string& obj) const { return welded(import_model(make_file("a.obj", obj))); }

  /// The meshes that are drawn, which are valid.
  [[nodiscard]] static std::vector<CoreMesh> drawn(const Scene& scene) {
    const View view = resolve_view({}, scene, Size{}, true);
    std::vector<CoreMesh> meshes = to_core_meshes(scene, choose_world(view, scene, Size{}));
    for (const CoreMesh& mesh : meshes)
      EXPECT_TRUE(validate(mesh.view()).ok()) << to_string(validate(mesh.view()).fault);
    return meshes;
  }
  /// The corner counts of its meshes for pictures and for flash, which are the same and valid.
  [[nodiscard]] static Counts corners_of(const Scene& scene) {
    const std::vector<CoreMesh> meshes = drawn(scene);
    EXPECT_EQ(meshes.size(), 1U);
    const CoreMesh flash = to_flash_mesh(scene);
    EXPECT_TRUE(validate(flash.view()).ok()) << to_string(validate(flash.view()).fault);
    EXPECT_EQ(meshes.at(0).corners, flash.corners);
    EXPECT_EQ(flash.view().triangle_count(), scene.triangles.size());
    return flash.corners;
  }
  [[nodiscard]] Counts corners_of(const std::string& obj) const { return corners_of(scene_of(obj)); }

  [[nodiscard]] nlohmann::json polygon_counts() const {
    return nlohmann::json::parse(read_text(in_folder("s.json"))).at("polygons");
  }
};

TEST_F(PolygonsTest, PrismsAreMarkedPolygons) {
  EXPECT_EQ(corners_of(cube_obj()), Counts(6, whole(4)));
  for (unsigned corners = 5; corners <= 8; ++corners) {
    Counts wanted(2 + corners, whole(4));
    wanted[0] = wanted[1] = whole(corners);
    EXPECT_EQ(corners_of(prism_obj(static_cast<int>(corners))), wanted) << corners;
  }
}

TEST_F(PolygonsTest, LargerPolygonsStandAsTriangles) {
  Counts wanted(14, 3);
  wanted.insert(wanted.end(), 9, whole(4));
  EXPECT_EQ(corners_of(prism_obj(9)), wanted);
}

TEST_F(PolygonsTest, MeshesOfTrianglesHaveNoTableOfCorners) {
  EXPECT_EQ(corners_of(triangle_obj()), Counts{});
  EXPECT_EQ(corners_of("v 0 0 0\nv 1 0 0\nv 1 1 0.3\nv 0 1 0\nf 1 2 3 4\n"), Counts{}) << "bent";
  EXPECT_EQ(corners_of("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\nf 1 2 3 4 5\n"), Counts{}) << "concave";
  EXPECT_EQ(corners_of("v 1 0.5 0\nv 0 2 0\nv 0 0 0\nv 2 0 0\nv 2 2 0\nf 1 2 3 4 5\n"), Counts{})
      << "concave at the fan's corner";
  EXPECT_EQ(corners_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 1 2 3\n"), Counts{}) << "winds twice";
}

TEST_F(PolygonsTest, BentOnesStandAsTrianglesBetweenOthers) {
  EXPECT_EQ(corners_of("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0.5\nv 2 1 0\nf 1 2 3 4\nf 2 5 6 3\nf 1 3 2\n"),
            (Counts{whole(4), 3, 3, 3}));
}

TEST_F(PolygonsTest, ColoursAndNormalsAreThoseOfTheTriangles) {
  Scene scene = scene_of(cube_obj());
  const std::vector<Vector3> normals = scene.polygon_normals;
  scene.polygon_colours.assign(12, Rgb888{1, 2, 3});
  scene.polygon_colours[3] = {9, 9, 9};
  scene.polygon_colours[10] = scene.polygon_colours[11] = {7, 7, 7};
  const CoreMesh mesh = to_flash_mesh(scene);
  EXPECT_TRUE(validate(mesh.view()).ok());
  EXPECT_EQ(mesh.corners, (Counts{whole(4), 3, 3, whole(4), whole(4), whole(4), whole(4)}));
  EXPECT_EQ(mesh.polygon_colours[1], (Rgb888{1, 2, 3}));
  EXPECT_EQ(mesh.polygon_colours[2], (Rgb888{9, 9, 9}));
  EXPECT_EQ(mesh.polygon_colours[6], (Rgb888{7, 7, 7}));
  EXPECT_EQ(mesh.polygon_normals[0], PackedNormal(0, 0, 511));
  EXPECT_EQ(mesh.polygon_normals[6], PackedNormal(0, -511, 0));
}

TEST_F(PolygonsTest, CornersWithColoursOfTheirOwnAreTriangles) {
  Scene scene = scene_of("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  scene.polygon_colours = {{255, 0, 0}, {0, 0, 255}};
  polygon_colours_to_vertices(scene);
  EXPECT_EQ(corners_of(welded(scene)), Counts{});
  scene = scene_of("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  scene.polygon_colours = {{255, 0, 0}, {255, 0, 0}};
  polygon_colours_to_vertices(scene);
  EXPECT_EQ(corners_of(scene), Counts{}) << "vertices apart";
  EXPECT_EQ(corners_of(welded(scene)), Counts{whole(4)});
  // Colours that are not linear over the square.
  scene = welded(scene);
  scene.vertex_colours[3] = {0, 0, 0};
  EXPECT_EQ(corners_of(scene), Counts{});
}

TEST_F(PolygonsTest, PlyFilesHaveThemToo) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0.5 0\n4 0 1 2 3\n3 1 4 2\n";
  EXPECT_EQ(corners_of(welded(import_model(make_file("a.ply", ply)))), (Counts{whole(4), 3}));
}

TEST_F(PolygonsTest, ScenesKeepThemOrForgetThem) {
  Scene scene = scene_of(prism_obj(5));
  EXPECT_EQ(scene.polygon_triangles, (Counts{3, 3, 2, 2, 2, 2, 2}));
  EXPECT_TRUE(scene_of(triangle_obj()).polygon_triangles.empty());
  const std::optional<Scene> copy = scene_from_bytes(to_bytes(scene));
  ASSERT_TRUE(copy);
  EXPECT_EQ(copy->polygon_triangles, scene.polygon_triangles);
  for (const Counts& wrong : {Counts{3, 3, 2, 2, 2, 2}, Counts{3, 3, 2, 2, 2, 2, 3}, Counts{0, 3, 3, 2, 2, 2, 2, 2},
                              Counts{7, 1, 2, 2, 2, 2}}) {
    Scene broken = scene;
    broken.polygon_triangles = wrong;
    EXPECT_FALSE(scene_from_bytes(to_bytes(broken)));
  }
  Scene parted = scene;
  parted.parts = {{0, 255}, {3, 128}};
  EXPECT_TRUE(scene_from_bytes(to_bytes(parted)));
  EXPECT_EQ(drawn(parted).size(), 2U);
  parted.parts[1].first = 4;
  EXPECT_FALSE(scene_from_bytes(to_bytes(parted))) << "a part that begins within a polygon";
  scene.texture_points.resize(scene.positions.size());
  const HeightImage flat{1, 0, {0, 0, 0, 0}};
  EXPECT_TRUE(displaced(scene, flat, {0, 1}).polygon_triangles.empty());
}

TEST_F(PolygonsTest, MeshesAreCutBetweenPolygons) {
  Scene scene;
  constexpr std::uint32_t count = 20000;  // quadrilaterals with vertices of their own
  for (std::uint32_t i = 0; i < count; ++i) {
    const double x = i;
    for (const Vector3 corner : {Vector3{x, 0, 0}, Vector3{x + 1, 0, 0}, Vector3{x + 1, 1, 0}, Vector3{x, 1, 0}})
      scene.positions.push_back(corner);
    scene.triangles.push_back({4 * i, 4 * i + 1, 4 * i + 2});
    scene.triangles.push_back({4 * i, 4 * i + 2, 4 * i + 3});
  }
  scene.polygon_normals.assign(scene.triangles.size(), {0, 0, 1});
  scene.polygon_triangles.assign(count, 2);
  std::size_t polygons = 0;
  for (const CoreMesh& mesh : drawn(scene)) {
    EXPECT_EQ(mesh.corners, Counts(mesh.corners.size(), whole(4)));
    polygons += mesh.corners.size();
  }
  EXPECT_EQ(polygons, count);
}

TEST_F(PolygonsTest, IdsAreThoseOfTheTriangles) {
  const std::string quads = make_file("a.obj", cube_obj());
  std::string split;
  std::istringstream lines(cube_obj());
  for (std::string line; std::getline(lines, line);) {
    int a = 0, b = 0, c = 0, d = 0;
    if (std::sscanf(line.c_str(), "f %d %d %d %d", &a, &b, &c, &d) != 4) {
      split += line + "\n";
      continue;
    }
    const auto face = [](int i, int j, int k) {
      return "f " + std::to_string(i) + " " + std::to_string(j) + " " + std::to_string(k) + "\n";
    };
    split += face(a, b, c) + face(a, c, d);
  }
  const std::string triangles = make_file("b.obj", split);
  const auto ids = [&](const std::string& model) {
    render(model, {"--ids-out", in_folder("ids.png"), "--stats", in_folder("s.json")});
    return read_png(in_folder("ids.png"));
  };
  const Picture of_quads = ids(quads);
  EXPECT_EQ(polygon_counts().at("whole"), 3);
  const Picture of_triangles = ids(triangles);
  EXPECT_EQ(polygon_counts().at("whole"), 0);
  EXPECT_EQ(of_quads.pixels, of_triangles.pixels);
  std::set<std::uint32_t> seen;
  for (const Rgb888 pixel : of_quads.pixels) seen.insert(number_of(pixel));
  EXPECT_EQ(seen.size(), 7U) << "six triangles and the background";
}

TEST_F(PolygonsTest, ARoomsPolygonsEnterWhole) {
  const std::string room = make_file("room.obj", room_obj());
  int entering = 0, whole_ones = 0;
  for (int side = 0; side < 20; ++side) {
    const double turn = 2 * std::numbers::pi * side / 20;
    const std::string target = std::to_string(0.3 + std::sin(turn)) + (side % 2 == 0 ? ",0.2," : ",-0.1,") +
                               std::to_string(0.4 - std::cos(turn));
    render(room, {"--eye", "0.3,0.1,0.4", "--target", target, "--fov", "70", "--near", "0.05", "--far", "30", "--size",
                  "160x120", "--stats", in_folder("s.json")});
    const nlohmann::json counts = polygon_counts();
    const auto count = [&](const char* set) { return counts.at(set).get<int>(); };
    EXPECT_EQ(count("total"), 144);
    for (const char* set : {"empty", "obscured", "visible"}) EXPECT_LE(count(set), 144) << set;
    entering += (count("total") - count("outside") - count("back")) / 2;
    whole_ones += count("whole");
  }
  EXPECT_GT(entering, 100);
  EXPECT_GE(100 * whole_ones, 95 * entering);
}

}  // namespace
}  // namespace spanline::sim::test
