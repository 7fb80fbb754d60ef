// A frame that two drawers share, each every second band, drawn one after the other: the picture must be the one that a
// single renderer draws. Prints `two_cores <scene> <visibility> <instructions alone> <of the frame's geometry>
// <of the even bands> <of the odd bands> <crc>` for each, clears included, and ends with 1 where a picture differs.
#include <bunny.hpp>

#include "board.hpp"
#include "counter.hpp"
#include "measured_frame.hpp"
#include "scenes/crc32.hpp"
#include "scenes/model_view.hpp"
#include "scenes/screen_soups.hpp"
#include "scenes/textured_wall.hpp"
#include "spanline/frame/band_partner.hpp"
#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/model/cull.hpp"

namespace {

using namespace spanline;

alignas(8) std::byte memory[256 * 1024], partner_memory[128 * 1024];
ScreenVertex soup_vertices[1500];
std::uint16_t soup_colours[500];
std::uint32_t band_crcs[240];

/// Notes a CRC for each band, since the two do not draw them in order.
struct BandCrcs {
  int lines;
  template <class Band>
  bool operator()(const Band& band) const {
    scenes::Crc32 crc;
    for (const auto pixel : band.pixels) crc.add(pixel);
    band_crcs[band.y0 / lines] = crc.value();
    return true;
  }
};

std::uint32_t crc_of_bands(std::uint32_t bands) {
  scenes::Crc32 crc;
  for (std::uint32_t i = 0; i < bands; ++i) {
    crc.add(static_cast<std::uint16_t>(band_crcs[i]));
    crc.add(static_cast<std::uint16_t>(band_crcs[i] >> 16));
    band_crcs[i] = 0;
  }
  return crc.value();
}

bool same = true;

/// Instructions of drawing, without those of the CRCs.
template <class Draw>
std::uint32_t counted(Draw draw) {
  board::counter_start();
  if (!draw().ok()) same = false;
  return board::counter_read();
}

struct NoSink {
  template <class Band>
  bool operator()(const Band&) const {
    return true;
  }
};

template <class Traits, class Submit>
void share(const char* scene, Capacity capacity, Submit submit) {
  Renderer<Traits> renderer(capacity, memory);
  BandPartner<Traits> partner(renderer, partner_memory);
  same = same && renderer.status().ok() && partner.status().ok();
  const BandCrcs crcs{capacity.band_lines};

  same = submit(renderer) && same;
  same = renderer.draw(crcs).ok() && same;
  const std::uint32_t alone = crc_of_bands(capacity.bands());
  submit(renderer);
  const std::uint32_t instructions_alone = counted([&] { return renderer.draw(NoSink{}); });

  submit(renderer);
  same = partner.take_frame().ok() && same;
  same = renderer.draw_even(crcs).ok() && partner.draw_odd(crcs).ok() && same;
  const std::uint32_t shared = crc_of_bands(capacity.bands());
  same = same && shared == alone;
  const std::uint32_t geometry = counted([&] {
    submit(renderer);
    return partner.take_frame();
  });
  const std::uint32_t even = counted([&] { return renderer.draw_even(NoSink{}); });
  const std::uint32_t odd = counted([&] { return partner.draw_odd(NoSink{}); });

  board::write("two_cores ");
  board::write(scene);
  board::write(measured::is_spanning<Traits> ? " span" : " scanline-z");
  for (const std::uint32_t number : {instructions_alone, geometry, even, odd}) {
    board::write(" ");
    board::write_unsigned(number);
  }
  board::write(" ");
  board::write_hex(shared);
  board::write(shared == alone ? "\n" : " differs\n");
}

template <class Traits>
void bunny(const char* name, ShadingMode shading) {
  const Mesh& mesh = spanline_models::bunny;
  const auto vertices = static_cast<std::uint32_t>(mesh.vertex_count());
  const scenes::ModelView view = scenes::model_view(mesh, Angle::from_degrees(30), 240, shading);
  share<Traits>(name, {.vertices = vertices, .shades = vertices, .polygons = 1600, .active = 128, .awake = 128},
                [&](auto& renderer) {
                  return renderer.begin(view.settings).ok() && renderer.add(mesh, view.transform, view.material).ok();
                });
}

template <class Depth, class Visibility>
void all() {
  using Gouraud = GouraudTraits<Rgb565, Depth, Visibility>;
  bunny<Gouraud>("S4", ShadingMode::flat);
  bunny<Gouraud>("S5", ShadingMode::gouraud);
  const scenes::ScreenSoup soup{soup_vertices, soup_colours};
  scenes::make_right_triangles(32, 500, Depth::bits, soup);
  share<Gouraud>("S2", {.polygons = 500, .active = 500, .awake = 500}, [&](auto& renderer) {
    FrameSettings settings;
    settings.cull = Cull::none;
    return renderer.begin(settings).ok() && renderer.add_screen(soup.vertices, soup.colours).ok();
  });
  namespace wall = scenes::textured_wall;
  share<TextureTraits<Rgb565, Depth, Visibility>>(
      "S6", {.vertices = 4, .textures = 4, .polygons = 2, .active = 2, .awake = 2}, [&](auto& renderer) {
        return renderer.begin(wall::settings()).ok() && renderer.add(wall::mesh, {}, wall::material).ok();
      });
}

}  // namespace

int main() {
  all<Depth16<>, ZBuffer>();
  all<Depth24<>, Spanning>();
  return same ? 0 : 1;
}
