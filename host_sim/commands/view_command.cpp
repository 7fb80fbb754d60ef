#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>

#include "base/failure.hpp"
#include "base/parse.hpp"
#include "commands/commands.hpp"
#include "import/model_file.hpp"
#include "scene/scene_textures.hpp"
#include "view/viewer.hpp"

namespace spanline::sim {
namespace {

constexpr int greatest_frames = 1'000'000;

class ViewCommand final : public Command {
 public:
  void declare(CLI::App& app) override {
    app.add_option("MODEL", model_, "OBJ, glTF/GLB, PLY or STL")->required();
    app.add_option("--size", size_, "size of the picture (320x240)")->type_name("WxH");
    app.add_option("--frames", frames_, "end after N frames")->type_name("N");
    app.add_option("--screenshot", screenshot_, "picture of the window's content at the end")->type_name("F.png");
    app.footer(viewer_keys());
  }

  void run() override {
    ViewerOptions options;
    options.title = std::filesystem::path(model_).filename().string();
    if (size_) options.size = parse_size("--size", *size_);
    if (frames_) options.frames = parse_integer("--frames", *frames_, 1, greatest_frames);
    if (screenshot_ && screenshot_->empty()) throw UsageError("--screenshot: the name is empty");
    options.screenshot = screenshot_;
    // The importer's process must be forked before SDL starts threads.
    Scene scene = import_model(model_);
    halve_mirrored_coordinates(scene);
    run_viewer(scene, options);
  }

  [[nodiscard]] const char* name() const override { return "view"; }
  [[nodiscard]] const char* description() const override { return "Shows a model in a window"; }

 private:
  std::string model_;
  std::optional<std::string> size_, frames_, screenshot_;
};

}  // namespace

std::unique_ptr<Command> make_view_command() { return std::make_unique<ViewCommand>(); }

}  // namespace spanline::sim
