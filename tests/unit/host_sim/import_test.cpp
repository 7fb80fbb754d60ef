#include "import/model_file.hpp"

#include "base/failure.hpp"
#include "model_files.hpp"
#include "tool.hpp"

namespace spanline::sim::test {
namespace {

using ImportTest = ToolTest;

/// The corners of a triangle, by their positions.
std::array<Vector3, 3> corners_of(const Scene& scene, std::size_t triangle) {
  const Scene::Triangle& t = scene.triangles.at(triangle);
  return {scene.positions.at(t[0]), scene.positions.at(t[1]), scene.positions.at(t[2])};
}

void expect_near(Vector3 got, Vector3 want) {
  EXPECT_NEAR(got.x, want.x, 1e-6);
  EXPECT_NEAR(got.y, want.y, 1e-6);
  EXPECT_NEAR(got.z, want.z, 1e-6);
}

TEST_F(ImportTest, EveryFormatGivesTheSameTriangle) {
  const std::vector<std::pair<std::string, std::string>> models{
      {"a.obj", triangle_obj()},        {"a.ply", triangle_ply()},   {"b.ply", triangle_binary_ply()},
      {"a.stl", triangle_stl()},        {"a.gltf", triangle_gltf()}, {"a.glb", triangle_glb()},
      {"b.stl", triangle_binary_stl()}, {"A.OBJ", triangle_obj()}};
  for (const auto& [name, content] : models) {
    SCOPED_TRACE(name);
    const Scene scene = import_model(make_file(name, content));
    ASSERT_EQ(scene.triangles.size(), 1U);
    const auto corners = corners_of(scene, 0);
    expect_near(corners[0], {0, 0, 0});
    expect_near(corners[1], {1, 0, 0});
    expect_near(corners[2], {0, 1, 0});
    expect_near(scene.polygon_normals.at(0), {0, 0, 1});
    EXPECT_FALSE(scene.normals_from_file);
    EXPECT_TRUE(scene.polygon_colours.empty());
    EXPECT_TRUE(scene.vertex_colours.empty());
  }
}

TEST_F(ImportTest, PolygonsBecomeFansFromTheirFirstCorner) {
  const std::string pentagon = "v 0 0 0\nv 2 0 0\nv 3 1 0\nv 1 3 0\nv -1 1 0\nf 1 2 3 4 5\n";
  const Scene scene = import_model(make_file("a.obj", pentagon));
  ASSERT_EQ(scene.triangles.size(), 3U);
  const std::array<Vector3, 5> points{Vector3{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 3, 0}, {-1, 1, 0}};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto corners = corners_of(scene, i);
    expect_near(corners[0], points[0]);
    expect_near(corners[1], points[i + 1]);
    expect_near(corners[2], points[i + 2]);
  }
}

TEST_F(ImportTest, FileOrderOutlivesGroupsAndMaterialsThatComeTwice) {
  std::string text = "mtllib a.mtl\n";
  for (int i = 0; i < 4; ++i) {
    const std::string x = std::to_string(i);
    text += "v " + x + " 0 0\nv " + x + " 1 0\nv " + x + " 0 1\n";
  }
  text +=
      "o A\nusemtl red\nf 1 2 3\no B\nusemtl green\nf 4 5 6\no A\nusemtl red\nf 7 8 9\ng B\nusemtl green\nf 10 11 12\n";
  make_file("a.mtl", "newmtl red\nKd 1 0 0\nnewmtl green\nKd 0 0.5 0\n");
  const Scene scene = import_model(make_file("a.obj", text));
  ASSERT_EQ(scene.triangles.size(), 4U);
  ASSERT_EQ(scene.polygon_colours.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(corners_of(scene, i)[0].x, static_cast<double>(i));
    EXPECT_EQ(scene.polygon_colours[i], (i % 2 == 0 ? Rgb888{255, 0, 0} : Rgb888{0, 128, 0}));
  }
}

TEST_F(ImportTest, NodesScaleTurnAndMove) {
  const std::string node =
      R"("scale": [2, 3, 4], "rotation": [0, 0, 0.70710678, 0.70710678], "translation": [10, 20, 30])";
  const Scene scene = import_model(make_file("a.gltf", triangle_gltf(node)));
  const auto corners = corners_of(scene, 0);
  expect_near(corners[0], {10, 20, 30});
  expect_near(corners[1], {10, 22, 30});
  expect_near(corners[2], {7, 20, 30});
  expect_near(scene.polygon_normals[0], {0, 0, 1});
}

TEST_F(ImportTest, MirroringNodesTurnTrianglesOver) {
  const Scene scene = import_model(make_file("a.gltf", triangle_gltf(R"("scale": [-1, 1, 1])")));
  const auto c = corners_of(scene, 0);
  // Mirrored in x, the front still looks towards +z.
  EXPECT_GT(cross(c[1] - c[0], c[2] - c[0]).z, 0);
  expect_near(scene.polygon_normals[0], {0, 0, 1});
}

TEST_F(ImportTest, NormalsOfTheFileFollowNonUniformScale) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 2\nf 1//1 2//1 3//1\n";
  const Scene scene = import_model(make_file("a.obj", text));
  EXPECT_TRUE(scene.normals_from_file);
  ASSERT_EQ(scene.vertex_normals.size(), 3U);
  for (const Vector3 normal : scene.vertex_normals) expect_near(normal, {0, 0, 1});
}

