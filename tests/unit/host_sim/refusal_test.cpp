#include <string_view>

#include "model_files.hpp"
#include "spanline/visibility/registry.hpp"
#include "tool.hpp"

namespace spanline::sim::test {
namespace {

using RefusalTest = ToolTest;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST_F(RefusalTest, BrokenModels) {
  const std::string obj = triangle_obj();
  const std::vector<std::pair<std::string, std::string>> models{
      {"empty.obj", ""},
      {"no-face.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"},
      {"lines.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\n"},
      {"index.obj", replaced(obj, "f 1 2 3", "f 1 2 4")},
      {"negative.obj", replaced(obj, "f 1 2 3", "f 1 2 -4")},
      {"zero.obj", replaced(obj, "f 1 2 3", "f 0 1 2")},
      {"nan.obj", replaced(obj, "v 1 0 0", "v nan 0 0")},
      {"infinite.obj", replaced(obj, "v 1 0 0", "v 1e999 0 0")},
      {"words.obj", replaced(obj, "v 1 0 0", "v one 0 0")},
      {"short-vertex.obj", replaced(obj, "v 1 0 0", "v 1 0")},
      {"cut.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2"},
      {"garbage.obj", std::string("\x7f\x45\x4c\x46\0\1\2\3 garbage that is not a model", 36)},
      {"garbage.ply", "this is not a model at all"},
      {"garbage.stl", std::string(200, '\xee')},
      {"garbage.glb", std::string(200, '\xee')},
      {"garbage.gltf", "{\"asset\": "},
      {"index.ply", replaced(triangle_ply(), "3 0 1 2", "3 0 1 7")},
      {"negative.ply", replaced(triangle_ply(), "3 0 1 2", "3 0 1 -1")},
      {"nan.ply", replaced(triangle_ply(), "1 0 0", "nan 0 0")},
      {"cut.ply", triangle_ply().substr(0, triangle_ply().size() - 6)},
      {"cut-binary.ply", triangle_binary_ply().substr(0, triangle_binary_ply().size() - 3)},
      {"huge.ply", replaced(triangle_ply(), "vertex 3", "vertex 4000000000")},
      {"header.ply", "ply\nformat ascii 1.0\nelement vertex"},
      {"cut.stl", triangle_stl().substr(0, 60)},
      {"none.stl", "solid a\nendsolid a\n"},
      {"nan.stl", replaced(triangle_stl(), "vertex 1 0 0", "vertex nan 0 0")},
      {"cut-binary.stl", triangle_binary_stl().substr(0, 100)},
      {"cut.glb", triangle_glb().substr(0, triangle_glb().size() - 8)},
      {"no-buffer.gltf", replaced(triangle_gltf(), "data:application/octet-stream;base64,", "missing.bin?")},
      {"node-nan.gltf", triangle_gltf(R"("scale": [1e39, 1, 1])")},
      {"accessor.gltf", replaced(triangle_gltf(), "\"count\": 3", "\"count\": 3000000")},
      {"model.txt", obj},
  };
  for (const auto& [name, content] : models) {
    SCOPED_TRACE(name);
    const std::string path = make_file(name, content);
    const auto before = files();
    for (const std::string command : {"render", "convert"}) {
      const ToolRun result = run({command, path, "-o", in_folder("out.png")});
      expect_refused(result, 1, before);
      EXPECT_NE(result.errors.find(name), std::string::npos) << result.errors;
    }
  }
}

TEST_F(RefusalTest, FontsAreRefusedByName) {
  const std::string text = make_file("text.ttf", "this is no font");
  const auto before = files();
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"font", text, "-o", in_folder("out.hpp")},
        std::vector<std::string>{"font", in_folder("missing.ttf"), "-o", in_folder("out.hpp")}}) {
    const ToolRun result = run(arguments);
    expect_refused(result, 1, before);
    EXPECT_NE(result.errors.find(".ttf"), std::string::npos) << result.errors;
  }
  for (const char* pixels : {"3", "101", "-5", "many"})
    expect_refused(run({"font", text, "--pixels", pixels, "-o", in_folder("out.hpp")}), 2, before);
}

