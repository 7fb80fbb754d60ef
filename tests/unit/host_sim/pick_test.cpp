// Which triangle is at a pixel, by --pick and by a click, is what --ids-out and --depth-out show there.
#include <SDL.h>

#include <string>

#include "import/model_file.hpp"
#include "model_files.hpp"
#include "registry/registry.hpp"
#include "tool.hpp"
#include "view/viewer.hpp"

namespace spanline::sim::test {
namespace {

class PickTest : public ToolTest {};

std::string line_for(std::uint32_t id, std::uint32_t depth) {
  return "polygon " + std::to_string(id) + " depth " + std::to_string(depth) + "\n";
}

TEST_F(PickTest, NamesWhatTheIdsAndDepthsShowByEveryAlgorithm) {
  const std::string model = make_file("a.obj", cube_obj());
  for (const AlgorithmEntry& algorithm : visibility_algorithms())
    for (const char* depth : {"16", "24"})
      for (const auto& [x, y] : {std::pair{36, 28}, {28, 20}, {0, 0}, {63, 47}}) {
        const ToolRun result = run({"render",       model,
                                    "-o",           in_folder("o.png"),
                                    "--size",       "64x48",
                                    "--eye",        "1,2,4",
                                    "--target",     "0,0,0",
                                    "--visibility", algorithm.name,
                                    "--depth",      depth,
                                    "--ids-out",    in_folder("i.png"),
                                    "--depth-out",  in_folder("d.png"),
                                    "--pick",       std::to_string(x) + "," + std::to_string(y)});
        ASSERT_EQ(result.exit_code, 0) << result.errors;
        const Picture ids = read_png(in_folder("i.png")), depths = read_png(in_folder("d.png"));
        EXPECT_EQ(result.output, line_for(number_of(ids.at(x, y)), number_of(depths.at(x, y))))
            << algorithm.name << " at " << x << ", " << y;
      }
}

TEST_F(PickTest, RefusesPixelsOutsideThePicture) {
  const std::string model = make_file("a.obj", cube_obj());
  for (const char* pixel : {"320,0", "0,240", "-1,0", "5", "5,", ",5", "a,b", "1,2,3", ""}) {
    const ToolRun result = run({"render", model, "-o", in_folder("o.png"), "--pick", pixel});
    EXPECT_EQ(result.exit_code, 2) << pixel;
    EXPECT_NE(result.errors.find("--pick"), std::string::npos) << result.errors;
  }
}

void push_button(Uint32 type, int x, int y) {
  SDL_Event event{};
  event.type = type;
  event.button.button = SDL_BUTTON_LEFT;
  event.button.x = x;
  event.button.y = y;
  ASSERT_EQ(SDL_PushEvent(&event), 1) << SDL_GetError();
}

TEST_F(PickTest, AClickInTheViewerPicksAndADragDoesNot) {
  setenv("SDL_VIDEODRIVER", "dummy", 1);
  const Scene scene = import_model(make_file("a.obj", cube_obj()));
  ASSERT_EQ(SDL_Init(SDL_INIT_VIDEO), 0) << SDL_GetError();  // before the viewer, which takes what waits
  push_button(SDL_MOUSEBUTTONDOWN, 80, 60);
  push_button(SDL_MOUSEBUTTONUP, 80, 60);
  push_button(SDL_MOUSEBUTTONDOWN, 0, 0);
  push_button(SDL_MOUSEBUTTONUP, 0, 0);
  push_button(SDL_MOUSEBUTTONDOWN, 80, 60);
  SDL_Event drag{};
  drag.type = SDL_MOUSEMOTION;
  drag.motion.state = SDL_BUTTON_LMASK;
  drag.motion.xrel = 3;
  ASSERT_EQ(SDL_PushEvent(&drag), 1);
  push_button(SDL_MOUSEBUTTONUP, 83, 60);
  testing::internal::CaptureStdout();
  ViewerOptions options;
  options.title = "a.obj";
  options.size = {160, 120};
  options.frames = 1;
  run_viewer(scene, options);
  const std::string said = testing::internal::GetCapturedStdout();
  SDL_Quit();
  unsetenv("SDL_VIDEODRIVER");
  const std::string background = line_for(0, 65535);
  ASSERT_TRUE(said.ends_with(background)) << said;
  const std::string first = said.substr(0, said.size() - background.size());
  EXPECT_EQ(first.find("polygon "), 0U) << said;
  EXPECT_EQ(first.find('\n'), first.size() - 1) << said;
  EXPECT_EQ(first.find("polygon 0 "), std::string::npos) << said;
}

}  // namespace
}  // namespace spanline::sim::test
