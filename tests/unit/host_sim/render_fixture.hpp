#pragma once
#include <string>
#include <vector>

#include "image/png.hpp"
#include "tool.hpp"

namespace spanline::sim::test {

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
inline const std::vector<std::string> front{"--eye", "0,0,4",  "--target", "0,0,0", "--size",
                                            "64x48", "--near", "1",        "--far", "9"};

inline std::vector<std::string> with(std::vector<std::string> options, const std::vector<std::string>& more) {
  options.insert(options.end(), more.begin(), more.end());
  return options;
}

}  // namespace spanline::sim::test
