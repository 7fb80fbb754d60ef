#pragma once
#include <algorithm>
#include <bunny.hpp>
#include <cstddef>
#include <cstdint>
#include <span>
#include <spanline/frame/ready_made_traits.hpp>
#include <spanline/model/cull.hpp>
#include <spanline/visibility/registry.hpp>
#include <type_traits>

#include "board.hpp"
#include "measured_frame.hpp"
#include "scenes/model_view.hpp"
#include "scenes/room_mesh.hpp"
#include "scenes/screen_soups.hpp"
#include "scenes/sorting_scenes.hpp"
#include "scenes/textured_wall.hpp"

/// The benchmark's cases that every visibility algorithm draws.
namespace spanline::bench {

constexpr std::uint32_t most_triangles = 60'000;
constexpr std::uint32_t most_a_call = 32'767;  // that a 32-bit core takes

alignas(8) inline std::byte memory[1'200'000];
inline ScreenVertex soup_vertices[3 * most_triangles];
inline std::uint16_t soup_colours[most_triangles];
inline ScreenVertex square_vertices[4000];
inline std::uint16_t square_colours[1000];
inline std::uint8_t square_corners[1000];

inline void print(const char* scene, const char* visibility, int depth, unsigned band, std::uint32_t instructions,
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
void measure(const char* scene, const char* visibility, const Capacity& capacity, unsigned band, Submit submit) {
  const measured::Frame frame = measured::warm_frame<Traits>(capacity, band, memory, submit);
  if (!frame.complete) board::write("bench: a pool is full\n");
  print(scene, visibility, Traits::Depth::bits, band, frame.instructions, frame.crc, frame.peak_bytes);
}

/// Triangles on screen, which `make` puts into its table.
template <class Traits, class Make>
void soup(const char* name, const char* visibility, Capacity capacity, unsigned band, const Material& material,
          Make make) {
  const std::uint32_t triangles = capacity.polygons;
  capacity.instances = (triangles + most_a_call - 1) / most_a_call;
  const scenes::ScreenSoup target{std::span(soup_vertices).first(3 * triangles),
                                  std::span(soup_colours).first(triangles)};
  make(target);
  measure<Traits>(name, visibility, capacity, band, [&](auto& renderer) {
    FrameSettings settings;
    settings.cull = Cull::none;
    (void)renderer.begin(settings);
    for (std::uint32_t first = 0; first < triangles; first += most_a_call) {
      const std::uint32_t count = std::min(triangles - first, most_a_call);
      const Status added = renderer.add_screen(target.vertices.subspan(std::size_t{3} * first, std::size_t{3} * count),
                                               target.colours.subspan(first, count), material);
      if (!added.ok()) board::write("bench: a pool is full\n");
    }
  });
}

/// The same of so many opaque triangles.
template <class Depth, class Visibility, class Make>
void opaque_soup(const char* name, const char* visibility, std::uint32_t triangles, unsigned band, Make make) {
  soup<FlatTraits<Rgb565, Depth, Visibility>>(name, visibility,
                                              {.polygons = triangles,
                                               .active = std::min<std::uint32_t>(triangles, 4'000),
                                               .awake = std::min<std::uint32_t>(triangles, 600),
                                               .members = std::min<std::uint32_t>(triangles, 12'000)},
                                              band, {}, make);
}

template <class Depth, class Visibility>
void soups(const char* visibility, unsigned band) {
  const auto soup = [&](const char* name, std::uint32_t triangles, auto make) {
    opaque_soup<Depth, Visibility>(name, visibility, triangles, band, make);
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

/// P100, P500 and LAND, and lecture 003's table: T100, T2500 and T60000, whose triangles shrink as their number grows
/// and cover every pixel up to twice on average.
template <class Depth, class Visibility>
void sorting_soups(const char* visibility, unsigned band) {
  const auto soup = [&](const char* name, std::uint32_t triangles, auto make) {
    opaque_soup<Depth, Visibility>(name, visibility, triangles, band, make);
  };
  const auto penetrating_triangles = [&](const char* name, std::uint32_t leg, std::uint32_t count) {
    soup(name, count,
         [=](scenes::ScreenSoup target) { scenes::make_penetrating_triangles(leg, count, Depth::bits, target); });
  };
  const auto shrinking_triangles = [&](const char* name, std::uint32_t count) {
    const std::uint32_t leg = scenes::even_cover_leg(2, count, 320, 240);
    soup(name, count, [=](scenes::ScreenSoup target) { scenes::make_even_cover(leg, 320, 240, Depth::bits, target); });
  };
  penetrating_triangles("P100", 128, 100);
  penetrating_triangles("P500", 32, 500);
  soup("LAND", scenes::landscape::triangles,
       [](scenes::ScreenSoup target) { scenes::landscape::make(Depth::bits, target); });
  shrinking_triangles("T100", 100);
  shrinking_triangles("T2500", 2'500);
  shrinking_triangles("T60000", 60'000);
}

/// R8 and R32: squares as they are, and as two triangles each (R8T, R32T).
template <class Depth, class Visibility>
void squares(const char* visibility, unsigned band) {
  using Traits = FlatTraits<Rgb565, Depth, Visibility>;
  FrameSettings settings;
  settings.cull = Cull::none;
  const auto measure_squares = [&](const char* name, const char* name_of_triangles, std::uint32_t leg,
                                   std::uint32_t count) {
    const scenes::ScreenSoup whole{std::span(square_vertices).first(4 * count), std::span(square_colours).first(count)};
    const auto corners = std::span(square_corners).first(count);
    scenes::make_squares(leg, Depth::bits, whole);
    std::fill(corners.begin(), corners.end(), static_cast<std::uint8_t>(4 | Mesh::planar));
    Capacity capacity{.polygons = 2 * count, .fans = 2 * count, .active = 600, .awake = 600, .members = 2 * count};
    soup<Traits>(name_of_triangles, visibility, capacity, band, {},
                 [&](scenes::ScreenSoup triangles) { scenes::cut_squares(whole, triangles); });
    capacity.polygons = count;
    measure<Traits>(name, visibility, capacity, band, [&](auto& renderer) {
      (void)renderer.begin(settings);
      if (!renderer.add_screen(whole.vertices, corners, whole.colours, {}).ok())
        board::write("bench: a pool is full\n");
    });
  };
  measure_squares("R8", "R8T", 8, 1000);
  measure_squares("R32", "R32T", 32, 250);
}

template <class Traits>
void model(const char* name, const char* visibility, ShadingMode shading, unsigned band) {
  const Mesh& mesh = spanline_models::bunny;
  const auto vertices = static_cast<std::uint32_t>(mesh.vertex_count());
  const scenes::ModelView view = scenes::model_view(mesh, Angle::from_degrees(30), 240, shading);
  measure<Traits>(name, visibility,
                  {.vertices = vertices,
                   .shades = shading == ShadingMode::gouraud ? vertices : 0,
                   .polygons = 1600,
                   .active = 128,
                   .awake = 128,
                   .members = 1000},
                  band, [&](auto& renderer) {
                    (void)renderer.begin(view.settings);
                    if (!renderer.add(mesh, view.transform, view.material).ok())
                      board::write("bench: a pool is full\n");
                  });
}

/// BALL.
template <class Traits>
void half_ball(const char* visibility, unsigned band) {
  namespace scene = scenes::ball;
  measure<Traits>("BALL", visibility,
                  {.vertices = static_cast<std::uint32_t>(scene::mesh.vertex_count()),
                   .polygons = static_cast<std::uint32_t>(scene::mesh.polygon_count()),
                   .active = 400,
                   .awake = 400,
                   .members = 1600},
                  band, [&](auto& renderer) {
                    (void)renderer.begin(scene::settings());
                    if (!renderer.add(scene::mesh, {}, {}).ok()) board::write("bench: a pool is full\n");
                  });
}

template <class Traits>
void wall(const char* visibility, unsigned band) {
  namespace scene = scenes::textured_wall;
  measure<Traits>("S6", visibility,
                  {.vertices = 4, .textures = 4, .polygons = 2, .active = 2, .awake = 2, .members = 2}, band,
                  [&](auto& renderer) {
                    (void)renderer.begin(scene::settings());
                    if (!renderer.add(scene::mesh, {}, scene::material).ok()) board::write("bench: a pool is full\n");
                  });
}

/// ROOM: quads as they are, and as two triangles each (ROOMT).
template <class Traits>
void room(const char* visibility, unsigned band) {
  const FrameSettings settings = scenes::room_settings(Angle::from_degrees(20), 240);
  const auto measure_room = [&](const char* name, const Mesh& mesh) {
    measure<Traits>(
        name, visibility,
        {.vertices = 400, .textures = 400, .polygons = 200, .fans = 200, .active = 100, .awake = 100, .members = 200},
        band, [&](auto& renderer) {
          (void)renderer.begin(settings);
          if (!renderer.add(mesh, {}, scenes::room_material).ok()) board::write("bench: a pool is full\n");
        });
  };
  measure_room("ROOM", scenes::room);
  measure_room("ROOMT", scenes::room_of_triangles);
}

/// The cases of one algorithm, at 16 or 24 bits of depth, in bands of so many lines or in one (0): each in a
/// translation unit of its own, which the build makes of bench_by.cpp.in. 16 bits are for those that have them by
/// default.
template <AlgorithmId Unit>
void draw_cases(const char* visibility, int depth_bits, unsigned band);
/// Further cases, with the depths that the algorithm has by default, likewise.
template <AlgorithmId Unit>
void draw_sorting_cases(const char* visibility, unsigned band);
#define SPANLINE_ALGORITHM(id, ...)                                                        \
  template <>                                                                              \
  void draw_cases<AlgorithmId::id>(const char* visibility, int depth_bits, unsigned band); \
  template <>                                                                              \
  void draw_sorting_cases<AlgorithmId::id>(const char* visibility, unsigned band);
#include "spanline/visibility/algorithms.def"

template <class Depth, class Visibility, AlgorithmId Unit>
void draw_cases_at(const char* visibility, unsigned band) {
  if constexpr (entry_of(Unit).needs == AlgorithmNeeds::screen_polygons) {
    soups<Depth, Visibility>(visibility, band);
    squares<Depth, Visibility>(visibility, band);
  }
  model<FlatTraits<Rgb565, Depth, Visibility>>("S4", visibility, ShadingMode::flat, band);
  model<GouraudTraits<Rgb565, Depth, Visibility>>("S5", visibility, ShadingMode::gouraud, band);
  wall<TextureTraits<Rgb565, Depth, Visibility>>(visibility, band);
  room<TextureTraits<Rgb565, Depth, Visibility>>(visibility, band);
}

template <class Visibility, AlgorithmId Unit>
void draw_cases_by(const char* visibility, int depth_bits, unsigned band) {
  if constexpr (entry_of(Unit).depth_bits == 16) {
    if (depth_bits == 16) return draw_cases_at<Depth16<>, Visibility, Unit>(visibility, band);
  }
  draw_cases_at<Depth24<>, Visibility, Unit>(visibility, band);
}

template <class Visibility, AlgorithmId Unit>
void draw_sorting_cases_by(const char* visibility, unsigned band) {
  using Depth = std::conditional_t<entry_of(Unit).depth_bits == 16, Depth16<>, Depth24<>>;
  if constexpr (entry_of(Unit).takes_screen_polygons()) sorting_soups<Depth, Visibility>(visibility, band);
  half_ball<FlatTraits<Rgb565, Depth, Visibility>>(visibility, band);
}

}  // namespace spanline::bench
