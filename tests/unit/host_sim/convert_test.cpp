#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

#include "base/failure.hpp"
#include "convert/flash_mesh.hpp"
#include "convert/header_writer.hpp"
#include "model_files.hpp"
#include "scene/displacement.hpp"
#include "spanline/model/validate.hpp"
#include "tool.hpp"

// Made by the real command while this test was built.
#include "coloured.hpp"
#include "cube.hpp"
#include "cube_texture.hpp"
#include "parts.hpp"
#include "square.hpp"

namespace spanline::sim::test {
namespace {

constexpr const Mesh& cube = spanline_models::cube;
constexpr const Mesh& coloured = spanline_models::two_colours;

static_assert(cube.polygon_count() == 6 && cube.triangle_count() == 12 && cube.vertex_count() == 8,
              "tables are constants");

TEST(Convert, TablesAreValidMeshes) {
  EXPECT_TRUE(validate(cube).ok()) << to_string(validate(cube).fault);
  EXPECT_TRUE(validate(coloured).ok()) << to_string(validate(coloured).fault);
}

TEST(Convert, PositionsAreThoseOfTheFile) {
  for (const Vertex16& v : cube.vertices) {
    for (const std::int32_t steps : {v.x + cube.offset.x, v.y + cube.offset.y, v.z + cube.offset.z})
      EXPECT_NEAR(std::fabs(std::ldexp(steps, cube.step_exponent)), 1, std::ldexp(1, cube.step_exponent));
  }
  // The finest step whose 65,536 values span an edge of 2, both ends included.
  EXPECT_EQ(cube.step_exponent, -14);
  // The first polygon of the file is 5 6 7 8.
  EXPECT_EQ(cube.indices[0], 0);
  EXPECT_EQ(cube.corners[0], 4 | Mesh::planar);
  EXPECT_EQ(cube.polygon_normals[0], PackedNormal(0, 0, 511));
  EXPECT_EQ(cube.vertex_normals.size(), 8U);
  EXPECT_TRUE(cube.polygon_colours.empty());
  EXPECT_TRUE(cube.vertex_colours.empty());
}

TEST(Convert, ColoursComeFromMaterials) {
  ASSERT_EQ(coloured.polygon_colours.size(), 2U);
  EXPECT_EQ(coloured.polygon_colours[0], (Rgb888{255, 0, 0}));
  EXPECT_EQ(coloured.polygon_colours[1], (Rgb888{0, 0, 255}));
}

TEST(Convert, PartsHaveMaterialsAndTextures) {
  const auto& parts = spanline_models::parts;
  ASSERT_EQ(std::size(parts), 2U);
  EXPECT_TRUE(validate(*parts[0].mesh).ok());
  EXPECT_EQ(parts[0].mesh->triangle_count(), 1U);
  EXPECT_EQ(parts[0].mesh->texture_coordinates.size(), 3U);
  EXPECT_EQ(parts[0].material.colour, (Rgb888{255, 128, 255}));
  ASSERT_NE(parts[0].material.texturing.texture, nullptr);
  EXPECT_EQ(validate(*parts[0].material.texturing.texture), TextureFault::none);
  EXPECT_EQ(parts[0].material.texturing.texture->log2_width, 6);  // 48 x 32, made powers of two
  EXPECT_EQ(parts[0].material.texturing.texture->log2_height, 5);
  EXPECT_EQ(parts[1].material.colour, (Rgb888{0, 0, 255}));
  EXPECT_EQ(parts[1].material.opacity, 128);
  EXPECT_EQ(parts[1].material.texturing.texture, nullptr);
  EXPECT_FALSE(parts[0].material.shines());
  EXPECT_EQ(parts[1].material.specular, (Rgb888{255, 0, 102}));
  EXPECT_EQ(parts[1].material.shininess, 60);
  EXPECT_TRUE(parts[1].mesh->texture_coordinates.empty());
}

TEST(Convert, FarFromTheOriginOffsetsKeepPrecision) {
  Scene scene;
  scene.positions = {{1000, 2000, -3000}, {1001, 2000, -3000}, {1000, 2001, -3000}};
  scene.triangles = {{0, 1, 2}};
  const CoreMesh mesh = to_flash_mesh(scene);
  EXPECT_TRUE(validate(mesh.view()).ok());
  EXPECT_EQ(std::ldexp(mesh.vertices[0].x + mesh.offset.x, mesh.step_exponent), 1000);
  EXPECT_EQ(std::ldexp(mesh.vertices[1].x + mesh.offset.x, mesh.step_exponent), 1001);
  EXPECT_EQ(std::ldexp(mesh.vertices[0].z + mesh.offset.z, mesh.step_exponent), -3000);
}

TEST(Convert, LimitsAreNamed) {
  const auto message_for = [](const Scene& scene) {
    try {
      static_cast<void>(to_flash_mesh(scene));
    } catch (const Failure& failure) {
      return std::string(failure.what());
    }
    return std::string();
  };
  Scene vertices;
  for (int i = 0; i < 65538; ++i) vertices.positions.push_back({static_cast<double>(i), 0, 0});
  for (std::uint32_t i = 0; i + 2 < 65538; i += 3) vertices.triangles.push_back({i, i + 1, i + 2});
  EXPECT_NE(message_for(vertices).find("65535"), std::string::npos);
  Scene triangles;
  triangles.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangles.triangles.assign(32768, {0, 1, 2});
  EXPECT_NE(message_for(triangles).find("32767"), std::string::npos);
  Scene far_away;
  far_away.positions = {{1e14, 0, 0}, {1e14, 1, 0}, {1e14, 0, 1}};
  far_away.triangles = {{0, 1, 2}};
  EXPECT_NE(message_for(far_away), "");
}

/// A square of two triangles whose texture coordinates are its own, and heights that rise to the right.
Scene textured_sheet() {
  Scene scene;
  scene.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  scene.texture_points = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  scene.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.polygon_normals = {{0, 0, 1}, {0, 0, 1}};
  return scene;
}
HeightImage slope() {
  HeightImage heights{4, 0, {}};
  for (int i = 0; i < 16; ++i) heights.heights.push_back(static_cast<std::uint8_t>(i * 16));
  return heights;
}

TEST(Displacement, PointsMoveAlongTheirNormalsByTheHeight) {
  const HeightImage heights = slope();
  const Scene moved = displaced(textured_sheet(), heights, {0.5, 3});
  EXPECT_EQ(moved.triangles.size(), 2U * 64);
  // 9 × 9 points of a square, shared by the triangles.
  ASSERT_EQ(moved.positions.size(), 81U);
  for (std::size_t i = 0; i < moved.positions.size(); ++i) {
    const Vector3 p = moved.positions[i];
    const TexturePoint t = moved.texture_points[i];
    EXPECT_EQ(p.x, t.s);
    EXPECT_EQ(p.y, 1 - t.t);
    EXPECT_NEAR(p.z, 0.5 * heights.at(t.s, t.t), 1e-12);
    // Between the first texel's middle and the last's the slope is 16/255 a texel, 16 texels a unit.
    if (t.s < 0.125 || t.s > 0.875) continue;
    EXPECT_NEAR(p.z, 0.5 * (t.s * 16 - 0.5) * 16 / 255, 1e-12);
  }
  for (std::size_t i = 0; i < moved.triangles.size(); ++i) {
    const double middle = (moved.positions[moved.triangles[i][0]].x + moved.positions[moved.triangles[i][1]].x +
                           moved.positions[moved.triangles[i][2]].x) /
                          3;
    const double rise = 0.5 * 256 / 255;
    if (middle < 0.13 || middle > 0.87) continue;
    EXPECT_NEAR(moved.polygon_normals[i].x / moved.polygon_normals[i].z, -rise, 1e-9) << middle;
  }
  EXPECT_EQ(moved.vertex_normals.size(), moved.positions.size());
}

TEST(Displacement, SeamsStayClosed) {
  // Two halves of a sheet that share an edge in space and not in the texture.
  Scene scene = textured_sheet();
  scene.positions.insert(scene.positions.end(), {{1, 0, 0}, {2, 0, 0.5}, {2, 1, 0.5}, {1, 1, 0}});
  scene.texture_points.insert(scene.texture_points.end(), {{0.3, 1}, {0.6, 1}, {0.6, 0}, {0.3, 0}});
  scene.triangles.insert(scene.triangles.end(), {{4, 5, 6}, {4, 6, 7}});
  scene.polygon_normals.resize(4, {0, 0, 1});
  const Scene moved = displaced(scene, slope(), {0.3, 2});
  int on_seam = 0;
  for (std::size_t i = 0; i < moved.positions.size(); ++i) {
    if (moved.texture_points[i].s != 1) continue;
    ++on_seam;
    int twins = 0;
    for (std::size_t k = 0; k < moved.positions.size(); ++k)
      twins += moved.texture_points[k].s == 0.3 && moved.positions[k] == moved.positions[i] ? 1 : 0;
    EXPECT_EQ(twins, 1);
  }
  EXPECT_EQ(on_seam, 5);
}

TEST(Displacement, PartsAndColoursFollowTheirTriangles) {
  Scene scene = textured_sheet();
  scene.parts = {{0, 255}, {1, 128}};
  scene.polygon_colours = {{255, 0, 0}, {0, 0, 255}};
  const Scene moved = displaced(scene, slope(), {0, 1});
  EXPECT_EQ(moved.parts, (std::vector<Scene::Part>{{0, 255}, {4, 128}}));
  EXPECT_EQ(moved.polygon_colours[3], (Rgb888{255, 0, 0}));
  EXPECT_EQ(moved.polygon_colours[4], (Rgb888{0, 0, 255}));
  EXPECT_THROW(static_cast<void>(displaced(scene, slope(), {0, 12})), Failure);
  scene.texture_points.clear();
  EXPECT_THROW(static_cast<void>(displaced(scene, slope(), {0, 1})), Failure);
}

TEST(Convert, Identifiers) {
  for (const char* name : {"a", "bunny_2", "Mesh", "class_"}) EXPECT_TRUE(is_identifier(name)) << name;
  for (const char* name : {"", "2a", "_a", "a__b", "class", "a-b", "co_await", "\xc3\xa4"})
    EXPECT_FALSE(is_identifier(name)) << name;
  EXPECT_EQ(identifier_from("/x/My model (2).hpp"), "My_model_2_");
  EXPECT_EQ(identifier_from("3d.hpp"), "model_3d");
  EXPECT_EQ(identifier_from("class.hpp"), "class_mesh");
  for (const char* name : {"My model (2).hpp", "3d.hpp", "class.hpp", "__.hpp", "\xc3\xa4.hpp", ".hpp", ""})
    EXPECT_TRUE(is_identifier(identifier_from(name))) << name;
}

TEST(Convert, TexturesAreValidTables) {
  constexpr const Texture& texture = spanline_textures::cube_texture;
  EXPECT_EQ(validate(texture), TextureFault::none);
  EXPECT_EQ(texture.format, TexelFormat::palette16);
  EXPECT_EQ(texture.log2_width, 6);  // 48 is nearer to 64, by its logarithm
  EXPECT_EQ(texture.log2_height, 5);
  EXPECT_EQ(texture.levels, 7);
  EXPECT_EQ(texture.wrap_s, Wrap::clamp);
  EXPECT_EQ(texture.palette.size(), 16U);
}

TEST(Convert, TextureCoordinatesCountDownwards) {
  const Mesh& mesh = spanline_models::square;
  ASSERT_EQ(mesh.texture_coordinates.size(), 4U);
  EXPECT_EQ(mesh.texture_exponent, -12);
  EXPECT_EQ(mesh.texture_coordinates[0].s, 0);
  EXPECT_EQ(mesh.texture_coordinates[0].t, 4096);
  EXPECT_EQ(mesh.texture_coordinates[2].s, 4 * 4096);
  EXPECT_EQ(mesh.texture_coordinates[2].t, 0);
  EXPECT_TRUE(spanline_models::cube.texture_coordinates.empty());
}

using ConvertTest = ToolTest;

TEST_F(ConvertTest, ImagesThatCannotBeTexturesAreRefusedByName) {
  const std::string picture = in_folder("p.png"), model = make_file("a.obj", cube_obj());
  ASSERT_EQ(run({"render", model, "-o", picture, "--size", "20x16"}).exit_code, 0);
  const std::string cut = make_file("cut.jpg", "\xff\xd8\xff\xe0 and no more");
  const auto before = files();
  for (const auto& [image, more] : {std::pair<std::string, std::vector<std::string>>{picture, {}},
                                    {cut, {}},
                                    {in_folder("none.png"), {"--resize"}}}) {
    std::vector<std::string> arguments{"convert", image, "-o", in_folder("t.hpp")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ToolRun result = run(arguments);
    expect_refused(result, 1, before);
    EXPECT_NE(result.errors.find(image), std::string::npos) << result.errors;
  }
  expect_refused(run({"convert", picture, "-o", in_folder("t.hpp"), "--format", "rgb888"}), 2, before);
  expect_refused(run({"convert", picture, "-o", in_folder("t.hpp"), "--textured"}), 2, before);
  expect_refused(run({"convert", model, "-o", in_folder("t.hpp"), "--mipmap"}), 2, before);
  expect_refused(run({"convert", model, "-o", in_folder("t.hpp"), "--textured"}), 1, before);
  EXPECT_EQ(run({"convert", picture, "-o", in_folder("t.hpp"), "--resize"}).exit_code, 0);
}

TEST_F(ConvertTest, DisplacementIsMadeOrRefusedByName) {
  const std::string model = make_file("a.obj", textured_square()), bare = make_file("b.obj", cube_obj());
  const std::string heights = make_file("h.png", png_bytes(numbered_picture(16, 8)));
  const std::string odd = make_file("odd.png", png_bytes(numbered_picture(12, 8)));
  const auto convert = [&](const std::string& from, std::vector<std::string> options) {
    options.insert(options.begin(), {"convert", from, "-o", in_folder("mesh.hpp")});
    return run(options);
  };
  const ToolRun made = convert(model, {"--displace", heights, "--amount", "0.5", "--subdivide", "2"});
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  // A square's 2 triangles become 32, of 3 indices in 2 bytes each.
  EXPECT_NE(made.output.find(" 192 bytes"), std::string::npos) << made.output;
  std::filesystem::remove(in_folder("mesh.hpp"));
  const auto before = files();
  const auto refused = [&](const ToolRun& result, const std::string& what) {
    expect_refused(result, 1, before);
    EXPECT_NE(result.errors.find(what), std::string::npos) << result.errors;
  };
  refused(convert(bare, {"--displace", heights, "--amount", "1"}), "b.obj: has no texture coordinates");
  refused(convert(model, {"--displace", odd, "--amount", "1"}), "odd.png: is 12x8");
  refused(convert(model, {"--displace", in_folder("none.png"), "--amount", "1"}), "none.png");
  refused(convert(model, {"--displace", heights, "--amount", "1", "--subdivide", "8"}), "at most 65535");
  expect_refused(convert(model, {"--displace", heights}), 2, before);
  expect_refused(convert(model, {"--amount", "1"}), 2, before);
  expect_refused(convert(model, {"--displace", heights, "--amount", "far"}), 2, before);
  expect_refused(convert(model, {"--displace", heights, "--amount", "1", "--subdivide", "9"}), 2, before);
  expect_refused(convert(heights, {"--displace", heights, "--amount", "1"}), 2, before);
}

TEST_F(ConvertTest, PrintsFlashAndRam) {
  const ToolRun result = run({"convert", make_file("a.obj", cube_obj()), "-o", in_folder("a.hpp")});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  std::istringstream lines(result.output);
  std::map<std::string, std::size_t> sums, totals;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string memory, unit;
    words >> memory;
    const std::size_t end = line.rfind(" bytes"), start = line.rfind(' ', end - 1);
    const std::size_t bytes = std::stoul(line.substr(start, end - start));
    (line.find("total") == std::string::npos ? sums : totals)[memory] += bytes;
  }
  EXPECT_EQ(sums, totals);
  EXPECT_EQ(totals.size(), 2U);
}

TEST_F(ConvertTest, SameModelSameBytes) {
  const std::string model = make_file("a.obj", cube_obj());
  EXPECT_EQ(run({"convert", model, "-o", in_folder("a.hpp"), "--name", "m"}).exit_code, 0);
  EXPECT_EQ(run({"convert", model, "-o", in_folder("b.hpp"), "--name", "m"}).exit_code, 0);
  EXPECT_EQ(read_text(in_folder("a.hpp")), read_text(in_folder("b.hpp")));
}

}  // namespace
}  // namespace spanline::sim::test
