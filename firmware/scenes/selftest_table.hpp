#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "scenes/selftest_scenes.hpp"

namespace spanline::scenes {

/// The renderers that the self-test is drawn with. Each costs 15 to 35 KB of flash.
enum class SelftestRenderer : std::uint8_t {
  flat_16,            ///< flat shading alone, 16-bit depth
  flat_16_larger,     ///< the same, and larger depth is nearer
  gouraud_16,         ///< flat and Gouraud shading, 16-bit depth
  swapped_16,         ///< the same, and pixels have their high byte first
  gouraud_24,         ///< flat and Gouraud shading, 24-bit depth
  gouraud_24_larger,  ///< the same, and larger depth is nearer
  span_flat,          ///< spanning scan line, flat shading alone, 24 bits
  span_gouraud,       ///< spanning scan line, flat and Gouraud shading, 24 bits
  layers_16,          ///< flat and Gouraud shading, opaque and see-through, 16-bit depth
  layers_24,          ///< the same, 24-bit depth
  span_layers,        ///< the same by spanning scan line, 24 bits
  surfaces_24,        ///< the general shader, opaque and see-through, 24-bit depth
  span_surfaces,      ///< the same by spanning scan line
  textures_16,        ///< textures, plain, lit and in fog, 16-bit depth
  span_textures,      ///< the same by spanning scan line, 24 bits
};

/// The renderer as lines of the self-test name it, in the column of the depth.
[[nodiscard]] constexpr const char* to_string(SelftestRenderer renderer) {
  constexpr const char* names[] = {"16-flat",   "16-flat-larger", "16",          "16-swapped",  "24",
                                   "24-larger", "24-flat",        "24",          "16-layers",   "24-layers",
                                   "24-layers", "24-surfaces",    "24-surfaces", "16-textures", "24-textures"};
  return names[static_cast<unsigned>(renderer)];
}

[[nodiscard]] constexpr bool is_spanning(SelftestRenderer renderer) {
  return renderer == SelftestRenderer::span_flat || renderer == SelftestRenderer::span_gouraud ||
         renderer == SelftestRenderer::span_layers || renderer == SelftestRenderer::span_surfaces ||
         renderer == SelftestRenderer::span_textures;
}

/// One drawing of a scene.
struct SelftestRun {
  SelftestRenderer renderer;
  std::uint16_t band;    ///< lines; the height of the picture for a z-buffer; 0 ends a list of runs
  std::uint32_t memory;  ///< bytes that it takes on a 32-bit machine, at most
};

/// A scene of the self-test: the same picture on every machine.
struct SelftestScene {
  const char* name;
  void (*build)(const SelftestRequest&, SelftestContent&);
  Capacity capacity;             ///< what it takes; the height of bands is a run's business
  std::uint32_t soup_triangles;  ///< given on screen
  Pool starved;                  ///< the pool that is too small for it, on purpose
  std::array<SelftestRun, 10> runs;
  std::uint32_t awake = 0;  ///< polygons awake at once: the active pool of spanning runs, and that of layers
};

namespace selftest_detail {

using enum SelftestRenderer;

constexpr SelftestScene soup(const char* name, SoupShape shape, std::uint16_t width, std::uint16_t height,
                             std::uint32_t triangles, std::uint32_t active, std::array<SelftestRun, 10> runs,
                             std::uint32_t awake = 0) {
  constexpr void (*builders[])(const SelftestRequest&, SelftestContent&) = {
      build_soup<SoupShape::tiny>,  build_soup<SoupShape::large>,    build_soup<SoupShape::sliver>,
      build_soup<SoupShape::guard>, build_soup<SoupShape::crossing>, build_soup<SoupShape::tied>};
  return {name,
          builders[static_cast<unsigned>(shape)],
          {.width = width, .height = height, .polygons = triangles, .active = active},
          triangles,
          Pool::none,
          runs,
          awake};
}

inline constexpr SelftestScene scenes[] = {
    // Random triangles on screen: name, shape, width, height, triangles, active, runs.
    soup("soup-tiny", SoupShape::tiny, 320, 240, 2000, 36,
         {{{flat_16, 16, 94424},
           {gouraud_16, 1, 67352},
           {gouraud_16, 240, 368128},
           {gouraud_24, 7, 82944},
           {span_flat, 1, 67416},
           {span_gouraud, 16, 88344}}},
         50),
    soup("soup-large", SoupShape::large, 320, 240, 100, 84,
         {{{flat_16, 16, 41264},
           {flat_16_larger, 7, 24024},
           {gouraud_24, 16, 54320},
           {gouraud_24_larger, 1, 16368},
           {span_flat, 1, 13392},
           {span_gouraud, 16, 35312}}},
         81),
    soup("soup-slivers", SoupShape::sliver, 320, 240, 300, 156,
         {{{flat_16, 16, 53024},
           {gouraud_16, 7, 40904},
           {gouraud_24, 1, 30432},
           {span_flat, 1, 26400},
           {span_gouraud, 7, 39136}}},
         154),
    soup("soup-guard", SoupShape::guard, 320, 240, 100, 84,
         {{{flat_16, 16, 41264},
           {gouraud_16, 1, 15728},
           {gouraud_24, 16, 54320},
           {gouraud_24, 240, 464728},
           {span_flat, 16, 32400},
           {span_gouraud, 1, 15856}}},
         79),
    soup("soup-crossing", SoupShape::crossing, 320, 240, 100, 84,
         {{{flat_16, 1, 12912},
           {flat_16, 7, 24024},
           {flat_16, 16, 41264},
           {flat_16, 240, 311000},
           {flat_16_larger, 16, 41264},
           {gouraud_24, 1, 16368},
           {gouraud_24, 16, 54320},
           {gouraud_24_larger, 7, 31320},
           {span_flat, 1, 13200},
           {span_gouraud, 240, 321776}}},
         79),
    soup("soup-tied", SoupShape::tied, 320, 240, 40, 36,
         {{{flat_16, 7, 18384},
           {gouraud_16, 240, 309328},
           {gouraud_24_larger, 16, 47144},
           {span_flat, 7, 14568},
           {span_gouraud, 1, 8040}}},
         32),
    soup("soup-tiny-small", SoupShape::tiny, 128, 128, 200, 12,
         {{{flat_16, 1, 8776},
           {flat_16, 4, 10888},
           {gouraud_24, 1, 9544},
           {gouraud_24_larger, 2, 10440},
           {span_flat, 1, 8968}}},
         14),
    soup("soup-slivers-small", SoupShape::sliver, 128, 128, 40, 18,
         {{{flat_16, 1, 4456}, {flat_16, 7, 8848}, {gouraud_24, 1, 5416}, {span_flat, 1, 4552}}}, 18),
    soup("soup-guard-small", SoupShape::guard, 128, 128, 30, 26,
         {{{flat_16, 1, 4800},
           {flat_16, 7, 9192},
           {flat_16_larger, 1, 4800},
           {gouraud_24, 1, 6016},
           {span_flat, 1, 5024},
           {span_flat, 7, 8096}}},
         26),
    soup("soup-crossing-small", SoupShape::crossing, 128, 128, 30, 28,
         {{{flat_16, 1, 4960},
           {flat_16, 7, 9352},
           {flat_16_larger, 1, 4960},
           {gouraud_24, 1, 6240},
           {span_flat, 1, 5120},
           {span_flat, 16, 12800}}},
         27),
    // Meshes: name, builder, pools, no soup, nothing starved, runs.
    {"bunny-flat",
     build_bunny<ShadingMode::flat>,
     {.width = 320, .height = 240, .vertices = 1850, .polygons = 1540, .active = 72},
     0,
     Pool::none,
     {{{flat_16, 16, 58416},
       {flat_16, 240, 329112},
       {flat_16_larger, 7, 41176},
       {gouraud_24, 16, 71088},
       {span_flat, 1, 32368},
       {span_flat, 16, 51568}}},
     90},
    {"bunny-gouraud",
     build_bunny<ShadingMode::gouraud>,
     {.width = 320, .height = 240, .vertices = 1850, .shades = 1850, .polygons = 1540, .active = 72},
     0,
     Pool::none,
     {{{gouraud_16, 1, 39896},
       {gouraud_16, 7, 51008},
       {gouraud_16, 16, 68248},
       {gouraud_16, 240, 336640},
       {swapped_16, 7, 51008},
       {gouraud_24, 7, 55488},
       {gouraud_24, 16, 78488},
       {gouraud_24_larger, 16, 78488},
       {span_gouraud, 1, 42776}}},
     90},
    {"teapot-flat",
     build_teapot<ShadingMode::flat>,
     {.width = 320, .height = 240, .vertices = 540, .polygons = 340, .active = 40},
     0,
     Pool::none,
     {{{flat_16, 1, 12224},
       {flat_16, 16, 40576},
       {gouraud_24_larger, 7, 29224},
       {span_flat, 1, 13248},
       {span_flat, 240, 319168}}},
     50},
    {"teapot-gouraud",
     build_teapot<ShadingMode::gouraud>,
     {.width = 320, .height = 240, .vertices = 540, .shades = 540, .polygons = 340, .active = 40},
     0,
     Pool::none,
     {{{gouraud_16, 7, 26904},
       {gouraud_16, 16, 44144},
       {gouraud_16, 240, 316120},
       {swapped_16, 1, 15792},
       {gouraud_24, 16, 54384},
       {gouraud_24_larger, 7, 31384},
       {span_gouraud, 16, 36336}}},
     50},
    {"teapot-cut",
     build_cut_teapot,
     {.width = 320, .height = 240, .vertices = 760, .shades = 760, .polygons = 760, .fans = 136, .active = 64},
     0,
     Pool::none,
     {{{gouraud_16, 16, 52512}, {gouraud_24, 7, 39752}, {span_gouraud, 1, 28704}, {span_gouraud, 16, 47904}}},
     96},
    {"teapot-ortho",
     build_ortho_teapot,
     {.width = 320, .height = 240, .vertices = 540, .polygons = 500, .active = 68},
     0,
     Pool::none,
     {{{flat_16, 16, 43456}, {flat_16_larger, 7, 26216}, {gouraud_24, 16, 56000}, {span_flat, 1, 18112}}},
     94},
    {"terrain",
     build_terrain,
     {.width = 320, .height = 240, .vertices = 360, .polygons = 220, .fans = 40, .active = 60},
     0,
     Pool::none,
     {{{flat_16_larger, 7, 23416},
       {gouraud_16, 16, 42704},
       {gouraud_24, 16, 52944},
       {gouraud_24_larger, 1, 14992},
       {span_gouraud, 1, 15248}}},
     64},
    {"prisms",
     build_prisms,
     {.width = 320, .height = 240, .vertices = 66, .polygons = 60, .fans = 56, .active = 24},
     0,
     Pool::none,
     {{{flat_16_larger, 16, 34944}, {gouraud_24, 7, 23080}, {span_gouraud, 16, 26368}}},
     23},
    {"lights",
     build_lights<ShadingMode::gouraud>,
     {.width = 320, .height = 240, .vertices = 288, .shades = 288, .polygons = 280, .active = 60},
     0,
     Pool::none,
     {{{gouraud_16, 16, 43120}, {swapped_16, 16, 43120}, {gouraud_24, 7, 30360}, {span_gouraud, 7, 22704}}},
     59},
    {"mixture",
     build_mixture,
     {.width = 320,
      .height = 240,
      .instances = 4,
      .vertices = 940,
      .shades = 576,
      .polygons = 880,
      .fans = 64,
      .active = 140},
     0,
     Pool::none,
     {{{gouraud_16, 1, 34272},
       {gouraud_16, 16, 62624},
       {gouraud_24, 16, 72864},
       {gouraud_24_larger, 7, 49864},
       {span_gouraud, 1, 38240},
       {span_gouraud, 16, 57440}}},
     158},
    {"tube",
     build_tube,
     {.width = 320, .height = 240, .vertices = 320, .shades = 320, .polygons = 220, .fans = 16, .active = 44},
     0,
     Pool::none,
     {{{gouraud_16, 16, 41632},
       {gouraud_16, 240, 313160},
       {gouraud_24, 16, 51872},
       {gouraud_24_larger, 7, 28872},
       {span_gouraud, 1, 14048},
       {span_gouraud, 240, 319968}}},
     49},
    // For boards with 16 KB of RAM.
    {"torus-small",
     build_mesh<torus, ShadingMode::flat>,
     {.width = 128, .height = 128, .vertices = 288, .polygons = 272, .active = 52},
     0,
     Pool::none,
     {{{flat_16, 1, 9520},
       {flat_16, 4, 11632},
       {flat_16_larger, 1, 9520},
       {gouraud_24, 1, 11568},
       {gouraud_24, 128, 102776},
       {span_flat, 1, 10352}}},
     54},
    {"torus-colours-small",
     build_mesh<coloured_torus, ShadingMode::gouraud>,
     {.width = 128, .height = 128, .vertices = 288, .shades = 288, .polygons = 272, .active = 52},
     0,
     Pool::none,
     {{{gouraud_16, 1, 12464}, {gouraud_16, 2, 13104}, {gouraud_24, 1, 12720}, {span_gouraud, 1, 13360}}},
     54},
    {"torus-ortho-small",
     build_ortho_torus,
     {.width = 128, .height = 128, .vertices = 288, .shades = 288, .polygons = 288, .active = 48},
     0,
     Pool::none,
     {{{gouraud_16, 1, 12080}, {gouraud_24_larger, 1, 12336}, {span_gouraud, 2, 14704}}},
     60},
    {"inside-out-small",
     build_inside_out,
     {.width = 128, .height = 128, .vertices = 288, .polygons = 312, .active = 60},
     0,
     Pool::none,
     {{{flat_16, 1, 10320}, {flat_16_larger, 1, 10320}, {gouraud_24, 1, 12624}}}},
    {"tube-small",
     build_tube,
     {.width = 128, .height = 128, .vertices = 296, .shades = 296, .polygons = 200, .fans = 4, .active = 36},
     0,
     Pool::none,
     {{{gouraud_16, 1, 10520}, {gouraud_24, 1, 10776}}}},
    // 300 polygons at 320 × 240 in the memory of two lines: what a board with 16 KB draws without a depth buffer.
    {"torus-in-two-lines",
     build_inside_out,
     {.width = 320, .height = 240, .vertices = 288, .polygons = 320},
     0,
     Pool::none,
     {{{gouraud_24, 240, 465464}, {span_flat, 1, 11440}}},
     53},
    // And for a board with 8 KB.
    {"prisms-in-two-lines",
     build_prisms,
     {.width = 160, .height = 120, .vertices = 66, .polygons = 60, .fans = 56},
     0,
     Pool::none,
     {{{gouraud_24, 120, 117608}, {span_flat, 1, 5520}}},
     24},
    // What lies behind shows: by mixing, by patterns, by adding.
    {"glass",
     build_glass,
     {.width = 320,
      .height = 240,
      .instances = 4,
      .vertices = 930,
      .shades = 864,
      .polygons = 2000,
      .fans = 112,
      .active = 276,
      .fragments = 9700},
     0,
     Pool::none,
     {{{layers_16, 16, 175096},
       {layers_24, 16, 224136},
       {layers_24, 7, 195376},
       {span_layers, 1, 91336},
       {span_layers, 16, 110536}}},
     240},
    // Textures, fog and dither, holes, and opacities that vary.
    {"surfaces",
     build_surfaces,
     {.width = 160,
      .height = 120,
      .instances = 4,
      .vertices = 16,
      .shades = 8,
      .textures = 16,
      .polygons = 8,
      .active = 8,
      .fragments = 3600},
     0,
     Pool::none,
     {{{surfaces_24, 16, 73360}, {span_surfaces, 120, 83672}}},
     8},
    // Textures by their fast forms; in fog as well. The bands are high, so that boards of 64 KB leave them out: their
    // flash has no room for two renderers more.
    {"walls",
     build_walls<false>,
     {.width = 320,
      .height = 240,
      .instances = 3,
      .vertices = 12,
      .shades = 4,
      .textures = 12,
      .polygons = 16,
      .active = 16},
     0,
     Pool::none,
     {{{textures_16, 64, 128560}, {textures_16, 240, 310000}, {span_textures, 64, 88392}}},
     16},
    {"walls-in-fog",
     build_walls<true>,
     {.width = 320,
      .height = 240,
      .instances = 3,
      .vertices = 12,
      .shades = 4,
      .textures = 12,
      .polygons = 16,
      .active = 16},
     0,
     Pool::none,
     {{{textures_16, 64, 128560}, {textures_16, 57, 115128}, {span_textures, 64, 88392}}},
     16},
    {"prisms-small",
     build_prisms,
     {.width = 128, .height = 128, .vertices = 66, .polygons = 56, .fans = 56, .active = 24},
     0,
     Pool::none,
     {{{flat_16, 7, 9592}, {gouraud_16, 1, 6096}, {gouraud_24, 7, 12280}, {span_flat, 1, 5296}}},
     23},
    {"lights-small",
     build_lights<ShadingMode::flat>,
     {.width = 128, .height = 128, .vertices = 288, .polygons = 272, .active = 58},
     0,
     Pool::none,
     {{{flat_16, 4, 12112}, {gouraud_24, 1, 12240}}}},
    {"lights-smooth-small",
     build_lights<ShadingMode::gouraud>,
     {.width = 128, .height = 128, .vertices = 288, .shades = 288, .polygons = 272, .active = 58},
     0,
     Pool::none,
     {{{gouraud_16, 1, 13136}, {swapped_16, 1, 13136}}}},
    {"chain-small",
     build_chain,
     {.width = 128, .height = 128, .instances = 2, .vertices = 576, .shades = 288, .polygons = 528, .active = 68},
     0,
     Pool::none,
     {{{gouraud_16, 1, 17960}, {gouraud_24, 1, 18216}, {span_gouraud, 1, 21416}}},
     88},
    // Pools that run full: what fits is drawn, the same on every machine.
    {"no-room-polygons",
     build_mesh<torus, ShadingMode::flat>,
     {.width = 128, .height = 128, .vertices = 288, .polygons = 150, .active = 52},
     0,
     Pool::polygons,
     {{{gouraud_16, 1, 10824}, {gouraud_24, 1, 11080}, {span_gouraud, 1, 9160}}},
     34},
    {"no-room-active",
     build_mesh<torus, ShadingMode::gouraud>,
     {.width = 128, .height = 128, .vertices = 288, .shades = 288, .polygons = 272, .active = 12},
     0,
     Pool::active,
     {{{gouraud_16, 1, 7984}, {gouraud_16, 2, 8624}, {gouraud_24, 1, 8240}, {span_gouraud, 1, 7984}}},
     12},
    {"no-room-layers",
     build_glass,
     {.width = 128,
      .height = 128,
      .instances = 4,
      .vertices = 930,
      .shades = 864,
      .polygons = 2000,
      .fans = 112,
      .active = 276,
      .fragments = 300},
     0,
     Pool::fragments,
     {{{layers_16, 16, 75304}, {layers_24, 1, 61640}}}},
    {"no-room-vertices",
     build_chain,
     {.width = 128, .height = 128, .instances = 2, .vertices = 400, .shades = 288, .polygons = 528, .active = 68},
     0,
     Pool::vertices,
     {{{gouraud_16, 1, 16552}, {gouraud_24, 1, 16808}}}},
    {"no-room-fans",
     build_prisms,
     {.width = 128, .height = 128, .vertices = 66, .polygons = 56, .fans = 20, .active = 24},
     0,
     Pool::fans,
     {{{gouraud_16, 1, 5736}, {gouraud_24, 1, 5992}}}},
};

}  // namespace selftest_detail

/// Every scene of the self-test and how it is drawn.
inline constexpr std::span<const SelftestScene> selftest_scenes{selftest_detail::scenes};

/// Calls `visit(scene, run)` for every run of the table that a machine with `memory` bytes to spare draws.
template <class Visit>
constexpr void for_each_selftest_run(std::uint32_t memory, Visit&& visit) {
  for (const SelftestScene& scene : selftest_scenes)
    for (const SelftestRun& run : scene.runs)
      if (run.band != 0 && run.memory <= memory) visit(scene, run);
}

/// Whether a machine with `memory` bytes to spare draws a scene whose name begins so: models take much flash.
[[nodiscard]] constexpr bool selftest_shows(std::string_view name, std::uint32_t memory) {
  bool shown = false;
  for_each_selftest_run(memory, [&](const SelftestScene& scene, const SelftestRun&) {
    shown = shown || std::string_view(scene.name).starts_with(name);
  });
  return shown;
}

/// Whether a machine with `memory` bytes to spare draws anything with this renderer.
[[nodiscard]] constexpr bool selftest_uses(SelftestRenderer renderer, std::uint32_t memory) {
  bool used = false;
  for_each_selftest_run(memory,
                        [&](const SelftestScene&, const SelftestRun& run) { used = used || run.renderer == renderer; });
  return used;
}

}  // namespace spanline::scenes
