#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <tuple>

#include "image/png.hpp"
#include "model_files.hpp"
#include "spanline/visibility/registry.hpp"
#include "tool.hpp"

namespace spanline::sim::test {
namespace {

class RenderTest : public ToolTest {
 protected:
  /// Renders and expects success; `options` are added.
  Picture render(const std::string& model, std::vector<std::string> options,
                 const std::string& name = "out.png") const {
    std::vector<std::string> arguments{"render", model, "-o", in_folder(name)};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ToolRun result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_EQ(result.errors, "");
    return read_png(in_folder(name));
  }

  /// Red glass before a blue wall, both over the whole picture's middle.
  [[nodiscard]] std::string panes_obj(const std::string& opacity) const {
    make_file("panes.mtl", "newmtl glass\nKd 1 0 0\nd " + opacity + "\nnewmtl wall\nKd 0 0 1\n");
    return make_file("panes.obj",
                     "mtllib panes.mtl\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\n"
                     "v -1 1 0\nusemtl glass\nf 1 2 3 4\nusemtl wall\nf 5 6 7 8\n");
  }
};

/// Straight at the cube's front, with the picture's middle inside it.
const std::vector<std::string> front{"--eye", "0,0,4",  "--target", "0,0,0", "--size",
                                     "64x48", "--near", "1",        "--far", "9"};

std::vector<std::string> with(std::vector<std::string> options, const std::vector<std::string>& more) {
  options.insert(options.end(), more.begin(), more.end());
  return options;
}

TEST_F(RenderTest, DefaultsFrameTheModel) {
  const Picture picture = render(make_file("a.obj", cube_obj()), {});
  EXPECT_EQ(picture.width, 320);
  EXPECT_EQ(picture.height, 240);
  EXPECT_EQ(picture.at(0, 0), (Rgb888{0, 0, 0}));
  EXPECT_GT(picture.at(160, 120).red, 40);
}

TEST_F(RenderTest, IdsCountTrianglesOfFansInFileOrder) {
  const std::string model = make_file("a.obj", cube_obj());
  render(model, with(front, {"--ids-out", in_folder("ids.png")}));
  const Picture ids = read_png(in_folder("ids.png"));
  EXPECT_EQ(number_of(ids.at(0, 0)), 0U);
  // The first face is 5 6 7 8: its fan splits it from the lower left to the upper right.
  EXPECT_EQ(number_of(ids.at(36, 28)), 1U);
  EXPECT_EQ(number_of(ids.at(28, 20)), 2U);
  std::set<std::uint32_t> seen;
  for (const Rgb888 pixel : ids.pixels) seen.insert(number_of(pixel));
  EXPECT_EQ(seen, (std::set<std::uint32_t>{0, 1, 2}));
}

TEST_F(RenderTest, ATextureLiesUprightOnTheModel) {
  const std::string model = make_file("a.obj", textured_square());
  const std::string texture = make_file("t.png", png_bytes(numbered_picture(16, 32)));
  for (const AlgorithmEntry& algorithm : algorithm_registry) {
    const Picture picture = render(model, {"--ortho", "2", "--size", "64x64", "--texture", texture, "--ambient", "1",
                                           "--eye", "0,0,3", "--target", "0,0,0", "--visibility", algorithm.name});
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        ASSERT_LE(greatest_difference(picture.at(x, y), {static_cast<std::uint8_t>(x / 4 * 8),
                                                         static_cast<std::uint8_t>(y / 2 * 8), 255}),
                  8)
            << algorithm.name << " " << x << ", " << y;
      }
  }
}

TEST_F(RenderTest, FogIsAsThickAsItsDistancesSayWhereverThePlanesLie) {
  const std::string model = make_file("a.obj", textured_square());
  for (const std::vector<std::string>& projection : {std::vector<std::string>{"--fov", "30"}, {"--ortho", "2"}})
    for (const std::vector<std::string>& planes :
         {std::vector<std::string>{}, {"--near", "1", "--far", "9"}, {"--near", "1e-6", "--far", "1e9"}})
      for (const double end : {3.0, 4.0, 6.0, 30.0, 300.0, 1000.0, 1e5, 1e9}) {
        SCOPED_TRACE(end);
        const Picture picture =
            render(model, with(with(projection, planes),
                               {"--eye", "0,0,3", "--target", "0,0,0", "--size", "16x16", "--shade", "unlit", "--depth",
                                "24", "--fog", "0," + std::to_string(end) + ",FF0000"}));
        // White, three units away.
        const int left = static_cast<int>(std::lround(255 * (1 - 3 / end)));
        EXPECT_NEAR(picture.at(8, 8).blue, left, 9);
        EXPECT_EQ(picture.at(8, 8).red, 255);
      }
}

TEST_F(RenderTest, WithoutLightATextureIsShownAsItIs) {
  const std::string model = make_file("a.obj", textured_square());
  const std::string texture = make_file("t.png", png_bytes(numbered_picture(16, 32)));
  const std::vector<std::string> dark{"--ortho",       "2",        "--size",     "64x64",     "--eye",
                                      "0,0,3",         "--target", "0,0,0",      "--light",   "0,0,-1",
                                      "--point-light", "0,0,-2",   "--specular", "1",         "--ambient",
                                      "0.1",           "--shade",  "unlit",      "--texture", texture};
  for (const AlgorithmEntry& algorithm : algorithm_registry) {
    const Picture picture = render(model, with(dark, {"--visibility", algorithm.name}));
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x)
        ASSERT_LE(greatest_difference(picture.at(x, y), {static_cast<std::uint8_t>(x / 4 * 8),
                                                         static_cast<std::uint8_t>(y / 2 * 8), 255}),
                  8)
            << algorithm.name << " " << x << ", " << y;
  }
  const Picture plain = render(model, dark);
  EXPECT_NE(render(model, with(dark, {"--filter", "bilinear"})), plain);
}

