#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <tuple>

#include "image/png.hpp"
#include "model_files.hpp"
#include "render_fixture.hpp"
#include "spanline/visibility/registry.hpp"
#include "tool.hpp"

namespace spanline::sim::test {
namespace {

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
  // The square is one polygon, lit as its middle is: (1 - d²/range²)² is 0.5625 there.
  EXPECT_LE(greatest_difference(centre({"--shade", "flat", "--point-light", "0,0,1,2", "--ambient", "0"}), {143, 0, 0}),
            8);
  EXPECT_LE(greatest_difference(centre({"--shade", "flat", "--point-light", "0,0,1", "--ambient", "0"}), {255, 0, 0}),
            8);
  // A triangle's middle is (1/3, -1/3, 0): N·L is 0.905 there, and (1 - d²/range²)² is 0.482.
  const std::string half = make_file("b.obj", "v -1 -1 0 1 0 0\nv 1 -1 0 1 0 0\nv 1 1 0 1 0 0\nf 1 2 3\n");
  const auto of_half = [&](const std::string& light) {
    return render(half, with(front, {"--shade", "flat", "--point-light", light, "--ambient", "0"})).at(34, 26);
  };
  EXPECT_LE(greatest_difference(of_half("0,0,1,2"), {111, 0, 0}), 8);
  EXPECT_LE(greatest_difference(of_half("0,0,1"), {231, 0, 0}), 8);
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
