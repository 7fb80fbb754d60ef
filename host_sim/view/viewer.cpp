#include "view/viewer.hpp"
#include <spanline/model/cull.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>

#include "base/failure.hpp"
#include "base/output_file.hpp"
#include "image/png.hpp"
#include "render/part_textures.hpp"
#include "render/setup.hpp"
#include "view/orbit.hpp"
#include "view/window.hpp"

namespace spanline::sim {
namespace {

constexpr double key_step = 0.08;   ///< radians an arrow key
constexpr double drag_step = 0.01;  ///< radians a pixel of the mouse
constexpr double zoom_step = 1.1;
constexpr int idle_milliseconds = 20;

/// The choices that keys switch, drawn with what `render` draws with.
struct Choices {
  std::size_t visibility = 1, shading = 0;
  std::optional<int> depth_bits;  ///< by the algorithm until a key says otherwise
  Cull cull = Cull::back;

  void next_cull() { cull = cull == Cull::back ? Cull::front : cull == Cull::front ? Cull::none : Cull::back; }
  [[nodiscard]] const char* cull_name() const {
    return cull == Cull::back ? "back" : cull == Cull::front ? "front" : "none";
  }
};

class Viewer {
 public:
  Viewer(const Scene& scene, const ViewerOptions& options)
      : scene_(scene),
        options_(options),
        orbit_(make_orbit(scene, options.size)),
        window_(options.title, options.size) {
    if (is_textured(scene)) textures_ = PartTextures(scene, {.resize = true});
    const ShadingEntry& start = default_shading(scene);
    choices_.shading = static_cast<std::size_t>(&start - shadings().data());
  }

  void run() {
    for (int frame = 0; !closed_ && (options_.frames == 0 || frame < options_.frames); ++frame) {
      draw();
      do {
        handle_events();
        if (!dirty_ && options_.frames == 0) SDL_Delay(idle_milliseconds);
      } while (!dirty_ && !closed_ && options_.frames == 0);
    }
  }

  [[nodiscard]] Picture read_back() { return window_.read_back(); }

 private:
  static Orbit make_orbit(const Scene& scene, Size size) {
    const View home = resolve_view({}, scene, size, true);
    double radius = 0;
    for (const Scene::Triangle& triangle : scene.triangles)
      for (const std::uint32_t corner : triangle)
        radius = std::max(radius, length(scene.positions[corner] - home.target));
    return {home, radius > 0 ? radius : 1};
  }

  void draw() {
    const ShadingEntry& shading = shadings()[choices_.shading];
    if (!renderer_) {
      const Scene prepared = prepared_for(scene_, shading);
      world_ = choose_world(orbit_.farthest(), prepared, options_.size);
      renderer_.emplace(to_core_meshes(prepared, world_));
    }
    RenderArguments arguments;
    arguments.size = options_.size;
    arguments.visibility = &visibility_algorithms()[choices_.visibility];
    arguments.depth_bits = choices_.depth_bits;
    arguments.cull = choices_.cull;
    arguments.background = {24, 28, 40};
    const View view = orbit_.view();
    const auto start = std::chrono::steady_clock::now();
    request_ = make_request(arguments, shading, view, world_, resolve_light({}, {}, std::nullopt, view));
    if (shows_textures(shading, scene_)) request_.textures = textures_.of_part();
    const Frame frame = renderer_->draw(request_);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    window_.show(frame.pixels);
    describe(frame.statistics, time.count());
    window_.set_title(options_.title + " | " + description_);
    dirty_ = false;
  }

  void describe(const FrameStatistics& statistics, double milliseconds) {
    const PolygonSets& polygons = statistics.polygons;
    std::array<char, 256> text{};
    std::snprintf(
        text.data(), text.size(),
        "%s %d bits, %s, cull %s | %llu triangles, %llu outside, %llu back | %llu spans, %llu pixels | %.1f ms",
        visibility_algorithms()[choices_.visibility].name, request_.depth_bits, shadings()[choices_.shading].name,
        choices_.cull_name(), static_cast<unsigned long long>(polygons.total),
        static_cast<unsigned long long>(polygons.outside), static_cast<unsigned long long>(polygons.back),
        static_cast<unsigned long long>(statistics.visibility.spans),
        static_cast<unsigned long long>(statistics.visibility.pixels), milliseconds);
    description_ = text.data();
    const VisibilityCounters& counted = statistics.visibility;
    for (std::size_t i = 0; i < counted.names.size(); ++i)
      description_ += (i == 0 ? " | " : ", ") + std::to_string(counted.own[i]) + ' ' + std::string(counted.names[i]);
  }