TEST_F(RenderTest, WithoutLightAModelKeepsItsOwnTextureAndColour) {
  make_file("t.png", png_bytes(numbered_picture(8, 8)));
  make_file("a.mtl", "newmtl a\nKd 1 0.5 1\nmap_Kd t.png\n");
  const std::string model = make_file("a.obj", "mtllib a.mtl\nusemtl a\n" + textured_square());
  const std::vector<std::string> view{"--ortho", "2", "--size", "64x64", "--eye", "0,0,3", "--target", "0,0,0"};
  const Picture unlit = render(model, with(view, {"--shade", "unlit", "--light", "0,0,-1", "--ambient", "0"}));
  EXPECT_EQ(unlit, render(model, with(view, {"--shade", "texture", "--ambient", "1"})));
  const Rgb888 texel = unlit.at(60, 60);
  EXPECT_NEAR(texel.red, 7 * 8, 8);
  EXPECT_NEAR(texel.green, 7 * 4, 8);
  // Two texels a pixel: levels hold their means.
  const std::vector<std::string> far_off{"--ortho", "32", "--size", "64x64", "--eye", "0,0,3", "--target", "0,0,0"};
  EXPECT_NE(render(model, with(far_off, {"--shade", "unlit", "--mipmap"})),
            render(model, with(far_off, {"--shade", "unlit"})));
}

TEST_F(RenderTest, OptionsOfTexturesWithoutOneAreRefusedWithoutLightToo) {
  const std::string model = make_file("a.obj", cube_obj()), square = make_file("b.obj", textured_square());
  const std::string texture = make_file("t.png", png_bytes(numbered_picture(8, 8)));
  const auto before = files();
  expect_refused(run({"render", model, "-o", in_folder("o.png"), "--shade", "unlit", "--filter", "bilinear"}), 2,
                 before);
  expect_refused(run({"render", square, "-o", in_folder("o.png"), "--shade", "unlit", "--mipmap"}), 2, before);
  // A shading by light alone would leave the texture out in silence.
  for (const std::string shade : {"flat", "gouraud"}) {
    const ToolRun result = run({"render", square, "-o", in_folder("o.png"), "--shade", shade, "--texture", texture});
    expect_refused(result, 2, before);
    EXPECT_NE(result.errors.find("--texture"), std::string::npos) << result.errors;
  }
}