TEST_F(ImportTest, ColoursOfMaterialsAndVertices) {
  const std::string red = R"({"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0.2, 1]}})";
  const Scene material = import_model(make_file("a.gltf", triangle_gltf("", red)));
  ASSERT_EQ(material.polygon_colours.size(), 1U);
  EXPECT_EQ(material.polygon_colours[0], (Rgb888{255, 0, 51}));

  const std::string coloured = "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3\n";
  const Scene vertices = import_model(make_file("c.obj", coloured));
  ASSERT_EQ(vertices.vertex_colours.size(), 3U);
  EXPECT_EQ(vertices.vertex_colours[vertices.triangles[0][1]], (Rgb888{0, 255, 0}));
}

TEST_F(ImportTest, PointsAndLinesAreDropped) {
  const Scene scene = import_model(make_file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\np 1\nl 1 2 3\nf 1 2 3\nl 2 3\n"));
  EXPECT_EQ(scene.triangles.size(), 1U);
}

TEST_F(ImportTest, FaultsNameTheFile) {
  const std::string path = make_file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  try {
    static_cast<void>(import_model(path));
    FAIL() << "an index out of range was taken";
  } catch (const Failure& failure) {
    EXPECT_TRUE(std::string(failure.what()).starts_with(path + ": ")) << failure.what();
    EXPECT_EQ(failure.exit_code(), 1);
  }
}

TEST_F(ImportTest, OpacitiesOfMaterialsAreKeptByParts) {
  make_file("a.mtl", "newmtl glass\nKd 0 0 1\nd 0.5\nnewmtl wood\nKd 1 0 0\n");
  const std::string model = make_file("a.obj",
                                      "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
                                      "usemtl glass\nf 1 2 3\nusemtl wood\nf 2 4 3\nf 1 4 2\n");
  const Scene scene = import_model(model);
  EXPECT_TRUE(is_see_through(scene));
  ASSERT_EQ(scene.parts.size(), 2U);
  EXPECT_EQ(scene.parts[0].opacity, 128U);
  EXPECT_EQ(scene.parts[1].first, 1U);
  EXPECT_EQ(scene.parts[1].opacity, 255U);
  EXPECT_EQ(scene.parts[1].colour, (Rgb888{255, 0, 0}));
}

TEST_F(ImportTest, AlphaModesOfGltfSayWhatOpacityMeans) {
  const auto opacity = [&](const std::string& mode) {
    const std::string material =
        R"({"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 0.25]})" + (mode.empty() ? "" : ", " + mode) + "}";
    return import_model(make_file("a.gltf", triangle_gltf("", material))).parts.at(0).opacity;
  };
  EXPECT_EQ(opacity(""), 255U);  // opaque is glTF's default
  EXPECT_EQ(opacity(R"("alphaMode": "OPAQUE")"), 255U);
  EXPECT_EQ(opacity(R"("alphaMode": "BLEND")"), 64U);
  EXPECT_EQ(opacity(R"("alphaMode": "MASK")"), 0U);  // below the cut-off, one half
  EXPECT_EQ(opacity(R"("alphaMode": "MASK", "alphaCutoff": 0.2)"), 255U);
}

TEST_F(ImportTest, VerticesHaveOpacitiesOfTheirOwnWhereAnyIsNotOpaque) {
  const auto ply = [&](int alpha) {
    return import_model(make_file("a.ply",
                                  "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                                  "property float y\nproperty float z\nproperty uchar red\n"
                                  "property uchar green\nproperty uchar blue\nproperty uchar alpha\n"
                                  "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                                  "0 0 0 255 0 0 255\n1 0 0 0 255 0 " +
                                      std::to_string(alpha) + "\n0 1 0 0 0 255 255\n3 0 1 2\n"));
  };
  const Scene scene = welded(ply(51));
  EXPECT_TRUE(is_see_through(scene));
  EXPECT_EQ(scene.vertex_opacities, (std::vector<std::uint8_t>{255, 51, 255}));
  EXPECT_FALSE(is_see_through(ply(255)));
}

}  // namespace
}  // namespace spanline::sim::test