  /// Says which triangle is at a pixel of the picture: in the title until the next frame, and on stdout.
  void pick(int x, int y) {
    if (!renderer_ || x < 0 || y < 0 || x >= options_.size.width || y >= options_.size.height) return;
    const PickedPixel picked = renderer_->pick(request_, x, y);
    const std::string text = to_string(picked);
    std::printf("%s\n", text.c_str());
    std::fflush(stdout);
    window_.set_title(options_.title + " | " + text + " | " + description_);
  }

  void handle_events() {
    SDL_Event event;
    while (SDL_PollEvent(&event) != 0) {
      if (event.type == SDL_QUIT) closed_ = true;
      if (event.type == SDL_WINDOWEVENT) dirty_ = true;
      if (event.type == SDL_KEYDOWN) handle_key(event.key.keysym.sym);
      if (event.type == SDL_MOUSEBUTTONDOWN) dragged_ = false;
      if (event.type == SDL_MOUSEMOTION && (event.motion.state & SDL_BUTTON_LMASK) != 0) {
        dragged_ = true;
        turn(-event.motion.xrel * drag_step, event.motion.yrel * drag_step);
      }
      if (event.type == SDL_MOUSEBUTTONUP && event.button.button == SDL_BUTTON_LEFT && !dragged_)
        pick(event.button.x, event.button.y);
      if (event.type == SDL_MOUSEWHEEL && event.wheel.y != 0) zoom(event.wheel.y > 0 ? 1 / zoom_step : zoom_step);
    }
  }

  void handle_key(SDL_Keycode key) {
    switch (key) {
      case SDLK_LEFT:
        return turn(-key_step, 0);
      case SDLK_RIGHT:
        return turn(key_step, 0);
      case SDLK_UP:
        return turn(0, key_step);
      case SDLK_DOWN:
        return turn(0, -key_step);
      case SDLK_PLUS:
      case SDLK_EQUALS:
      case SDLK_KP_PLUS:
        return zoom(1 / zoom_step);
      case SDLK_MINUS:
      case SDLK_KP_MINUS:
        return zoom(zoom_step);
      case SDLK_ESCAPE:
      case SDLK_q:
        closed_ = true;
        return;
      default:
        return switch_choice(key);
    }
  }

  void switch_choice(SDL_Keycode key) {
    dirty_ = true;
    if (key == SDLK_v) choices_.visibility = (choices_.visibility + 1) % visibility_algorithms().size();
    if (key == SDLK_d) choices_.depth_bits = request_.depth_bits == 16 ? 24 : 16;
    if (key == SDLK_c) choices_.next_cull();
    if (key == SDLK_r) orbit_.reset();
    if (key == SDLK_s) {
      do choices_.shading = (choices_.shading + 1) % shadings().size();
      while (shadings()[choices_.shading].textured && !is_textured(scene_));
      renderer_.reset();  // other shadings need other tables
    }
  }

  void turn(double right, double up) {
    orbit_.turn(right, up);
    dirty_ = true;
  }

  void zoom(double factor) {
    orbit_.zoom(factor);
    dirty_ = true;
  }

  const Scene& scene_;
  const ViewerOptions& options_;
  Orbit orbit_;
  Window window_;
  Choices choices_;
  World world_;
  PartTextures textures_;
  std::optional<FrameRenderer> renderer_;
  FrameRequest request_;     ///< of the last frame
  std::string description_;  ///< of the last frame
  bool dragged_ = false;
  bool dirty_ = true;
  bool closed_ = false;
};

}  // namespace

void run_viewer(const Scene& scene, const ViewerOptions& options) {
  std::optional<OutputFile> screenshot;
  if (options.screenshot) screenshot.emplace(*options.screenshot);
  Viewer viewer(scene, options);
  viewer.run();
  if (!screenshot) return;
  screenshot->write(encode_png(viewer.read_back()));
  screenshot->commit();
}

const char* viewer_keys() {
  return "Click: triangle and depth at the pixel. Drag or arrow keys: orbit. Wheel, + and -: zoom. v: visibility "
         "algorithm. d: bits of depth. s: shading. "
         "c: culling. r: back to the start. q or Escape: quit.";
}

}  // namespace spanline::sim