TEST_F(RenderTest, TexturesThatCannotBeAreRefusedByName) {
  const std::string model = make_file("a.obj", textured_square()), bare = make_file("b.obj", cube_obj());
  const std::string good = make_file("good.png", png_bytes(numbered_picture(8, 8)));
  const std::string bytes = png_bytes(numbered_picture(8, 8));
  const std::vector<std::pair<std::string, std::string>> bad{{"odd.png", png_bytes(numbered_picture(12, 8))},
                                                             {"large.png", png_bytes(Picture(4096, 1))},
                                                             {"cut.png", bytes.substr(0, bytes.size() / 2)},
                                                             {"empty.png", ""},
                                                             {"text.png", "this is no picture"},
                                                             {"jpeg.png", "\xff\xd8\xff\xe0 and more"}};
  std::vector<std::string> paths{in_folder("missing.png"), in_folder("")};
  for (const auto& [name, content] : bad) paths.push_back(make_file(name, content));
  const auto before = files();
  for (const std::string& path : paths) {
    const ToolRun result = run({"render", model, "-o", in_folder("out.png"), "--texture", path});
    expect_refused(result, 1, before);
    EXPECT_NE(result.errors.find(path), std::string::npos) << result.errors;
  }
  const ToolRun without = run({"render", bare, "-o", in_folder("out.png"), "--texture", good});
  expect_refused(without, 1, before);
  EXPECT_NE(without.errors.find("b.obj: has no texture coordinates"), std::string::npos) << without.errors;
  expect_refused(run({"render", model, "-o", in_folder("out.png"), "--shade", "texture"}), 2, before);
}

TEST_F(RenderTest, FiltersLevelsFogAndDitherReachThePicture) {
  const std::string model = make_file("a.obj", textured_square());
  const std::string texture = make_file("t.png", png_bytes(numbered_picture(32, 32)));
  const auto draw = [&](std::vector<std::string> more, const std::string& size = "48x48") {
    std::vector<std::string> arguments{"--ortho", "2",     "--size",   size,    "--ambient",    "1",
                                       "--eye",   "0,0,3", "--target", "0,0,0", "--visibility", "span"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return render(model, arguments);
  };
  const Picture plain = draw({"--texture", texture});
  EXPECT_NE(draw({"--texture", texture, "--filter", "bilinear"}), plain);
  // Two thirds of a texel a pixel: level 0 all over.
  EXPECT_EQ(draw({"--texture", texture, "--mipmap"}), plain);
  EXPECT_NE(draw({"--texture", texture, "--mipmap"}, "16x16"), draw({"--texture", texture}, "16x16"));
  EXPECT_EQ(draw({"--texture", texture, "--wrap", "clamp"}), plain);
  // The square is 3 units away; half of the fog's way is half of the fog.
  for (const char* from : {"2,4,FF0000", "0,6,FF0000"})
    EXPECT_LE(greatest_difference(draw({"--fog", from, "--shade", "unlit"}).at(24, 24), {255, 128, 128}), 10);
  EXPECT_EQ(draw({"--fog", "4,5,FF0000", "--shade", "unlit"}), draw({"--shade", "unlit"}));
  EXPECT_NE(draw({"--dither", "--texture", texture, "--light", "1,1,1"}),
            draw({"--texture", texture, "--light", "1,1,1"}));
  // The numbers of its pixels are steep heights; as a texture they lie under their own relief.
  const auto lit = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"--ambient", "0.2", "--light", "1,0,1"});
    return render(model, more);
  };
  EXPECT_NE(lit({"--bump", texture}), lit({}));
  EXPECT_NE(lit({"--bump", texture}), lit({"--bump", texture, "--bump-depth", "20"}));
  EXPECT_NE(lit({"--emboss", texture, "--texture", texture}), lit({"--texture", texture}));
  // Cubes of an eighth of the square's side: one field to the right, the other colour.
  const Picture solid = draw({"--solid", "checks"});
  EXPECT_LE(greatest_difference(solid.at(19, 19), {245, 240, 230}), 8);
  EXPECT_EQ(solid.at(13, 19), solid.at(19, 13));
  EXPECT_NE(solid.at(13, 19), solid.at(19, 19));
  // A mirror that faces the eye shows what is behind the eye: the middle of the sphere's picture.
  EXPECT_LE(greatest_difference(draw({"--environment", texture}).at(24, 24), numbered_picture(32, 32).at(16, 16)), 8);
  const auto before = files();
  for (const std::vector<std::string>& wrong :
       std::vector<std::vector<std::string>>{{"--filter", "bilinear"},
                                             {"--environment", texture, "--texture", texture},
                                             {"--bump", texture, "--emboss", texture},
                                             {"--bump-depth", "2"},
                                             {"--solid", "cheese"},
                                             {"--solid", "wood", "--texture", texture},
                                             {"--bump", texture, "--bump-depth", "65"},
                                             {"--mipmap"},
                                             {"--texture", texture, "--wrap", "mirror"},
                                             {"--fog", "1,2"},
                                             {"--fog", "2,1,000000"},
                                             {"--fog", "-1,1,000000"}}) {
    std::vector<std::string> arguments{"render", model, "-o", in_folder("o.png")};
    arguments.insert(arguments.end(), wrong.begin(), wrong.end());
    expect_refused(run(arguments), 2, before);
  }
}