TEST_F(RefusalTest, ModelsThatAreNoFiles) {
  std::filesystem::create_directory(in_folder("folder.obj"));
  const auto before = files();
  for (const std::string& path :
       {in_folder("missing.obj"), in_folder("folder.obj"), std::string("/dev/null"), std::string("")})
    expect_refused(run({"render", path, "-o", in_folder("out.png")}), 1, before);
}

TEST_F(RefusalTest, OutputsThatCannotBeWritten) {
  const std::string model = make_file("a.obj", cube_obj());
  std::filesystem::create_directory(in_folder("folder"));
  const auto before = files();
  for (const std::string& path :
       {in_folder("missing/out.png"), in_folder("folder"), in_folder("new/"), std::string("/dev/full")}) {
    SCOPED_TRACE(path);
    expect_refused(run({"render", model, "-o", path}), 1, before);
    expect_refused(run({"convert", model, "-o", path}), 1, before);
    // The other outputs are not left behind either.
    for (const std::string option : {"--depth-out", "--ids-out", "--stats"})
      expect_refused(run({"render", model, "-o", in_folder("out.png"), option, path}), 1, before);
  }
}

TEST_F(RefusalTest, AFailureLeavesAnOlderPictureAlone) {
  const std::string model = make_file("a.obj", "v 0 0 0\n");
  const std::string old = make_file("out.png", "old content");
  const auto before = files();
  expect_refused(run({"render", model, "-o", old}), 1, before);
  EXPECT_EQ(read_text(old), "old content");
}

TEST_F(RefusalTest, WrongUsage) {
  const std::string model = make_file("a.obj", cube_obj());
  const auto before = files();
  const std::vector<std::vector<std::string>> wrong{{"--bogus"},
                                                    {"surplus"},
                                                    {"--size"},
                                                    {"--size", "0x10"},
                                                    {"--size", "-10x10"},
                                                    {"--size", "10x0"},
                                                    {"--size", "2048x10"},
                                                    {"--size", "10"},
                                                    {"--size", "wide"},
                                                    {"--size", "10x10x10"},
                                                    {"--size", "1e2x10"},
                                                    {"--size", "99999999999999999999x1"},
                                                    {"--size", ""},
                                                    {"--eye", "1,2"},
                                                    {"--eye", "1,2,3,4"},
                                                    {"--eye", "1,2,nan"},
                                                    {"--target", "inf,0,0"},
                                                    {"--eye", "1,1,1", "--target", "1,1,1"},
                                                    {"--up", "0,0,0"},
                                                    {"--eye", "0,5,0", "--target", "0,0,0", "--up", "0,-2,0"},
                                                    {"--fov", "0"},
                                                    {"--fov", "180"},
                                                    {"--fov", "-3"},
                                                    {"--fov", "x"},
                                                    {"--fov", "1e-9"},
                                                    {"--near", "0"},
                                                    {"--near", "-1"},
                                                    {"--far", "0"},
                                                    {"--near", "2", "--far", "1"},
                                                    {"--near", "2", "--far", "2"},
                                                    {"--near", "nan"},
                                                    {"--ortho", "0"},
                                                    {"--ortho", "-1"},
                                                    {"--ortho", "2", "--fov", "30"},
                                                    {"--visibility", "nothing"},
                                                    {"--depth", "17"},
                                                    {"--depth-sense", "sideways"},
                                                    {"--band", "0"},
                                                    {"--band", "-1"},
                                                    {"--band", "3000"},
                                                    {"--band", "2.5"},
                                                    {"--cull", "all"},
                                                    {"--shade", "phong"},
                                                    {"--light", "0,0,0"},
                                                    {"--light", "up"},
                                                    {"--point-light", "1,2"},
                                                    {"--point-light", "1,2,3,0"},
                                                    {"--point-light", "1,2,3,4,5"},
                                                    {"--point-light", "1e9,2,3"},
                                                    {"--specular", "1.5"},
                                                    {"--specular", "1", "--shininess", "129"},
                                                    {"--shininess", "10"},
                                                    {"--ambient", "1.5"},
                                                    {"--ambient", "-1"},
                                                    {"--background", "red"},
                                                    {"--background", "FFF"},
                                                    {"--panel", "nothing"},
                                                    {"--panel", "ili9341", "--size", "10x10"},
                                                    {"--turntable", "0"},
                                                    {"--turntable", "many"},
                                                    {"--stats", ""},
                                                    {"--ids-out", in_folder("out.png")},
                                                    {"--depth-out", model}};
  for (const auto& options : wrong) {
    SCOPED_TRACE(::testing::PrintToString(options));
    std::vector<std::string> arguments{"render", model, "-o", in_folder("out.png")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expect_refused(run(arguments), 2, before);
  }
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{},
        {"paint"},
        {"render"},
        {"render", model},
        {"render", "-o", in_folder("out.png")},
        {"render", model, "-o", model},
        {"render", model, "-o", in_folder("out.jpg")},
        {"render", model, "-o", in_folder("out.bmp"), "--turntable", "3"},
        {"render", model, "-o", in_folder("out.gif"), "--turntable", "3", "--stats", in_folder("s.json")},
        {"convert", model},
        {"convert", model, "-o", in_folder("a.hpp"), "--name", "1st"},
        {"convert", model, "-o", in_folder("a.hpp"), "--name", "class"},
        {"list", "surplus"},
        {"view"},
        {"view", model, "--size", "0x0"}}) {
    SCOPED_TRACE(::testing::PrintToString(arguments));
    expect_refused(run(arguments), 2, before);
  }
}

