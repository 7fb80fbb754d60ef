// The host's benchmark: the stages of a frame one by one, and whole frames, of the scenes S4 and S5
// (docs/benchmarks.md).
//
//     build/host-release/tests/bench/host_bench
#include <benchmark/benchmark.h>

#include <bunny.hpp>
#include <cstddef>
#include <vector>

#include "scenes/model_view.hpp"
#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/frame/renderer.hpp"
#include "spanline/geometry/view_space.hpp"

namespace {

using namespace spanline;

const Mesh& mesh = spanline_models::bunny;

/// Room for the bunny: one band as high as the picture, or bands of 16 lines.
constexpr Capacity capacity(std::uint16_t band_lines) {
  const auto vertices = static_cast<std::uint32_t>(spanline_models::bunny.vertex_count());
  return {.band_lines = band_lines,
          .vertices = vertices,
          .shades = vertices,
          .polygons = 1600,
          .active = 100,
          .awake = 100};
}

template <class Traits>
struct Desk {
  using Picture = Renderer<Traits>;
  explicit Desk(std::uint16_t band_lines, ShadingMode shading)
      : view(scenes::model_view(mesh, Angle::from_degrees(30), 240, shading)),
        memory(Picture::bytes_needed(capacity(band_lines))),
        renderer(capacity(band_lines), memory) {}

  /// Geometry and lighting: vertices to the screen, culling, the polygon table.
  bool submit() { return renderer.begin(view.settings).ok() && renderer.add(mesh, view.transform, view.material).ok(); }
  void clear() {
    for (std::uint32_t band = 0; band < renderer.capacity().bands(); ++band)
      static_cast<void>(renderer.clear_band(band));
  }
  /// Set-up, visibility and shading of all bands, over whatever the memory holds.
  void draw() {
    struct {
    } sink;
    static_cast<void>(renderer.start_bands());
    for (std::uint32_t band = 0; band < renderer.capacity().bands(); ++band)
      benchmark::DoNotOptimize(renderer.draw_band(band, sink).pixels.data());
  }

  scenes::ModelView view;
  std::vector<std::byte> memory;
  Picture renderer;
};

using Flat = FlatTraits<Rgb565>;
using Gouraud = GouraudTraits<Rgb565>;
using Spans = FlatTraits<Rgb565, Depth24<>, Spanning>;

void transform_of_vertices(benchmark::State& state) {
  const scenes::ModelView view = scenes::model_view(mesh, Angle::from_degrees(30), 240, ShadingMode::flat);
  const FrameView frame{view.settings.camera, {320, 240}, 16, Depth16<>::nearest, Depth16<>::farthest};
  std::vector<ScreenVertex> screen(mesh.vertex_count());
  for (auto _ : state) {
    const InstanceGeometry geometry(frame, mesh, view.transform);
    geometry.transform_vertices(screen.data());
    benchmark::DoNotOptimize(screen.data());
  }
}

template <class Traits, ShadingMode shading>
void geometry(benchmark::State& state) {
  Desk<Traits> desk(16, shading);
  for (auto _ : state) {
    if (!desk.submit()) state.SkipWithError("a pool is full");
  }
}

void clearing(benchmark::State& state) {
  Desk<Flat> desk(16, ShadingMode::flat);
  if (!desk.submit()) state.SkipWithError("a pool is full");
  for (auto _ : state) desk.clear();
}

template <class Traits, ShadingMode shading, std::uint16_t band_lines>
void drawing(benchmark::State& state) {
  Desk<Traits> desk(band_lines, shading);
  if (!desk.submit()) state.SkipWithError("a pool is full");
  for (auto _ : state) desk.draw();
}

template <class Traits, ShadingMode shading, std::uint16_t band_lines>
void frame(benchmark::State& state) {
  Desk<Traits> desk(band_lines, shading);
  for (auto _ : state) {
    const bool good = desk.submit() && desk.renderer
                                           .draw([](const auto& band) {
                                             benchmark::DoNotOptimize(band.pixels.data());
                                             return true;
                                           })
                                           .ok();
    if (!good) state.SkipWithError("a pool is full");
  }
}

constexpr auto flat = ShadingMode::flat, gouraud = ShadingMode::gouraud;

BENCHMARK(transform_of_vertices)->Name("stage/vertices to the screen");
BENCHMARK(geometry<Flat, flat>)->Name("stage/geometry, flat");
BENCHMARK(geometry<Gouraud, gouraud>)->Name("stage/geometry, gouraud");
BENCHMARK(clearing)->Name("stage/clearing");
BENCHMARK(drawing<Flat, flat, 240>)->Name("stage/drawing, S4 zbuffer");
BENCHMARK(drawing<Flat, flat, 16>)->Name("stage/drawing, S4 scanline-z");
BENCHMARK(drawing<Spans, flat, 16>)->Name("stage/drawing, S4 span");
BENCHMARK(drawing<Gouraud, gouraud, 16>)->Name("stage/drawing, S5 scanline-z");
BENCHMARK(frame<Flat, flat, 240>)->Name("frame/S4 zbuffer");
BENCHMARK(frame<Flat, flat, 16>)->Name("frame/S4 scanline-z");
BENCHMARK(frame<Spans, flat, 16>)->Name("frame/S4 span");
BENCHMARK(frame<Gouraud, gouraud, 240>)->Name("frame/S5 zbuffer");
BENCHMARK(frame<Gouraud, gouraud, 16>)->Name("frame/S5 scanline-z");

}  // namespace

BENCHMARK_MAIN();
