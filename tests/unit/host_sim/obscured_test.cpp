// Lecture 001's set O: which triangles are obscured, and by what.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>
#include <sstream>

#include "import/model_file.hpp"
#include "import/obj_objects.hpp"
#include "model_files.hpp"
#include "render/frame.hpp"
#include "render/statistics_json.hpp"
#include "render_fixture.hpp"
#include "room_obj.hpp"
#include "scene/core_mesh.hpp"
#include "scene/core_values.hpp"
#include "scene/displacement.hpp"
#include "scene/scene_bytes.hpp"
#include "scene/view.hpp"
#include "scene/world.hpp"

namespace spanline::sim::test {
namespace {

using Objects = std::vector<std::uint32_t>;

struct Box {
  Vector3 low, high;
};

/// Boxes one behind the other, each an object: six quadrilaterals counter-clockwise from outside, in the sequence
/// front, back, left, right, top, bottom as seen from +z.
std::string boxes_obj(const std::vector<Box>& boxes) {
  std::ostringstream text;
  int first = 1;
  for (const auto& [low, high] : boxes) {
    text << "o box" << first << '\n';
    for (int corner = 0; corner < 8; ++corner)
      text << "v " << ((corner & 1) != 0 ? high.x : low.x) << ' ' << ((corner & 2) != 0 ? high.y : low.y) << ' '
           << ((corner & 4) != 0 ? high.z : low.z) << '\n';
    constexpr int faces[6][4] = {{4, 5, 7, 6}, {1, 0, 2, 3}, {0, 4, 6, 2}, {5, 1, 3, 7}, {6, 7, 3, 2}, {0, 1, 5, 4}};
    for (const auto& face : faces) {
      text << 'f';
      for (const int corner : face) text << ' ' << first + corner;
      text << '\n';
    }
    first += 8;
  }
  return text.str();
}

/// The lecture's picture: a box, a second one behind it that it hides in part, and a third one behind both.
std::string lecture_obj() {
  return boxes_obj({{{-1, -1, -1}, {1, 1, 1}}, {{-0.5, -1, -4}, {3.5, 1, -2}}, {{0.7, -0.6, -10}, {3, 0.6, -6}}});
}
const std::vector<std::string> lecture_view{"--eye",  "0,0,8",   "--target", "0,0,0", "--fov", "40",
                                            "--size", "640x480", "--near",   "1",     "--far", "30"};

class ObscuredTest : public RenderTest {
 protected:
  /// The statistics' polygons of a picture of a model.
  [[nodiscard]] nlohmann::json polygons_of(const std::string& model, const std::vector<std::string>& options) const {
    render(model, with(options, {"--stats", in_folder("s.json")}));
    return nlohmann::json::parse(read_text(in_folder("s.json"))).at("polygons");
  }
  [[nodiscard]] Objects objects_of(const std::string& name, const std::string& content) const {
    return import_model(make_file(name, content)).triangle_objects;
  }
};

nlohmann::json sets(int same_object, int other_object, int both) {
  return {{"same_object", same_object}, {"other_object", other_object}, {"both", both}};
}

// The eye is on the z axis at 8. The first box's front is 7 away and reaches to 1/7 = 0.143 to every side, in units of
// the picture at distance 1; the second one's, 10 away, goes from −0.05 to 0.35 and its back, 12 away, from −0.042 to
// 0.292, each within the height of the first box. So of the second box the first one hides the left face, what its
// back, top and bottom have on the left of 0.143, and half of its front; its own front hides its right face and the
// rest of back, top and bottom, each of whose triangles has pixels on both sides of 0.143. The third one lies between
// 0.038 and 0.215, all of it behind one or the other.
TEST_F(ObscuredTest, LecturesPicture) {
  const std::string model = make_file("a.obj", lecture_obj());
  for (const AlgorithmEntry& algorithm : visibility_algorithms()) {
    SCOPED_TRACE(algorithm.name);
    const auto options = with(lecture_view, {"--visibility", algorithm.name});
    // Ten triangles of the first box lie behind its front. Both polygons of the second one's front can be seen.
    const nlohmann::json all = polygons_of(model, with(options, {"--cull", "none"}));
    EXPECT_EQ(all.at("total"), 36);
    EXPECT_EQ(all.at("back"), 0);
    EXPECT_EQ(all.at("visible"), 4);
    EXPECT_EQ(all.at("obscured"), 32);
    EXPECT_EQ(all.at("obscured_by"), sets(10 + 2, 2 + 12, 6));
    // Without backs there is the third box's front and its left face, which the eye is on the left of.
    const nlohmann::json fronts = polygons_of(model, options);
    EXPECT_EQ(fronts.at("back"), 28);
    EXPECT_EQ(fronts.at("visible"), 4);
    EXPECT_EQ(fronts.at("obscured"), 4);
    EXPECT_EQ(fronts.at("obscured_by"), sets(0, 4, 0));
  }
}

TEST_F(ObscuredTest, WithoutObjectsAllIsOne) {
  std::string text = lecture_obj();
  for (std::size_t at = 0; (at = text.find("o box", at)) != std::string::npos;) text[at] = 'g';
  const std::string model = make_file("a.obj", text);
  EXPECT_EQ(polygons_of(model, with(lecture_view, {"--cull", "none"})).at("obscured_by"), sets(32, 0, 0));
  EXPECT_EQ(polygons_of(model, lecture_view).at("obscured_by"), sets(4, 0, 0));
}

// In the picture of ids, glass hides what is behind it.
TEST_F(ObscuredTest, GlassHidesAsInThePictureOfIds) {
  make_file("a.mtl", "newmtl glass\nKd 1 0 0\nd 0.4\nnewmtl wall\nKd 0 0 1\n");
  const std::string model = make_file("a.obj",
                                      "mtllib a.mtl\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\nv -1 -1 0\nv 1 -1 0\n"
                                      "v 1 1 0\nv -1 1 0\no pane\nusemtl glass\nf 1 2 3 4\no wall\nusemtl wall\n"
                                      "f 5 6 7 8\n");
  const nlohmann::json polygons = polygons_of(model, front);
  EXPECT_EQ(polygons.at("visible"), 2);
  EXPECT_EQ(polygons.at("obscured_by"), sets(0, 2, 0));
}

// One triangle of a square that is drawn whole is seen, and a triangle of another object hides the other.
TEST_F(ObscuredTest, TrianglesOfASquareAreToldApart) {
  const std::string square = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\no square\nf 1 2 3 4\n";
  for (const char* half : {"v -2 -2.2 1\nv 2 1.8 1\nv -2 1.8 1\n", "v -2.2 -2 1\nv 2 -2 1\nv 2 2.2 1\n"}) {
    const std::string model = make_file("a.obj", square + half + "o half\nf 5 6 7\n");
    const nlohmann::json polygons = polygons_of(model, with(front, {"--ortho", "4"}));
    EXPECT_EQ(polygons.at("whole"), 1);
    EXPECT_EQ(polygons.at("visible"), 2);
    EXPECT_EQ(polygons.at("obscured_by"), sets(0, 1, 0));
  }
}

TEST_F(ObscuredTest, SetsOfAClosedBodyAddUp) {
  std::ostringstream text;  // a torus of 24 × 12 quadrilaterals
  constexpr int around = 24, across = 12;
  for (int i = 0; i < around; ++i) {
    for (int k = 0; k < across; ++k) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * k / across;
      text << "v " << (3 + std::cos(v)) * std::cos(u) << ' ' << std::sin(v) << ' ' << (3 + std::cos(v)) * std::sin(u)
           << '\n';
    }
  }
  for (int i = 0; i < around; ++i) {
    for (int k = 0; k < across; ++k) {
      const auto vertex = [](int m, int n) { return 1 + m % around * across + n % across; };
      text << "f " << vertex(i, k) << ' ' << vertex(i, k + 1) << ' ' << vertex(i + 1, k + 1) << ' ' << vertex(i + 1, k)
           << '\n';
    }
  }
  const std::string model = make_file("a.obj", text.str());
  for (const char* cull : {"back", "none"}) {
    const nlohmann::json polygons = polygons_of(model, {"--eye", "9,2,0", "--target", "0,0,0", "--cull", cull});
    EXPECT_GT(polygons.at("obscured"), 20);
    EXPECT_EQ(polygons.at("obscured_by"), sets(polygons.at("obscured"), 0, 0));
  }
}

// The bundled models are an object each.
TEST_F(ObscuredTest, BundledModelsAreOneObject) {
  for (const char* model : {SPANLINE_TEST_MODELS "/bunny.obj", SPANLINE_TEST_MODELS "/teapot.obj"}) {
    for (const AlgorithmEntry& algorithm : visibility_algorithms()) {
      SCOPED_TRACE(std::string(model) + " by " + algorithm.name);
      const nlohmann::json polygons = polygons_of(model, {"--visibility", algorithm.name, "--cull", "none"});
      EXPECT_GT(polygons.at("obscured"), 100);
      EXPECT_EQ(polygons.at("obscured_by"), sets(polygons.at("obscured"), 0, 0));
    }
  }
}

TEST_F(ObscuredTest, SetsAreNullWithoutIds) {
  const nlohmann::json polygons = nlohmann::json::parse(to_json(FrameStatistics{})).at("polygons");
  EXPECT_TRUE(polygons.at("obscured").is_null());
  EXPECT_TRUE(polygons.at("obscured_by").is_null());
}

/// A scene and a view of it, to be drawn in parts.
struct Drawn {
  Scene scene;
  View view;
  World world;
  Size size;
  FrameRequest request;