TEST_F(RenderTest, CullingChoosesFaces) {
  const std::string model = make_file("a.obj", cube_obj());
  const auto seen = [&](const std::string& cull) {
    render(model, with(front, {"--cull", cull, "--ids-out", in_folder("ids.png")}));
    std::set<std::uint32_t> ids;
    for (const Rgb888 pixel : read_png(in_folder("ids.png")).pixels) ids.insert(number_of(pixel));
    ids.erase(0);
    return ids;
  };
  EXPECT_EQ(seen("back"), (std::set<std::uint32_t>{1, 2}));
  EXPECT_EQ(seen("none"), (std::set<std::uint32_t>{1, 2}));
  for (const std::uint32_t id : seen("front")) EXPECT_GT(id, 2U);
}

TEST_F(RenderTest, DepthFollowsItsFormula) {
  const std::string model = make_file("a.obj", cube_obj());
  // The front face is 3 from the eye: a + b/z with near 1 and far 9.
  const double want = 9.0 / 8 - 9.0 / 8 / 3;
  for (const int bits : {16, 24}) {
    const double greatest = std::ldexp(1, bits) - 1;
    const std::uint32_t background = (1U << bits) - 1;
    std::vector<Picture> senses;
    for (const std::string sense : {"smaller", "larger"}) {
      render(model, with(front, {"--depth", std::to_string(bits), "--depth-sense", sense, "--depth-out",
                                 in_folder("depth.png")}));
      senses.push_back(read_png(in_folder("depth.png")));
      EXPECT_EQ(number_of(senses.back().at(0, 0)), background);
    }
    EXPECT_NEAR(number_of(senses[0].at(32, 24)), want * greatest, bits == 16 ? 1 : 3);
    EXPECT_NEAR(number_of(senses[1].at(32, 24)), greatest - want * greatest, bits == 16 ? 1 : 3);
  }
}

TEST_F(RenderTest, EveryBandHeightAndAlgorithmDrawsTheSame) {
  const std::string model = make_file("a.obj", cube_obj());
  const Picture whole = render(model, {"--visibility", "zbuffer", "--size", "100x75"});
  for (const std::string band : {"1", "2", "7", "16", "75", "2047"})
    EXPECT_EQ(render(model, {"--visibility", "scanline-z", "--band", band, "--size", "100x75"}), whole) << band;
  EXPECT_EQ(render(model, {"--depth-sense", "larger", "--size", "100x75"}), whole);
}

TEST_F(RenderTest, LightAndColours) {
  const std::string model =
      make_file("a.obj", "v -1 -1 0 1 0 0\nv 1 -1 0 1 0 0\nv 1 1 0 1 0 0\nv -1 1 0 1 0 0\nf 1 2 3 4\n");
  const auto centre = [&](std::vector<std::string> options) { return render(model, with(front, options)).at(32, 24); };
  EXPECT_EQ(centre({"--shade", "unlit"}), (Rgb888{255, 0, 0}));
  EXPECT_EQ(centre({"--shade", "flat", "--light", "0,0,1", "--ambient", "0"}), (Rgb888{255, 0, 0}));
  EXPECT_EQ(centre({"--shade", "flat", "--light", "0,0,-1", "--ambient", "0"}), (Rgb888{0, 0, 0}));
  // RGB565 keeps five bits of red.
  EXPECT_LE(greatest_difference(centre({"--shade", "flat", "--light", "0,0,-1", "--ambient", "0.5"}), {128, 0, 0}), 5);
  EXPECT_LE(greatest_difference(centre({"--shade", "gouraud", "--light", "0,1,1", "--ambient", "0"}), {180, 0, 0}), 8);
  // A triangle's middle is (1/3, -1/3, 0): N·L is 0.905 there, and (1 - d²/range²)² is 0.482.
  EXPECT_LE(greatest_difference(centre({"--shade", "flat", "--point-light", "0,0,1,2", "--ambient", "0"}), {111, 0, 0}),
            8);
  EXPECT_LE(greatest_difference(centre({"--shade", "flat", "--point-light", "0,0,1", "--ambient", "0"}), {231, 0, 0}),
            8);
  EXPECT_EQ(centre({"--shade", "flat", "--point-light", "0,0,-1", "--ambient", "0"}), (Rgb888{0, 0, 0}));
  // The eye and the light look straight at it.
  EXPECT_EQ(centre({"--shade", "flat", "--ortho", "3", "--light", "0,0,1", "--ambient", "0", "--specular", "1"}),
            (Rgb888{255, 255, 255}));
  EXPECT_LE(greatest_difference(centre({"--shade", "gouraud", "--ortho", "3", "--light", "0,0,1", "--ambient", "0",
                                        "--specular", "0.5", "--shininess", "100"}),
                                {255, 128, 128}),
            8);
  EXPECT_LE(greatest_difference(render(model, with(front, {"--background", "336699"})).at(0, 0), {0x33, 0x66, 0x99}),
            5);
}

