// What the turntable's display must show: frame NUMBER drawn on this host as one band, through the panel's driver into
// the panel's model, as a PNG. MODEL is bunny, teapot or gauges (firmware/apps/gauges.cpp), SHADING flat
// or gouraud.
#include <bunny.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <sans_14.hpp>
#include <spanline/frame/ready_made_traits.hpp>
#include <spanline/model/cull.hpp>
#include <stdexcept>
#include <string>
#include <teapot.hpp>
#include <vector>

#include "apps/turntable.hpp"
#include "image/png.hpp"
#include "panels/panel_registry.hpp"
#include "scenes/gauges.hpp"

namespace {

using namespace spanline;

/// The frame's pixels as RGB565 in native order, without the app's loop, bands and pools.
std::vector<std::uint16_t> draw(const Mesh& mesh, ShadingMode shading, std::uint32_t number, int width, int height) {
  const Angle angle = Angle::from_turns(number, 60);
  const scenes::ModelView view = scenes::model_view(mesh, angle, height, shading);
  const auto vertices = static_cast<std::uint32_t>(mesh.vertex_count());
  const Capacity capacity{.width = static_cast<std::uint16_t>(width),
                          .height = static_cast<std::uint16_t>(height),
                          .band_lines = static_cast<std::uint16_t>(height),
                          .colour_bands = 1,
                          .vertices = vertices,
                          .shades = vertices,
                          .polygons = static_cast<std::uint32_t>(mesh.triangle_count())};
  using Picture = Renderer<GouraudTraits<Rgb565>>;
  std::vector<std::byte> memory(Picture::bytes_needed(capacity));
  Picture renderer(capacity, memory);
  std::vector<std::uint16_t> pixels;
  const bool good = renderer.begin(view.settings).ok() && renderer.add(mesh, view.transform, view.material).ok() &&
                    renderer
                        .draw([&](const auto& band) {
                          pixels.assign(band.pixels.begin(), band.pixels.end());
                          return true;
                        })
                        .ok();
  if (!good) throw std::runtime_error("the renderer refuses the scene");
  return pixels;
}

/// The same of the instrument panel.
std::vector<std::uint16_t> draw_gauges(std::uint32_t number, int width, int height) {
  const Capacity capacity{.width = static_cast<std::uint16_t>(width),
                          .height = static_cast<std::uint16_t>(height),
                          .band_lines = static_cast<std::uint16_t>(height),
                          .colour_bands = 1,
                          .polygons = scenes::Gauges::most_triangles};
  using Picture = Renderer<FlatTraits<Rgb565>>;
  std::vector<std::byte> memory(Picture::bytes_needed(capacity));
  Picture renderer(capacity, memory);
  scenes::Gauges gauges;
  gauges.make(number, width, height);
  FrameSettings settings;
  settings.cull = Cull::none;
  settings.background = scenes::Gauges::background;
  std::vector<std::uint16_t> pixels;
  const bool good = renderer.begin(settings).ok() && renderer.add_screen(gauges.vertices(), gauges.colours()).ok() &&
                    renderer
                        .draw([&](const auto& band) {
                          pixels.assign(band.pixels.begin(), band.pixels.end());
                          return true;
                        })
                        .ok();
  if (!good) throw std::runtime_error("the renderer refuses the gauges");
  Canvas<Rgb565> canvas(pixels, width, 0, height);
  gauges.write(canvas, spanline_fonts::sans_14);
  return pixels;
}

sim::PanelPicture show(const std::string& panel, const std::string& model, ShadingMode shading, std::uint32_t number) {
  const auto session = sim::open_panel(panel);
  if (session == nullptr) throw std::runtime_error("no panel " + panel);
  const sim::PanelInfo& info = session->info();
  const Mesh& mesh = model == "teapot" ? spanline_models::teapot : spanline_models::bunny;
  const std::vector<std::uint16_t> pixels = model == "gauges" ? draw_gauges(number, info.width, info.height)
                                                              : draw(mesh, shading, number, info.width, info.height);
  const hal::DisplayStatus status = session->show(info.height, [&](int, int, std::span<std::uint16_t> band) {
    std::copy(pixels.begin(), pixels.end(), band.begin());
  });
  if (status != hal::DisplayStatus::ok) throw std::runtime_error(panel + ": " + to_string(status));
  if (!session->complaints().empty()) throw std::runtime_error(panel + ": " + describe(session->complaints().front()));
  return session->picture();
}

void write(const std::string& path, const sim::PanelPicture& seen) {
  sim::Picture picture(seen.width, seen.height);
  for (int y = 0; y < seen.height; ++y) {
    for (int x = 0; x < seen.width; ++x) {
      const std::uint8_t* rgb = seen.at(x, y);
      picture.at(x, y) = {rgb[0], rgb[1], rgb[2]};
    }
  }
  const std::vector<std::byte> png = sim::encode_png(picture);
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
  if (!file) throw std::runtime_error("cannot write " + path);
}

}  // namespace

int main(int count, char** arguments) {
  try {
    if (count != 4 && count != 6)
      throw std::runtime_error("usage: turntable_host PANEL NUMBER OUT.png [MODEL SHADING]");
    const std::string model = count == 6 ? arguments[4] : "bunny", shading = count == 6 ? arguments[5] : "gouraud";
    const ShadingMode mode = shading == "flat" ? ShadingMode::flat : ShadingMode::gouraud;
    write(arguments[3], show(arguments[1], model, mode, static_cast<std::uint32_t>(std::stoul(arguments[2]))));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "turntable_host: %s\n", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