  [[nodiscard]] Frame of(const Scene& part, BoundingSphere bounds) const {
    std::vector<CoreMesh> meshes = to_core_meshes(part, world);
    for (CoreMesh& mesh : meshes) mesh.bounds = bounds;
    return FrameRenderer(meshes).draw(request);
  }
  /// The pixels that a triangle covers: those where it is seen when it is drawn alone.
  [[nodiscard]] std::vector<std::uint32_t> alone(std::size_t triangle, BoundingSphere bounds) const {
    Scene part;
    part.positions = scene.positions;
    part.triangles = {scene.triangles[triangle]};
    part.polygon_normals = {scene.polygon_normals[triangle]};
    return of(part, bounds).ids;
  }
};

// Each obscured triangle, drawn alone, tells which pixels it covers.
TEST_F(ObscuredTest, SetsAreThoseOfTrianglesDrawnAlone) {
  Drawn drawn;
  drawn.size = {160, 120};
  drawn.scene = welded(import_model(make_file("room.obj", room_obj())));
  drawn.scene.vertex_normals.clear();
  for (std::size_t i = 0; i < drawn.scene.triangles.size(); ++i)  // two boxes an object
    drawn.scene.triangle_objects.push_back(static_cast<std::uint32_t>(i / 24));
  std::uint64_t both_in_all = 0, whole_in_all = 0;
  for (int side = 0; side < 10; ++side) {
    ViewRequest asked;
    asked.eye = Vector3{0.3, 0.1, 0.4};
    const double turn = 2 * std::numbers::pi * side / 10;
    asked.target = Vector3{0.3 + std::sin(turn), 0, 0.4 - std::cos(turn)};
    asked.field_of_view = 80;
    asked.near_plane = 0.5;  // clips what is beside the eye
    asked.far_plane = 30;
    drawn.view = resolve_view(asked, drawn.scene, drawn.size, false);
    drawn.world = choose_world(drawn.view, drawn.scene, drawn.size);
    FrameRequest& request = drawn.request;
    request.size = drawn.size;
    request.camera = to_camera(drawn.view, drawn.world, drawn.size);
    request.cull = Cull::none;
    request.want_ids = request.want_statistics = true;
    request.objects = drawn.scene.triangle_objects;
    const BoundingSphere bounds = to_core_meshes(drawn.scene, drawn.world).front().bounds;
    for (const AlgorithmEntry& algorithm : visibility_algorithms()) {
      SCOPED_TRACE(std::string(algorithm.name) + ", side " + std::to_string(side));
      request.visibility = &algorithm;
      request.depth_bits = algorithm.depth_bits;
      request.band_lines = algorithm.full_frame() ? drawn.size.height : 16;
      const Frame frame = drawn.of(drawn.scene, bounds);
      const Objects& objects = drawn.scene.triangle_objects;
      std::uint64_t same_object = 0, other_object = 0, both = 0;
      for (std::size_t triangle = 0; triangle < drawn.scene.triangles.size(); ++triangle) {
        bool seen = false, same = false, other = false;
        const std::vector<std::uint32_t> covered = drawn.alone(triangle, bounds);
        for (std::size_t pixel = 0; pixel < covered.size(); ++pixel) {
          if (covered[pixel] == 0) continue;
          const std::size_t hider = frame.ids[pixel] - 1;
          seen = seen || hider == triangle;
          (objects[hider] == objects[triangle] ? same : other) = true;
        }
        if (seen || !(same || other)) continue;
        ++(same && other ? both : same ? same_object : other_object);
      }
      const PolygonSets& polygons = frame.statistics.polygons;
      ASSERT_TRUE(polygons.obscured_by);
      EXPECT_EQ(polygons.obscured_by->same_object, same_object);
      EXPECT_EQ(polygons.obscured_by->other_object, other_object);
      EXPECT_EQ(polygons.obscured_by->both, both);
      EXPECT_EQ(polygons.obscured, same_object + other_object + both);
      both_in_all += both;
      whole_in_all += polygons.whole;
    }
  }
  EXPECT_GT(both_in_all, 20U);
  EXPECT_GT(whole_in_all, 20U);
}

TEST_F(ObscuredTest, ObjectsOfObjFiles) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  const auto objects = [&](const std::string& text) { return objects_of("a.obj", vertices + text); };
  EXPECT_EQ(objects("f 1 2 3\n"), Objects{});
  EXPECT_EQ(objects("o a\nf 1 2 3\nf 1 2 3 4\n"), Objects{});
  EXPECT_EQ(objects("g a\nf 1 2 3\ng b\nf 1 2 3\n"), Objects{}) << "groups are parts of an object";
  EXPECT_EQ(objects("f 1 2 3\no a\nf 1 2 3 4\no b\nf -4 -3 -2\n"), (Objects{0, 1, 1, 2}));
  EXPECT_EQ(objects("o a\nf 1 2 3\n  o b \r\nf 1 2 3\n o  a\nf 1// 2// 3//\n"), (Objects{1, 2, 1}));
  EXPECT_EQ(objects("o a b\nf 1 2 3\no a c\nf 1 2 3\n"), (Objects{1, 2}));
  EXPECT_EQ(objects("o a\nf 1 2 \\\n3 4\no b\nf 1 2 3\n"), (Objects{1, 1, 2}));
  EXPECT_EQ(objects("o a\nf 1 2 \\\r\n3 4\no b\nf 1 2 3"), (Objects{1, 1, 2}));
  EXPECT_EQ(objects("o a\nl 1 2\np 1\nf 1 2\nf 1 2 3\no b\n# f 1 2 3\nf 1 2 3\n"), (Objects{1, 2}));
  EXPECT_EQ(objects_of_obj(""), Objects{});
}

