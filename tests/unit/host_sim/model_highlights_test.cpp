// Highlights that MTL files name, by the importer and the real command.
#include <string>
#include <vector>

#include "import/model_file.hpp"
#include "model_files.hpp"
#include "tool.hpp"

namespace spanline::sim::test {
namespace {

class ModelHighlightsTest : public ToolTest {
 protected:
  /// Two squares that face +z, the left one in material `a`, the right one in `b`.
  [[nodiscard]] std::string model(const std::string& materials) const {
    make_file("m.mtl", materials);
    return make_file("a.obj",
                     "mtllib m.mtl\nv -1 -1 0\nv 0 -1 0\nv 0 1 0\nv -1 1 0\nv 1 -1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
                     "usemtl a\nf 1/1 2/2 3/3 4/1\nusemtl b\nf 2/1 5/2 6/3 3/1\n");
  }
  /// The middle of both squares, seen straight on in parallel rays, without ambient light.
  [[nodiscard]] std::vector<Rgb888> drawn(const std::string& path, const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{
        "render", path,    "-o",    in_folder("out.png"), "--ortho", "2",         "--size",
        "32x32",  "--eye", "0,0,3", "--target",           "0,0,0",   "--ambient", "0"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ToolRun result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    const Picture picture = read_png(in_folder("out.png"));
    return {picture.at(8, 16), picture.at(24, 16)};
  }
  /// RGB565's steps are 8 of 255.
  static void expect_near(const std::vector<Rgb888>& got, const std::vector<Rgb888>& wanted) {
    for (std::size_t i = 0; i < wanted.size(); ++i)
      EXPECT_LE(greatest_difference(got[i], wanted[i]), 8) << "square " << i;
  }
};

const std::string shiny = "newmtl a\nKd 0.5 0 0\nKs 0 1 0.5\nNs 4\nillum 2\nnewmtl b\nKd 0.5 0 0\n";

TEST_F(ModelHighlightsTest, AreReadWhereTheFileHasThem) {
  const auto read = [&](const std::string& lines) {
    return import_model(model("newmtl a\nKd 1 0 0\n" + lines + "newmtl b\n")).parts.at(0).highlights;
  };
  const Highlights none;
  EXPECT_EQ(read("Ks 1 0.2 0\nNs 40\nillum 2\n"), (Highlights{{255, 51, 0}, 40}));
  EXPECT_EQ(read("Ks 1 1 1\nNs 9.6\nillum 5\n"), (Highlights{{255, 255, 255}, 10}));
  EXPECT_EQ(read("Ks 1 1 1\nNs 900\nillum 2\n").shininess, 128);
  EXPECT_EQ(read("Ks 1 1 1\nNs 0.25\nillum 2\n").shininess, 1);
  EXPECT_EQ(read("Ks 1 1 1\nNs 40\nillum 1\n"), none);   // diffuse light alone
  EXPECT_EQ(read("Ks 1 1 1\nNs 40\nillum 10\n"), none);  // shadows alone
  EXPECT_EQ(read("Ks 1 1 1\nNs 40\n"), none);
  EXPECT_EQ(read("Ks 1 1 1\nillum 2\n"), none);
  EXPECT_FALSE(read("Ns 40\nillum 2\n").shines());
  const Scene scene = import_model(model(shiny));
  EXPECT_EQ(scene.parts.at(0).highlights, (Highlights{{0, 255, 128}, 4}));
  EXPECT_FALSE(scene.parts.at(1).highlights.shines());
}

TEST_F(ModelHighlightsTest, AreDrawnByThePhongFormulaOnTheirOwnParts) {
  const std::string path = model(shiny);
  // The light stands 45 degrees off the normal, along which the eye looks: N·L = R·V = 0.7071, whose fourth power is
  // 1/4.
  for (const char* shade : {"flat", "gouraud"}) {
    expect_near(drawn(path, {"--shade", shade, "--light", "1,0,1"}), {{90, 64, 32}, {90, 0, 0}});
    expect_near(drawn(path, {"--shade", shade, "--light", "0,0,1"}), {{128, 255, 128}, {128, 0, 0}});
  }
  expect_near(drawn(path, {"--shade", "unlit"}), {{128, 0, 0}, {128, 0, 0}});
  expect_near(drawn(path, {"--light", "0,0,1", "--visibility", "span"}), {{128, 255, 128}, {128, 0, 0}});
}

TEST_F(ModelHighlightsTest, GiveWayToTheCommandLine) {
  const std::string path = model(shiny);
  expect_near(drawn(path, {"--light", "0,0,1", "--specular", "0"}), {{128, 0, 0}, {128, 0, 0}});
  expect_near(drawn(path, {"--light", "1,0,1", "--specular", "1", "--shininess", "2"}),
              {{218, 128, 128}, {218, 128, 128}});
}

TEST_F(ModelHighlightsTest, AreLeftOutOnReliefsAndKeptOnSolids) {
  make_file("flat.png", png_bytes(Picture(4, 4, {128, 128, 128})));
  expect_near(drawn(model(shiny), {"--light", "0,0,1", "--shade", "flat", "--bump", in_folder("flat.png")}),
              {{128, 0, 0}, {128, 0, 0}});
  // A quarter of the highlight's colour is added to the solid's lit one.
  const std::string path = model(shiny);
  const std::vector<std::string> solid{"--light", "1,0,1", "--solid", "marble"};
  const std::vector<Rgb888> shining = drawn(path, solid);
  std::vector<std::string> with_none = solid;
  with_none.insert(with_none.end(), {"--specular", "0"});
  const std::vector<Rgb888> matte = drawn(path, with_none);
  EXPECT_EQ(shining[1], matte[1]);
  EXPECT_NEAR(shining[0].red, matte[0].red, 8);
  EXPECT_NEAR(shining[0].green, matte[0].green + 64, 8);
  EXPECT_NEAR(shining[0].blue, matte[0].blue + 32, 8);
}

TEST_F(ModelHighlightsTest, GoToFlashWithTheParts) {
  const std::string path = model(shiny);
  const auto header = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"convert", path, "-o", in_folder("a.hpp"), "--materials"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ToolRun result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return read_text(in_folder("a.hpp"));
  };
  const auto count = [](const std::string& text, const std::string& what) {
    int found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
  };
  const std::string own = header({});
  EXPECT_EQ(count(own, "spanline::shining("), 1);
  EXPECT_NE(own.find("spanline::shining(spanline::model_part(a_mesh_0, {128, 0, 0}, spanline::ShadingMode::flat), "
                     "{0, 255, 128}, 4),"),
            std::string::npos)
      << own;
  EXPECT_EQ(count(header({"--specular", "0"}), "shining"), 0);
  EXPECT_EQ(count(header({"--specular", "0.2", "--shininess", "9"}), "), {51, 51, 51}, 9),"), 2);
  const auto before = files();
  expect_refused(run({"convert", path, "-o", in_folder("b.hpp"), "--specular", "1"}), 2, before);
}

}  // namespace
}  // namespace spanline::sim::test
