// Textures that a model names or holds, and what their alpha does, by the real command.
#include <cmath>
#include <string>
#include <vector>

#include "image_bytes.hpp"
#include "import/model_file.hpp"
#include "model_files.hpp"
#include "spanline/visibility/registry.hpp"
#include "tool.hpp"

namespace spanline::sim::test {
namespace {

constexpr Rgb888 red{255, 0, 0}, green{0, 255, 0}, blue{0, 0, 255}, white{255, 255, 255}, grey{128, 128, 128};

/// A quarter each, from the top left.
std::string quarters(const std::vector<Rgba8888>& colours, int size = 8) {
  ImageRgba image{size, size, {}};
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      image.pixels.push_back(colours[static_cast<std::size_t>(2 * y / size * 2 + 2 * x / size)]);
  const std::vector<std::byte> bytes = png_with_alpha(image);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
const std::vector<Rgba8888> four_colours{{red}, {green}, {blue}, {white}};

class ModelTexturesTest : public ToolTest {
 protected:
  /// The square from (−1,−1) to (1,1), fully lit, over grey; or one that lies further to the right.
  [[nodiscard]] ToolRun draw(const std::string& model, const std::vector<std::string>& more = {},
                             const std::string& right = "0") const {
    std::vector<std::string> arguments{
        "render", model,          "-o",       in_folder("out.png"), "--ortho",   "2", "--size",       "32x32",
        "--eye",  right + ",0,3", "--target", right + ",0,0",       "--ambient", "1", "--background", "808080"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  /// Pixels in the middle of each quarter.
  [[nodiscard]] std::vector<Rgb888> drawn(const std::string& model, const std::vector<std::string>& more = {}) const {
    const ToolRun result = draw(model, more);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    const Picture picture = read_png(in_folder("out.png"));
    return {picture.at(8, 8), picture.at(24, 8), picture.at(8, 24), picture.at(24, 24)};
  }
  /// A square with a material of these lines.
  [[nodiscard]] std::string square(const std::string& material) const {
    make_file("m.mtl", "newmtl a\nKd 1 1 1\n" + material);
    return make_file("a.obj", "mtllib m.mtl\nusemtl a\n" + textured_square());
  }
  /// A colour over the grey background.
  static Rgb888 over(Rgb888 c, double alpha) {
    const auto channel = [&](int a) { return static_cast<std::uint8_t>(a * alpha + 128 * (1 - alpha)); };
    return {channel(c.red), channel(c.green), channel(c.blue)};
  }
  /// RGB565 and 32nds of opacity are coarse: 4 of 255 each, and twice that for products of two opacities.
  static void expect_near(const std::vector<Rgb888>& got, const std::vector<Rgb888>& wanted) {
    for (std::size_t i = 0; i < wanted.size(); ++i)
      EXPECT_LE(greatest_difference(got[i], wanted[i]), 12) << "quarter " << i;
  }
  /// As a glTF's image.
  static std::string data_uri(const std::string& bytes) { return "data:image/png;base64," + base64(bytes); }
};

TEST_F(ModelTexturesTest, ObjPartsWearTheirMaterialsImagesTimesTheirColours) {
  make_file("a b.png", quarters(four_colours));
  make_file("m.mtl", "newmtl left\nKd 1 1 1\nmap_Kd a b.png\nnewmtl right\nKd 1 0.5 0\n");
  const std::string model =
      make_file("a.obj",
                "mtllib m.mtl\nv -1 -1 0\nv 0 -1 0\nv 0 1 0\nv -1 1 0\nv 1 -1 0\nv 1 1 0\nvt 0 0\nvt 0.5 0\n"
                "vt 0.5 1\nvt 0 1\nusemtl left\nf 1/1 2/2 3/3 4/4\nusemtl right\nf 2 5 6 3\n");
  for (const AlgorithmEntry& algorithm : algorithm_registry)
    expect_near(drawn(model, {"--visibility", algorithm.name}), {red, {255, 128, 0}, blue, {255, 128, 0}});
}

TEST_F(ModelTexturesTest, TheLargestTextureShowsAllItsRowsOnceAndRepeated) {
  make_file("large.png", quarters(four_colours, 1024));
  expect_near(drawn(square("map_Kd large.png\n")), {red, green, blue, white});
  // Sixteen times each way on 32 pixels: every quarter is one pixel.
  make_file("small.png", quarters(four_colours, 256));
  make_file("m.mtl", "newmtl a\nKd 1 1 1\nmap_Kd small.png\n");
  const std::string repeated = make_file("a.obj",
                                         "mtllib m.mtl\nusemtl a\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\n"
                                         "vt 16 0\nvt 16 16\nvt 0 16\nf 1/1 2/2 3/3 4/4\n");
  ASSERT_EQ(draw(repeated).exit_code, 0);
  const Picture picture = read_png(in_folder("out.png"));
  for (int y = 0; y < 32; y += 2)
    for (int x = 0; x < 32; x += 2)
      expect_near({picture.at(x, y), picture.at(x + 1, y), picture.at(x, y + 1), picture.at(x + 1, y + 1)},
                  {red, green, blue, white});
}

TEST_F(ModelTexturesTest, GltfImagesLieBesideItOrInsideAndTakeItsSampler) {
  make_file("my image.png", quarters(four_colours));
  for (const std::string& uri : {std::string("my%20image.png"), data_uri(quarters(four_colours))}) {
    const std::string model = make_file("a.gltf", textured_gltf(uri));
    expect_near(drawn(model), {red, green, blue, white});
    expect_near(drawn(model, {"--visibility", "span"}), {red, green, blue, white});
    expect_near(drawn(model, {"--filter", "bilinear", "--mipmap"}), {red, green, blue, white});
  }
  // Beyond the edge the texture begins again, or its edge goes on.
  const auto at_right = [&](const std::string& sampler) {
    const std::string model = make_file("a.gltf", textured_gltf("my%20image.png", "}", sampler));
    EXPECT_EQ(draw(model, {}, "1").exit_code, 0);
    return read_png(in_folder("out.png")).at(18, 20);
  };
  EXPECT_LE(greatest_difference(at_right("{}"), blue), 8);
  EXPECT_LE(greatest_difference(at_right(R"({"wrapS": 33071, "wrapT": 33071})"), white), 8);
}

TEST_F(ModelTexturesTest, AlphaModesSayWhatAlphaOfTexelsDoes) {
  const std::string uri = data_uri(quarters({{red, 255}, {green, 153}, {blue, 85}, {white, 0}}));
  for (const char* visibility : {"zbuffer", "span"}) {
    const auto mode = [&](const std::string& material, const std::string& factor = "") {
      return drawn(make_file("a.gltf", textured_gltf(uri, factor + "}" + material)), {"--visibility", visibility});
    };
    expect_near(mode(""), {red, green, blue, white});
    expect_near(mode(R"(, "alphaMode": "MASK")"), {red, green, grey, grey});
    expect_near(mode(R"(, "alphaMode": "MASK", "alphaCutoff": 0.2)"), {red, green, blue, grey});
    expect_near(mode(R"(, "alphaMode": "MASK")", R"(, "baseColorFactor": [1, 1, 1, 0.7])"), {red, grey, grey, grey});
    expect_near(mode(R"(, "alphaMode": "BLEND")"), {red, over(green, 0.6), over(blue, 1 / 3.0), grey});
    expect_near(mode(R"(, "alphaMode": "BLEND")", R"(, "baseColorFactor": [1, 1, 1, 0.5])"),
                {over(red, 0.5), over(green, 0.3), over(blue, 1 / 6.0), grey});
  }
}

TEST_F(ModelTexturesTest, OpacitiesOfMtlAreAnImagesAlphaOrItsBrightness) {
  make_file("colours.png", quarters(four_colours));
  const auto level = [](std::uint8_t value) { return Rgba8888{{value, value, value}}; };
  // Luma of (0, 255, 22) is 0.587 · 255 + 0.114 · 22 = 152, which is 0.6.
  make_file("bright.png", quarters({level(255), {{0, 255, 22}}, level(85), level(0)}));
  make_file("alpha.png", quarters({{red, 255}, {red, 153}, {blue, 85}, {white, 0}}));
  make_file("small.png", quarters({level(255), level(153), level(85), level(0)}, 2));
  make_file("large.png", quarters({level(255), level(153), level(85), level(0)}, 24));
  for (const std::string name : {"bright.png", "alpha.png", "small.png", "large.png"}) {
    SCOPED_TRACE(name);
    for (const std::string visibility : {"zbuffer", "span"})
      expect_near(drawn(square("map_Kd colours.png\nmap_d " + name + "\n"), {"--visibility", visibility}),
                  {red, over(green, 0.6), over(blue, 1 / 3.0), grey});
  }
  expect_near(drawn(square("d 0.5\nmap_Kd colours.png\nmap_d alpha.png\n")),
              {over(red, 0.5), over(green, 0.3), over(blue, 1 / 6.0), grey});
  // Without colours, it is the material's.
  expect_near(drawn(square("Kd 1 0 1\nmap_d alpha.png\n")),
              {{255, 0, 255}, over({255, 0, 255}, 0.6), over({255, 0, 255}, 1 / 3.0), grey});
  // Colours' own alpha gives way to it.
  make_file("half.png", quarters({{red, 128}, {green, 128}, {blue, 128}, {white, 128}}));
  make_file("mask.png", quarters({level(255), level(0), level(0), level(255)}));
  expect_near(drawn(square("map_Kd half.png\nmap_d mask.png\n")), {red, grey, grey, white});
  // What is there or not is cut out: no layers, and words of 16 bits in flash.
  EXPECT_EQ(run({"convert", in_folder("a.obj"), "-o", in_folder("a.hpp"), "--materials"}).exit_code, 0);
  EXPECT_NE(read_text(in_folder("a.hpp")).find("TexelFormat::rgb565_cutout"), std::string::npos);
}

TEST_F(ModelTexturesTest, OpacitiesThatCannotBeAreRefusedByName) {
  const std::string odd = quarters(four_colours, 12);
  make_file("colours.png", quarters(four_colours));
  make_file("odd.png", odd);
  make_file("cut.png", odd.substr(0, odd.size() / 2));
  const auto expect_named = [&](const std::string& material, const std::string& name) {
    const std::string model = square(material);
    const auto before = files();
    for (const ToolRun& result : {draw(model), run({"convert", model, "-o", in_folder("a.hpp"), "--materials"})}) {
      expect_refused(result, 1, before);
      EXPECT_NE(result.errors.find(in_folder(name)), std::string::npos) << result.errors;
    }
  };
  for (const std::string name : {"missing.png", "cut.png"}) {
    expect_named("map_Kd colours.png\nmap_d " + name + "\n", name);
    expect_named("map_d " + name + "\n", name);
  }
  expect_named("map_d odd.png\n", "odd.png");
  expect_named("map_Kd odd.png\nmap_d colours.png\n", "odd.png");
}

/// A model of textured_gltf with KHR_texture_transform, whose JSON is `transform`.
std::string transformed_gltf(const std::string& uri, const std::string& transform) {
  std::string text = textured_gltf(uri);
  const std::string reference = R"({"index": 0})";
  text.replace(text.find(reference), reference.size(),
               R"({"index": 0, "extensions": {"KHR_texture_transform": )" + transform + "}}");
  return text.insert(1, R"("extensionsUsed": ["KHR_texture_transform"], )");
}

TEST_F(ModelTexturesTest, TransformsOfGltfMoveTurnAndScaleCoordinates) {
  const auto points = [&](const std::string& transform) {
    return import_model(make_file("a.gltf", transformed_gltf("x.png", transform))).texture_points;
  };
  const auto expect_points = [](const std::vector<TexturePoint>& got, const std::vector<TexturePoint>& wanted) {
    ASSERT_EQ(got.size(), wanted.size());
    for (std::size_t i = 0; i < got.size(); ++i) {
      EXPECT_NEAR(got[i].s, wanted[i].s, 1e-5) << i;
      EXPECT_NEAR(got[i].t, wanted[i].t, 1e-5) << i;
    }
  };
  const std::vector<TexturePoint> plain{{0, 1}, {2, 1}, {0, -1}};
  expect_points(points("{}"), plain);
  expect_points(points(R"({"offset": [0.25, 0.125]})"), {{0.25, 1.125}, {2.25, 1.125}, {0.25, -0.875}});
  expect_points(points(R"({"scale": [2, -3]})"), {{0, -3}, {4, -3}, {0, 3}});
  // The extension's first example: the lower left quadrant, (s, t) goes to (t/2, 1 − s/2).
  expect_points(points(R"({"offset": [0, 1], "rotation": 1.57079632679, "scale": [0.5, 0.5]})"),
                {{0.5, 1}, {0.5, 0}, {-0.5, 1}});
  // All of it: matrices one after the other.
  std::vector<TexturePoint> wanted;
  for (const TexturePoint p : plain) {
    const double s = 2 * p.s, t = 0.75 * p.t, angle = 0.4;
    wanted.push_back({s * std::cos(angle) + t * std::sin(angle) - 0.3, -s * std::sin(angle) + t * std::cos(angle) + 5});
  }
  expect_points(points(R"({"offset": [-0.3, 5], "rotation": 0.4, "scale": [2, 0.75]})"), wanted);
}

TEST_F(ModelTexturesTest, TransformsOfGltfAreDrawn) {
  const std::string uri = data_uri(quarters(four_colours));
  const auto shown = [&](const std::string& transform) {
    return drawn(make_file("a.gltf", transformed_gltf(uri, transform)));
  };
  expect_near(shown(R"({"offset": [0.5, 0]})"), {green, red, white, blue});
  expect_near(shown(R"({"offset": [0, 1], "rotation": 1.57079632679, "scale": [0.5, 0.5]})"), {blue, blue, blue, blue});
  // A quarter of a turn: the image clockwise.
  expect_near(shown(R"({"offset": [0, 1], "rotation": 1.57079632679})"), {blue, red, white, green});
  const std::string model = make_file("a.gltf", transformed_gltf(uri, R"({"offset": [1e39, 0]})"));
  const auto before = files();
  expect_refused(draw(model), 1, before);
}

/// Of glTF's samplers: mirrored along these axes.
std::string mirrored_gltf(const std::string& uri, const std::string& transform, bool s, bool t) {
  std::string text = transformed_gltf(uri, transform);
  const std::string sampler = R"("samplers": [{}])";
  const auto mode = [](bool mirrored) { return std::to_string(mirrored ? 33648 : 10497); };
  return text.replace(text.find(sampler), sampler.size(),
                      R"("samplers": [{"wrapS": )" + mode(s) + R"(, "wrapT": )" + mode(t) + "}]");
}

TEST_F(ModelTexturesTest, MirroredRepeatTurnsEveryOtherImage) {
  const std::string uri = data_uri(quarters(four_colours));
  /// Eighths of the upper line of the picture, or of its left column.
  const auto expect_line = [&](const std::string& model, bool down, const std::vector<Rgb888>& wanted,
                               const std::vector<std::string>& more = {}) {
    const ToolRun result = draw(model, more);
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    const Picture picture = read_png(in_folder("out.png"));
    std::vector<Rgb888> got;
    for (int i = 4; i < 32; i += 8) got.push_back(down ? picture.at(4, i) : picture.at(i, 4));
    expect_near(got, wanted);
  };
  const std::string twice = make_file("a.gltf", mirrored_gltf(uri, R"({"scale": [2, 1]})", true, false));
  for (const std::string visibility : {"zbuffer", "span"})
    expect_line(twice, false, {red, green, green, red}, {"--visibility", visibility});
  expect_line(twice, false, {red, green, green, red}, {"--filter", "bilinear", "--mipmap"});
  expect_line(twice, false, {red, green, red, green}, {"--wrap", "repeat"});
  expect_line(twice, false, {red, green, green, green}, {"--wrap", "clamp"});
  const auto line = [&](const std::string& transform, bool s, bool t, bool down, const std::vector<Rgb888>& wanted) {
    expect_line(make_file("b.gltf", mirrored_gltf(uri, transform, s, t)), down, wanted);
  };
  line(R"({"scale": [2, 1], "offset": [-1, 0]})", true, true, false, {green, red, red, green});
  line(R"({"scale": [2, 1]})", false, true, false, {red, green, red, green});
  line(R"({"scale": [1, 2]})", true, true, true, {red, blue, blue, red});
  line(R"({"scale": [1, 2], "offset": [0.75, 4]})", false, true, true, {green, white, white, green});
  // In flash the texture is twice as wide, and coordinates half as large; without textures they stay.
  EXPECT_EQ(run({"convert", twice, "-o", in_folder("a.hpp"), "--materials"}).exit_code, 0);
  const std::string header = read_text(in_folder("a.hpp"));
  EXPECT_NE(header.find(".log2_width = 4,\n    .log2_height = 3,"), std::string::npos) << header;
  EXPECT_EQ(import_model(twice).texture_points.at(1).s, 4);
  EXPECT_NE(header.find("{0, 8192}, {16384, 8192}, {0, -8192},"), std::string::npos) << header;
}

TEST_F(ModelTexturesTest, MirroredRepeatIsRefusedByNameWhereItTakesTooLargeATexture) {
  ImageRgba wide{2048, 1, {}};
  for (int x = 0; x < wide.width; ++x) wide.pixels.push_back({x < 1024 ? red : green});
  const std::vector<std::byte> bytes = png_with_alpha(wide);
  make_file("wide.png", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  const std::string once = make_file("a.gltf", mirrored_gltf("wide.png", "{}", false, true));
  expect_near(drawn(once), {red, green, red, green});
  const std::string model = make_file("b.gltf", mirrored_gltf("wide.png", R"({"scale": [2, 1]})", true, false));
  const auto before = files();
  for (const ToolRun& result : {draw(model, {"--stats", in_folder("s.json")}),
                                run({"convert", model, "-o", in_folder("a.hpp"), "--materials"})}) {
    expect_refused(result, 1, before);
    EXPECT_NE(result.errors.find(in_folder("wide.png") + ": with its mirror image is 4096x1;"), std::string::npos)
        << result.errors;
  }
  expect_refused(draw(model, {"--bump", in_folder("wide.png")}), 2, before);
  EXPECT_EQ(draw(model, {"--resize"}).exit_code, 0);
  const Picture picture = read_png(in_folder("out.png"));
  expect_near({picture.at(4, 4), picture.at(12, 4), picture.at(20, 4), picture.at(28, 4)}, {red, green, green, red});
}

TEST_F(ModelTexturesTest, ImagesThatCannotBeAreRefusedByNameUnlessNobodyAsksForThem) {
  const std::string odd = quarters(four_colours, 12);
  make_file("odd.png", odd);
  make_file("cut.png", odd.substr(0, odd.size() / 2));
  const std::string model = in_folder("a.gltf"), embedded = in_folder("b.gltf");
  make_file("b.gltf", textured_gltf(data_uri(odd)));
  for (const std::string name : {"missing.png", "odd.png", "cut.png"}) {
    make_file("a.gltf", textured_gltf(name));
    const auto before = files();
    const ToolRun result = draw(model);
    expect_refused(result, 1, before);
    EXPECT_NE(result.errors.find(in_folder(name)), std::string::npos) << result.errors;
    expect_refused(run({"convert", model, "-o", in_folder("a.hpp"), "--materials"}), 1, before);
  }
  const auto before = files();
  const ToolRun inside = draw(embedded);
  expect_refused(inside, 1, before);
  EXPECT_NE(inside.errors.find("b.gltf: the texture inside it is 12x12"), std::string::npos) << inside.errors;
  expect_near(drawn(embedded, {"--resize"}), {red, green, blue, white});
  make_file("a.gltf", textured_gltf("missing.png"));
  EXPECT_EQ(draw(model, {"--shade", "flat"}).exit_code, 0);
}

}  // namespace
}  // namespace spanline::sim::test
