#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "image/png.hpp"
#include "model_files.hpp"
#include "render_fixture.hpp"
#include "spanline/visibility/registry.hpp"
#include "tool.hpp"

namespace spanline::sim::test {
namespace {

class RenderTexturesTest : public RenderTest {};

TEST_F(RenderTexturesTest, ATextureLiesUprightOnTheModel) {
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

TEST_F(RenderTexturesTest, FogIsAsThickAsItsDistancesSayWhereverThePlanesLie) {
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

TEST_F(RenderTexturesTest, WithoutLightATextureIsShownAsItIs) {
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

TEST_F(RenderTexturesTest, WithoutLightAModelKeepsItsOwnTextureAndColour) {
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

TEST_F(RenderTexturesTest, OptionsOfTexturesWithoutOneAreRefusedWithoutLightToo) {
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

TEST_F(RenderTexturesTest, TexturesThatCannotBeAreRefusedByName) {
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

TEST_F(RenderTexturesTest, FiltersLevelsFogAndDitherReachThePicture) {
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

}  // namespace
}  // namespace spanline::sim::test