TEST_F(RenderTest, MaterialsColourSmoothShading) {
  make_file("a.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
  const std::string model = make_file("a.obj",
                                      "mtllib a.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nusemtl red\nf 1 2 3\n"
                                      "usemtl blue\nf 1 3 4\n");
  for (const std::string shade : {"flat", "gouraud", "unlit"}) {
    const Picture picture = render(model, with(front, {"--shade", shade, "--ambient", "1"}));
    EXPECT_LE(greatest_difference(picture.at(36, 28), {255, 0, 0}), 16) << shade;
    EXPECT_LE(greatest_difference(picture.at(28, 20), {0, 0, 255}), 16) << shade;
  }
}

TEST_F(RenderTest, StatisticsAddUp) {
  const std::string model = make_file("a.obj", cube_obj());
  for (const std::vector<std::string>& options : {front,
                                                  with(front, {"--cull", "none"}),
                                                  std::vector<std::string>{},
                                                  {"--size", "5x4"},
                                                  {"--eye", "0,0,4", "--target", "0,0,9"},
                                                  {"--eye", "0.9,0.9,0.9", "--target", "-5,0,0", "--cull", "none"}}) {
    render(model, with(options, {"--stats", in_folder("s.json"), "--ids-out", in_folder("ids.png")}));
    const nlohmann::json stats = nlohmann::json::parse(read_text(in_folder("s.json")));
    const auto count = [&](const char* set) { return stats.at("polygons").at(set).get<int>(); };
    EXPECT_EQ(count("total"), 12);
    EXPECT_EQ(count("outside") + count("back") + count("empty") + count("obscured") + count("visible"), 12);
    for (const char* set : {"outside", "back", "empty", "obscured", "visible"}) EXPECT_GE(count(set), 0);
    std::set<std::uint32_t> ids;
    for (const Rgb888 pixel : read_png(in_folder("ids.png")).pixels) ids.insert(number_of(pixel));
    ids.erase(0);
    EXPECT_EQ(count("visible"), static_cast<int>(ids.size()));
    for (const char* key : {"pixels", "spans", "depth_tests"}) EXPECT_TRUE(stats.at(key).is_number_unsigned()) << key;
    std::uint64_t sum = 0;
    for (const auto& [pool, bytes] : stats.at("peak_bytes").items())
      if (pool != "total") sum += bytes.get<std::uint64_t>();
    EXPECT_EQ(stats.at("peak_bytes").at("total").get<std::uint64_t>(), sum);
    EXPECT_EQ(stats.size(), 5U);
  }
}

TEST_F(RenderTest, OrthographicHeightIsInWorldUnits) {
  const std::string model = make_file("a.obj", cube_obj());
  for (const auto& [height, pixels] : {std::pair{"4", 24}, {"8", 12}, {"400000", 0}}) {
    const Picture picture = render(model, with(front, {"--ortho", height, "--shade", "unlit"}));
    int lit = 0;
    for (int y = 0; y < picture.height; ++y) lit += picture.at(32, y).red == 255 ? 1 : 0;
    EXPECT_EQ(lit, pixels) << height;
  }
  // An orthographic near plane may lie behind the eye.
  const Picture inside = render(model, {"--ortho", "4", "--eye", "0,0,0.1", "--target", "0,0,0", "--near", "-5",
                                        "--far", "5", "--size", "64x48", "--shade", "unlit"});
  EXPECT_EQ(inside.at(32, 24), (Rgb888{255, 255, 255}));
}

TEST_F(RenderTest, ScaleOfTheModelDoesNotMatter) {
  std::vector<Picture> pictures;
  for (const char* exponent : {"e0", "e-20", "e15"}) {
    std::string text;
    for (const auto& [x, y, z] : {std::tuple{-1, -1, 0}, {2, -1, 0}, {0, 2, 1}}) {
      text += "v";
      for (const int c : {x, y, z}) text.append(" ").append(std::to_string(c)).append(exponent);
      text += "\n";
    }
    pictures.push_back(render(make_file("a.obj", text + "f 1 2 3\n"), {"--size", "60x40"}));
  }
  int different = 0;
  for (std::size_t i = 0; i < pictures[0].pixels.size(); ++i)
    for (std::size_t k = 1; k < 3; ++k) different += pictures[0].pixels[i] == pictures[k].pixels[i] ? 0 : 1;
  EXPECT_LE(different, 4);
}

TEST_F(RenderTest, PanelsShowTheirOwnPicture) {
  const std::string model = make_file("a.obj", cube_obj());
  const Picture colour = render(model, {"--panel", "ili9341"});
  EXPECT_EQ(colour, render(model, {"--size", "320x240"}));
  const Picture grey = render(model, {"--panel", "ssd0323", "--band", "3"});
  EXPECT_EQ(grey.width, 128);
  EXPECT_EQ(grey.height, 64);
  for (const Rgb888 pixel : grey.pixels) {
    EXPECT_EQ(pixel.red, pixel.green);
    EXPECT_EQ(pixel.red % 17, 0);
  }
}

TEST_F(RenderTest, TurntablesBeginWithTheStillOfTheSameCamera) {
  const std::string model = make_file("a.obj", cube_obj());
  const Picture first = render(model, with(front, {"--turntable", "4"}), "turn.apng");
  EXPECT_EQ(first, render(model, front));
  const ToolRun gif = run({"render", model, "-o", in_folder("turn.gif"), "--turntable", "3", "--size", "40x30"});
  EXPECT_EQ(gif.exit_code, 0) << gif.errors;
  EXPECT_TRUE(read_text(in_folder("turn.gif")).starts_with("GIF89a"));
}

TEST_F(RenderTest, AModelBehindTheEyeLeavesTheBackground) {
  const Picture picture = render(make_file("a.obj", cube_obj()), {"--eye", "0,0,9", "--target", "0,0,20"});
  for (const Rgb888 pixel : picture.pixels) ASSERT_EQ(pixel, (Rgb888{0, 0, 0}));
}

TEST_F(RenderTest, DegenerateModelsAreDrawnAsNothing) {
  for (const std::string text : {"v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"})
    render(make_file("a.obj", text), {"--shade", "gouraud", "--stats", in_folder("s.json")});
}

TEST_F(RenderTest, Lists) {
  const ToolRun result = run({"list"});
  EXPECT_EQ(result.exit_code, 0);
  std::istringstream lines(result.output);
  std::set<std::string> found;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_EQ(std::count(line.begin(), line.end(), '\t'), 3) << line;
    const std::size_t second = line.find('\t', line.find('\t') + 1);
    found.insert(line.substr(0, second));
    found.insert(line.substr(0, line.find('\t', second + 1)));
  }
  for (const AlgorithmEntry& entry : algorithm_registry)
    EXPECT_TRUE(found.contains(std::string("visibility\t") + entry.name + "\t" + to_string(entry.exactness)))
        << entry.name;
  for (const char* entry :
       {"visibility\tspan\texact", "shading\tflat", "shading\tgouraud", "shading\tunlit", "panel\tili9341",
        "panel\tssd0323", "board\tlm3s6965evb", "board\tmps2-an385", "board\tmps2-an386", "board\tmps2-an500",
        "board\tmicrobit", "board\tstm32vldiscovery", "board\tvirt-rv32"})
    EXPECT_TRUE(found.contains(entry)) << entry;
}