TEST_F(ObscuredTest, ObjectsOfOtherFiles) {
  std::string nodes = triangle_gltf("\"translation\": [1, 2, 3]");
  const auto put = [&](const std::string& from, const std::string& to) {
    nodes.replace(nodes.find(from), from.size(), to);
  };
  EXPECT_EQ(objects_of("one.gltf", nodes), Objects{});
  put("\"nodes\": [0]", "\"nodes\": [0, 1]");
  put("\"nodes\": [{\"mesh\": 0", "\"nodes\": [{\"mesh\": 0}, {\"mesh\": 0");
  EXPECT_EQ(objects_of("two.gltf", nodes), (Objects{0, 1}));
  EXPECT_EQ(objects_of("one.stl", triangle_stl()), Objects{});
  EXPECT_EQ(objects_of("two.stl", triangle_stl() + triangle_stl()).size(), 2U);
  EXPECT_EQ(objects_of("a.ply", triangle_ply()), Objects{});
}

TEST_F(ObscuredTest, ScenesKeepObjects) {
  Scene scene = import_model(make_file("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\no b\nf 2 3 1\n"));
  const Objects objects = scene.triangle_objects;
  EXPECT_EQ(objects, (Objects{0, 1}));
  EXPECT_EQ(welded(scene).triangle_objects, objects);
  const std::optional<Scene> copy = scene_from_bytes(to_bytes(scene));
  ASSERT_TRUE(copy);
  EXPECT_EQ(copy->triangle_objects, objects);
  scene.texture_points.resize(scene.positions.size());
  const HeightImage flat{1, 0, {0, 0, 0, 0}};
  EXPECT_EQ(displaced(scene, flat, {0, 1}).triangle_objects, (Objects{0, 0, 0, 0, 1, 1, 1, 1}));
  scene.triangle_objects.pop_back();
  EXPECT_FALSE(scene_from_bytes(to_bytes(scene)));
}

}  // namespace
}  // namespace spanline::sim::test
