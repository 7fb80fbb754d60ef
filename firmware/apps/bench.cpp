// Benchmark scenes of the documentation, measured in instructions of the emulated core: one warm frame, clears apart.
// Prints `bench <scene> <visibility> <depth> <band> <instructions> <crc> <peak bytes>` for each.
#include <array>
#include <cstddef>
#include <spanline/frame/ready_made_traits.hpp>
#include <spanline/visibility/registry.hpp>
#include <string_view>

#include "bench_cases.hpp"
#include "scenes/wall_surfaces.hpp"

namespace {

using namespace spanline;
using namespace spanline::bench;

template <class Traits, class Submit>
void measure_named(const char* scene, const Capacity& capacity, unsigned band, Submit submit) {
  measure<Traits>(scene, measured::visibility_name<Traits>(band), capacity, band, submit);
}

/// S7 with α = ½: twenty layers over the background.
void layers(unsigned band) {
  using Shaders = ShaderList<FlatShader<Rgb565>, SeeThroughShader<Rgb565, FlatShader<Rgb565>>>;
  using Traits = RendererTraits<Rgb565, Shaders, Depth24<>, Spanning>;
  Material glass;
  glass.opacity = 128;
  soup<Traits>("S7A", "span", {.polygons = 40, .active = 40, .awake = 40, .layers = 40}, band, glass,
               [](scenes::ScreenSoup target) { scenes::make_full_screen_quads(true, 24, target); });
}

/// S6F: the same wall, lit and in fog.
template <class Depth, class Visibility = ZBuffer>
void foggy_wall(unsigned band) {
  namespace scene = scenes::textured_wall;
  using Shaders = ShaderList<GouraudShader<Rgb565>, FoggedTextureShader<Rgb565, TexelFormat::rgb565>>;
  measure_named<RendererTraits<Rgb565, Shaders, Depth, Visibility>>(
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
  measure_named<GeneralTraits<Rgb565, Depth16<>, Visibility>>(
      "S8",
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
          farther.scale = Fixed<24>::from_ratio(static_cast<std::int32_t>(8 - i), 4);
          if (!renderer.add(scene::mesh, farther, material).ok()) board::write("bench: a pool is full\n");
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
    measure_named<GeneralTraits<>>(surface.name, {.vertices = 4, .textures = 4, .polygons = 2, .active = 2, .awake = 2},
                                   band, [&](auto& renderer) {
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
  wall<TextureTraits<Rgb565, Depth16<>, Later>>("deferred", 16);
  model<FlatTraits<Rgb565, Depth16<>, Later>>("S4", "deferred", ShadingMode::flat, 16);
}

void draw_all_cases(const AlgorithmEntry& entry, int depth_bits, unsigned band) {
  with_unit(entry.id, [&]<AlgorithmId Unit>() { draw_cases<Unit>(entry.name, depth_bits, band); });
}

void draw_all_sorting_cases(const AlgorithmEntry& entry, unsigned band) {
  with_unit(entry.id, [&]<AlgorithmId Unit>() { draw_sorting_cases<Unit>(entry.name, band); });
}

/// The lines of an algorithm's bands, 0 for the whole picture. Where a band's polygons are sorted anew for each band,
/// fewer bands mean less sorting.
constexpr unsigned lines_of_bands(const AlgorithmEntry& entry) {
  if (entry.full_frame()) return 0;
  const std::string_view name = entry.name;
  return name == "painter" || name == "depth-sort" ? 32 : 16;
}

/// The same by the numbers of algorithms: the compiler compares the names.
constexpr auto bands = [] {
  std::array<unsigned, algorithm_registry.size()> lines{};
  for (std::size_t i = 0; i < lines.size(); ++i) lines[i] = lines_of_bands(algorithm_registry[i]);
  return lines;
}();
constexpr unsigned band_of(const AlgorithmEntry& entry) { return bands[static_cast<std::size_t>(entry.id)]; }

}  // namespace

int main() {
  // Every algorithm as it is by default, and two in a second form.
  for (const AlgorithmEntry& entry : algorithm_registry) {
    draw_all_cases(entry, entry.depth_bits, band_of(entry));
    draw_all_sorting_cases(entry, band_of(entry));
  }
  draw_all_cases(entry_of(AlgorithmId::zbuffer), 24, 0);
  draw_all_cases(entry_of(AlgorithmId::span), 24, 1);
  foggy_wall<Depth16<>>(0);
  foggy_wall<Depth24<>, Spanning>(16);
  layers(16);
  deferred();
  surfaces(16);
  return 0;
}