TEST_F(RenderTest, TheViewerDrawsIntoAWindow) {
  setenv("SDL_VIDEODRIVER", "dummy", 1);
  const std::string model = make_file("a.obj", cube_obj());
  const ToolRun result = run({"view", model, "--frames", "2", "--size", "160x120", "--screenshot", in_folder("w.png")});
  unsetenv("SDL_VIDEODRIVER");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const Picture window = read_png(in_folder("w.png"));
  EXPECT_EQ(window.width % 160, 0);
  EXPECT_GT(window.at(window.width / 2, window.height / 2).red, 60);
}

/// The mean of the middle 16 × 16 pixels.
std::array<double, 3> middle_of(const Picture& picture) {
  std::array<double, 3> sum{};
  for (int y = 16; y < 32; ++y)
    for (int x = 24; x < 40; ++x) {
      const Rgb888 pixel = picture.at(x, y);
      sum[0] += pixel.red / 256.0;
      sum[1] += pixel.green / 256.0;
      sum[2] += pixel.blue / 256.0;
    }
  return sum;
}

TEST_F(RenderTest, GlassShowsWhatLiesBehindByEveryMethodAndAlgorithm) {
  const std::string model = panes_obj("0.5");
  for (const std::string method : {"blend", "screen-door", "stochastic"}) {
    const auto drawn = [&](const std::string& algorithm) {
      return render(model, with(front, {"--shade", "unlit", "--depth", "24", "--visibility", algorithm,
                                        "--transparency", method}));
    };
    const Picture picture = drawn("zbuffer");
    for (const AlgorithmEntry& algorithm : algorithm_registry) {
      if (algorithm.exactness == Exactness::exact) {
        EXPECT_EQ(drawn(algorithm.name).pixels, picture.pixels) << method << ", " << algorithm.name;
      }
    }
    const auto middle = middle_of(picture);
    // Random patterns: 1,024 samples, whose share has a deviation of 1/64.
    const double bound = method == "stochastic" ? 12 : 5;
    EXPECT_NEAR(middle[0], 127.5, bound) << method;
    EXPECT_NEAR(middle[1], 0, 1) << method;
    EXPECT_NEAR(middle[2], 127.5, bound) << method;
  }
}

