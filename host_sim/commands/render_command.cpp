#include <CLI/CLI.hpp>
#include <optional>

#include "base/failure.hpp"
#include "base/output_file.hpp"
#include "base/progress.hpp"
#include "base/standard_streams.hpp"
#include "commands/commands.hpp"
#include "commands/render_options.hpp"
#include "image/animation.hpp"
#include "image/png.hpp"
#include "render/statistics_json.hpp"
#include "render/studio.hpp"

namespace spanline::sim {
namespace {

/// Everything that a run of `render` writes, opened before the work and renamed together after it.
struct RenderOutputs {
  explicit RenderOutputs(const RenderArguments& arguments) : picture(arguments.output) {
    if (arguments.depth_output) depth.emplace(*arguments.depth_output);
    if (arguments.ids_output) ids.emplace(*arguments.ids_output);
    if (arguments.statistics_output) statistics.emplace(*arguments.statistics_output);
  }

  void close() {
    picture.close();
    for (auto* file : {&depth, &ids, &statistics})
      if (*file) (*file)->close();
  }
  void commit() {
    picture.commit();
    for (auto* file : {&depth, &ids, &statistics})
      if (*file) (*file)->commit();
  }

  OutputFile picture;
  std::optional<OutputFile> depth, ids, statistics;
};

void render_still(Studio& studio, RenderOutputs& outputs, const std::optional<RenderArguments::Pixel>& pick) {
  const Frame frame = studio.draw(0);
  outputs.picture.write(encode_png(studio.picture(frame)));
  if (outputs.depth) outputs.depth->write(encode_png(to_picture(frame.depths, frame.size)));
  if (outputs.ids) outputs.ids->write(encode_png(to_picture(frame.ids, frame.size)));
  if (outputs.statistics) outputs.statistics->write(to_json(frame.statistics));
  outputs.close();
  if (pick) print(to_string(studio.pick(pick->x, pick->y)) + "\n");
}

void render_turntable(Studio& studio, int frames, OutputFile& file) {
  const AnimationFormat format = file.path().ends_with(".gif") ? AnimationFormat::gif : AnimationFormat::apng;
  const std::unique_ptr<AnimationWriter> animation = make_animation(format, file, frames);
  Progress progress("frame");
  for (int i = 0; i < frames; ++i) {
    progress.show(static_cast<std::size_t>(i), static_cast<std::size_t>(frames));
    animation->add(studio.picture(studio.draw(static_cast<double>(i) / frames)));
  }
  animation->finish();
  file.close();
}

class RenderCommand final : public Command {
 public:
  void declare(CLI::App& app) override { add_render_options(app, texts_); }

  void run() override {
    const RenderArguments arguments = parse_render_arguments(texts_);
    RenderOutputs outputs(arguments);
    Studio studio(arguments);
    if (arguments.turntable_frames > 0)
      render_turntable(studio, arguments.turntable_frames, outputs.picture);
    else
      render_still(studio, outputs, arguments.pick);
    outputs.commit();
    if (const std::optional<std::string> note = studio.note_on_culling()) print_message("note", *note);
  }

  [[nodiscard]] const char* name() const override { return "render"; }
  [[nodiscard]] const char* description() const override { return "Draws a model to a picture"; }

 private:
  RenderTexts texts_;
};

}  // namespace

std::unique_ptr<Command> make_render_command() { return std::make_unique<RenderCommand>(); }

}  // namespace spanline::sim
