// Benchmark scenes of the documentation, measured in instructions of the emulated core: one warm frame, clears apart.
// Prints `bench <scene> <visibility> <depth> <band> <instructions> <crc> <peak bytes>` for each.
#include <bunny.hpp>
#include <spanline/frame/ready_made_traits.hpp>
#include <spanline/model/cull.hpp>

#include "board.hpp"
#include "measured_frame.hpp"
#include "scenes/model_view.hpp"
#include "scenes/screen_soups.hpp"
#include "scenes/textured_wall.hpp"
#include "scenes/wall_surfaces.hpp"

namespace {

using namespace spanline;

alignas(8) std::byte memory[1024 * 1024];
ScreenVertex soup_vertices[6000];
std::uint16_t soup_colours[2000];

void print(const char* scene, const char* visibility, int depth, unsigned band, std::uint32_t instructions,
           std::uint32_t crc, std::size_t peak_bytes) {
  board::write("bench ");
  board::write(scene);
  board::write(" ");
  board::write(visibility);
  board::write(" ");
  board::write_unsigned(static_cast<std::uint32_t>(depth));
  board::write(" ");
  board::write_unsigned(band);
  board::write(" ");
  board::write_unsigned(instructions);
  board::write(" ");
  board::write_hex(crc);
  board::write(" ");
  board::write_unsigned(static_cast<std::uint32_t>(peak_bytes));
  board::write("\n");
}

template <class Traits, class Submit>
void measure(const char* scene, const Capacity& capacity, unsigned band, Submit submit) {
  const measured::Frame frame = measured::warm_frame<Traits>(capacity, band, memory, submit);
  if (!frame.complete) board::write("bench: a pool is full\n");
  print(scene, measured::visibility_name<Traits>(band), Traits::Depth::bits, band, frame.instructions, frame.crc,
        frame.peak_bytes);
}

/// Triangles on screen, which `make` puts into its table.
template <class Traits, class Make>
void soup(const char* name, const Capacity& capacity, unsigned band, const Material& material, Make make) {
  const std::uint32_t triangles = capacity.polygons;
  const scenes::ScreenSoup target{std::span(soup_vertices).first(3 * triangles),
                                  std::span(soup_colours).first(triangles)};
  make(target);
  measure<Traits>(name, capacity, band, [&](auto& renderer) {
    FrameSettings settings;
    settings.cull = Cull::none;
    (void)renderer.begin(settings);
    if (!renderer.add_screen(target.vertices, target.colours, material).ok()) board::write("bench: a pool is full\n");
  });
}

template <class Depth, class Visibility>
void soups(unsigned band) {
  using Traits = FlatTraits<Rgb565, Depth, Visibility>;
  const auto soup = [&](const char* name, std::uint32_t triangles, auto make) {
    ::soup<Traits>(name,
                   {.polygons = triangles,
                    .active = std::min<std::uint32_t>(triangles, 600),
                    .awake = std::min<std::uint32_t>(triangles, 600)},
                   band, {}, make);
  };
  const auto right_triangles = [](std::uint32_t leg, std::uint32_t count) {
    return [=](scenes::ScreenSoup target) { scenes::make_right_triangles(leg, count, Depth::bits, target); };
  };
  soup("S1", 2000, right_triangles(8, 2000));
  soup("S2", 500, right_triangles(32, 500));
  soup("S3", 100, right_triangles(128, 100));
  soup("S7B", 40, [](scenes::ScreenSoup target) { scenes::make_full_screen_quads(true, Depth::bits, target); });
  soup("S7F", 40, [](scenes::ScreenSoup target) { scenes::make_full_screen_quads(false, Depth::bits, target); });
}

/// S7 with α = ½: twenty layers over the background.
void layers(unsigned band) {
  using Shaders = ShaderList<FlatShader<Rgb565>, SeeThroughShader<Rgb565, FlatShader<Rgb565>>>;
  using Traits = RendererTraits<Rgb565, Shaders, Depth24<>, Spanning>;
  Material glass;
  glass.opacity = 128;
  soup<Traits>("S7A", {.polygons = 40, .active = 40, .awake = 40, .layers = 40}, band, glass,
               [](scenes::ScreenSoup target) { scenes::make_full_screen_quads(true, 24, target); });
}

template <class Traits>
void model(const char* name, ShadingMode shading, unsigned band) {
  const Mesh& mesh = spanline_models::bunny;
  const auto vertices = static_cast<std::uint32_t>(mesh.vertex_count());
  const scenes::ModelView view = scenes::model_view(mesh, Angle::from_degrees(30), 240, shading);
  measure<Traits>(name,
                  {.vertices = vertices,
                   .shades = shading == ShadingMode::gouraud ? vertices : 0,
                   .polygons = 1600,
                   .active = 128,
                   .awake = 128},
                  band, [&](auto& renderer) {
                    (void)renderer.begin(view.settings);
                    if (!renderer.add(mesh, view.transform, view.material).ok())
                      board::write("bench: a pool is full\n");
                  });
}

template <class Traits>
void wall(unsigned band) {
  namespace scene = scenes::textured_wall;
  measure<Traits>("S6", {.vertices = 4, .textures = 4, .polygons = 2, .active = 2, .awake = 2}, band,
                  [&](auto& renderer) {
                    (void)renderer.begin(scene::settings());
                    if (!renderer.add(scene::mesh, {}, scene::material).ok()) board::write("bench: a pool is full\n");
                  });
}

/// S6F: the same wall, lit and in fog.
template <class Depth, class Visibility = ZBuffer>
void foggy_wall(unsigned band) {
  namespace scene = scenes::textured_wall;
  using Shaders = ShaderList<GouraudShader<Rgb565>, FoggedTextureShader<Rgb565, TexelFormat::rgb565>>;
  measure<RendererTraits<Rgb565, Shaders, Depth, Visibility>>(
      "S6F", {.vertices = 4, .shades = 4, .textures = 4, .polygons = 2, .active = 2, .awake = 2}, band,
      [&](auto& renderer) {
        (void)renderer.begin(scene::fogged_settings());
        if (!renderer.add(scene::lit_mesh, {}, scene::lit_material).ok()) board::write("bench: a pool is full\n");
      });
}

/// S8: four walls of S6 one behind the other, the farthest first, under bilinear texels.
template <class Visibility>
void hidden_walls() {
  namespace scene = scenes::textured_wall;
  constexpr std::uint32_t walls = 4;
  Material material = scene::material;
  material.texturing.filter = TextureFilter::bilinear;
  constexpr std::uint32_t corners = 4 * walls, triangles = 2 * walls;
  measure<GeneralTraits<Rgb565, Depth16<>, Visibility>>("S8",
                                                        {.instances = walls,
                                                         .vertices = corners,
                                                         .textures = corners,
                                                         .polygons = triangles,
                                                         .active = triangles,
                                                         .awake = triangles},
                                                        16, [&](auto& renderer) {
                                                          (void)renderer.begin(scene::settings());
                                                          for (std::uint32_t i = 0; i < walls; ++i) {
                                                            // Scaled about the eye, a wall covers the same pixels.
                                                            Transform farther;
                                                            farther.scale = Fixed<24>::from_ratio(
                                                                static_cast<std::int32_t>(8 - i), 4);
                                                            if (!renderer.add(scene::mesh, farther, material).ok())
                                                              board::write("bench: a pool is full\n");
                                                          }
                                                        });
}

/// What surfaces cost, flat lit, by the renderer that has every opaque shader.
void surfaces(unsigned band) {
  namespace wall = scenes::textured_wall;
  for (const auto& surface : scenes::wall_surfaces::all) {
    FrameSettings settings = wall::fogged_settings();
    if (!surface.fog) settings.fog = {};
    settings.dither = surface.dither;
    measure<GeneralTraits<>>(surface.name, {.vertices = 4, .textures = 4, .polygons = 2, .active = 2, .awake = 2}, band,
                             [&](auto& renderer) {
                               (void)renderer.begin(settings);
                               if (!renderer.add(scenes::wall_surfaces::mesh, {}, surface.material).ok())
                                 board::write("bench: not drawn\n");
                             });
  }
}

/// Where an item buffer pays, and where it does not.
void deferred() {
  using Later = Deferred<64>;
  hidden_walls<ZBuffer>();
  hidden_walls<Later>();
  wall<TextureTraits<Rgb565, Depth16<>, Later>>(16);
  model<FlatTraits<Rgb565, Depth16<>, Later>>("S4", ShadingMode::flat, 16);
}

template <class Depth, class Visibility = ZBuffer>
void all(unsigned band) {
  soups<Depth, Visibility>(band);
  model<FlatTraits<Rgb565, Depth, Visibility>>("S4", ShadingMode::flat, band);
  model<GouraudTraits<Rgb565, Depth, Visibility>>("S5", ShadingMode::gouraud, band);
  wall<TextureTraits<Rgb565, Depth, Visibility>>(band);
}

}  // namespace

int main() {
  all<Depth16<>>(0);
  all<Depth16<>>(16);
  all<Depth24<>>(0);
  all<Depth24<>, Spanning>(1);
  all<Depth24<>, Spanning>(16);
  foggy_wall<Depth16<>>(0);
  foggy_wall<Depth24<>, Spanning>(16);
  layers(16);
  deferred();
  surfaces(16);
  return 0;
}