TEST_F(RenderTest, OpacityMultipliesWhatMaterialsSay) {
  const std::string model = panes_obj("0.5");
  const Picture picture = render(model, with(front, {"--shade", "unlit", "--opacity", "0.5"}));
  const auto middle = middle_of(picture);  // a quarter of red over half of blue over black
  EXPECT_NEAR(middle[0], 255 * 0.25, 6);
  EXPECT_NEAR(middle[2], 255 * 0.5 * 0.75, 6);
  EXPECT_EQ(render(model, with(front, {"--opacity", "0"})).at(32, 24), (Rgb888{0, 0, 0}));
}

TEST_F(RenderTest, OpaqueModelsAreDrawnAlikeWhateverTheMethod) {
  const std::string model = make_file("a.obj", cube_obj());
  const Picture plain = render(model, front);
  EXPECT_EQ(render(model, with(front, {"--transparency", "blend", "--opacity", "1"})).pixels, plain.pixels);
  EXPECT_EQ(render(model, with(front, {"--transparency", "screen-door"})).pixels, plain.pixels);
}

TEST_F(RenderTest, SamplesSmoothEdges) {
  const std::string model = make_file("a.obj", cube_obj());
  const auto shades = [&](const std::vector<std::string>& options) {
    std::set<int> reds;
    for (const Rgb888 pixel : render(model, with(front, options)).pixels) reds.insert(pixel.red);
    return reds.size();
  };
  // A square cube edge may fall between pixels: turned, it does not.
  const std::vector<std::string> turned{"--up", "0.3,1,0", "--shade", "unlit"};
  EXPECT_EQ(shades(turned), 2U);
  for (const std::string samples : {"4", "8", "16"})
    EXPECT_GT(shades(with(turned, {"--transparency", "stochastic", "--samples", samples})), 3U) << samples;
}

TEST_F(RenderTest, StochasticPicturesRepeat) {
  const std::string model = panes_obj("0.4");
  const std::vector<std::string> options = with(front, {"--transparency", "stochastic", "--samples", "8"});
  EXPECT_EQ(render(model, options).pixels, render(model, options).pixels);
}

}  // namespace
}  // namespace spanline::sim::test