TEST_F(RefusalTest, WhatIsNotAvailableYetSaysSo) {
  const std::string model = make_file("a.obj", cube_obj());
  const auto before = files();
  std::vector<std::vector<std::string>> later{{"--wireframe"}, {"--structure", "grid"}};
  for (const std::string_view name : algorithms_to_come) later.push_back({"--visibility", std::string(name)});
  const auto check = [&](std::vector<std::string> arguments) {
    SCOPED_TRACE(::testing::PrintToString(arguments));
    const ToolRun result = run(arguments);
    expect_refused(result, 2, before);
    EXPECT_TRUE(result.errors.ends_with(": not available yet\n")) << result.errors;
  };
  for (const auto& options : later) {
    std::vector<std::string> arguments{"render", model, "-o", in_folder("out.png")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    check(arguments);
  }
  check({"convert", model, "-o", in_folder("a.hpp"), "--bsp"});
  check({"convert", model, "-o", in_folder("a.hpp"), "--simplify", "10"});
}

TEST_F(RefusalTest, OptionsOfTransparencyMustMakeSense) {
  const std::string model = make_file("a.obj", cube_obj());
  const auto before = files();
  const std::vector<std::vector<std::string>> wrong{
      {"--opacity", "1.5"},
      {"--opacity", "-0.1"},
      {"--opacity", "glass"},
      {"--transparency", "ghost"},
      {"--samples", "4"},
      {"--transparency", "blend", "--samples", "4"},
      {"--transparency", "stochastic", "--samples", "5"},
      {"--transparency", "stochastic", "--samples", "16", "--size", "512x100"},
      {"--transparency", "stochastic", "--samples", "16", "--fov", "0.5"},
      {"--transparency", "stochastic", "--size", "100x1024"}};
  for (const auto& options : wrong) {
    SCOPED_TRACE(::testing::PrintToString(options));
    std::vector<std::string> arguments{"render", model, "-o", in_folder("out.png")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expect_refused(run(arguments), 2, before);
  }
}

}  // namespace
}  // namespace spanline::sim::test
