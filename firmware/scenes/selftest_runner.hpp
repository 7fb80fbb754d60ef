#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <type_traits>

#include "scenes/crc32.hpp"
#include "scenes/selftest_result.hpp"
#include "scenes/selftest_table.hpp"
#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/frame/renderer.hpp"
#include "spanline/memory/arena.hpp"

namespace spanline::scenes {

namespace selftest_detail {

/// Textures with every kind of light that the scenes have.
template <class Depth, class Visibility = ZBuffer>
using TexturesOnly =
    RendererTraits<Rgb565,
                   ShaderList<GouraudShader<Rgb565>, NearestTextureShader<Rgb565, TexelFormat::rgb565, NoTexelLight>,
                              NearestTextureShader<Rgb565, TexelFormat::rgb565, GouraudTexelLight>,
                              FoggedTextureShader<Rgb565, TexelFormat::rgb565>>,
                   Depth, Visibility>;

/// Where a run's objects lie in the memory that it gets.
template <class Traits>
struct Layout {
  std::span<SelftestContent> content;
  std::span<SelftestContent::Instance> instances;
  std::span<ScreenVertex> soup_vertices;
  std::span<std::uint16_t> soup_colours;
  std::span<std::byte> renderer;
  std::span<std::byte> pools;

  static constexpr Capacity capacity(const SelftestScene& scene, std::uint16_t band) {
    Capacity wanted = scene.capacity;
    wanted.band_lines = band;
    if (std::is_same_v<typename Traits::Visibility, Spanning>) {
      wanted.awake = scene.awake;
      if (wanted.fragments != 0) wanted.layers = scene.awake;
      return wanted;
    }
    if (band == wanted.height) wanted.colour_bands = 1;
    if (!std::is_same_v<typename Traits::Visibility, ZBuffer>) {
      // By rule (selftest_registry.hpp): what pools may hold at most, since nobody has stated less.
      wanted.active = wanted.awake = wanted.members = wanted.polygons;
      if (wanted.fragments != 0) wanted.layers = wanted.polygons;
      if constexpr (requires { BandDrawer<Traits>::Visibility::most_layers; })
        wanted.layers = std::min(wanted.layers, BandDrawer<Traits>::Visibility::most_layers);
    } else if (band == wanted.height) {
      wanted.active = 0;
    }
    return wanted;
  }
  constexpr void take(Arena& arena, const SelftestScene& scene, std::uint16_t band) {
    content = arena.take<SelftestContent>(1);
    instances = arena.take<SelftestContent::Instance>(scene.soup_triangles != 0 ? 0 : scene.capacity.instances);
    soup_vertices = arena.take<ScreenVertex>(std::size_t{3} * scene.soup_triangles);
    soup_colours = arena.take<std::uint16_t>(scene.soup_triangles);
    renderer = arena.take<std::byte>(sizeof(Renderer<Traits>));
    pools = arena.take<std::byte>(Renderer<Traits>::bytes_needed(capacity(scene, band)));
  }
};

template <class Traits>
constexpr std::size_t bytes(const SelftestScene& scene, std::uint16_t band) {
  Arena counting;
  Layout<Traits>().take(counting, scene, band);
  return counting.size();
}

/// Keeps the first failure.
inline void note(SelftestResult& result, Status status) {
  if (result.status.ok()) result.status = status;
}

/// `memory` is aligned as Arena wants it and large enough. Not inlined: the caller's frame would be that of all
/// renderers together.
template <class Traits, class See>
[[gnu::noinline]] SelftestResult draw(const SelftestScene& scene, std::uint16_t band, const SelftestModels& models,
                                      std::span<std::byte> memory, See&& see) {
  using Picture = Renderer<Traits>;
  static_assert(alignof(Picture) <= Arena::alignment);
  Arena arena(memory);
  Layout<Traits> place;
  place.take(arena, scene, band);
  const Capacity capacity = place.capacity(scene, band);
  SelftestContent& content = place.content.front();
  content.instances = place.instances;
  content.soup = {place.soup_vertices, place.soup_colours};
  scene.build({models, capacity.width, capacity.height, Traits::Depth::bits}, content);

  Picture& renderer = *new (static_cast<void*>(place.renderer.data())) Picture(capacity, place.pools);
  SelftestResult result;
  note(result, renderer.begin(content.settings));
  if (scene.soup_triangles != 0) note(result, renderer.add_screen(content.soup.vertices, content.soup.colours));
  for (std::uint32_t i = 0; i < content.instance_count; ++i) {
    const SelftestContent::Instance& instance = content.instances[i];
    note(result, renderer.add(*instance.mesh, instance.transform, instance.material));
  }
  const PolygonCounts& counts = renderer.statistics().polygons;
  result.drawn = counts.total - counts.outside - counts.back;
  Crc32 crc, depth;
  note(result, renderer.draw([&](const auto& finished) {
    for (const auto pixel : finished.pixels) crc.add(pixel);
    for (const auto word : finished.depth) depth.add(word);
    see(finished);
    return true;
  }));
  result.crc = crc.value();
  result.depth = depth.value();
  return result;
}

/// f.template operator()<Traits>(), which is not linked where no run for `Memory` bytes wants it.
template <std::uint32_t Memory, SelftestRenderer Kind, class Traits, class F>
constexpr auto call(F& f) {
  if constexpr (selftest_uses(Kind, Memory))
    return f.template operator()<Traits>();
  else
    return decltype(f.template operator()<Traits>()){};
}

/// The general shader, opaque and see-through.
template <class Visibility>
using SurfaceTraits = RendererTraits<
    Rgb565, ShaderList<FlatShader<Rgb565>, GeneralShader<Rgb565>, SeeThroughShader<Rgb565, TranslucentShader<Rgb565>>>,
    Depth24<>, Visibility>;

/// Calls f.template operator()<Traits>() for the renderer. F names its result type.
template <std::uint32_t Memory, class F>
constexpr auto with_traits(SelftestRenderer renderer, F&& f) {
  using enum SelftestRenderer;
  constexpr DepthSense larger = DepthSense::larger_is_nearer;
  switch (renderer) {
    case flat_16:
      return call<Memory, flat_16, FlatTraits<Rgb565, Depth16<>>>(f);
    case flat_16_larger:
      return call<Memory, flat_16_larger, FlatTraits<Rgb565, Depth16<larger>>>(f);
    case gouraud_16:
      return call<Memory, gouraud_16, GouraudTraits<Rgb565, Depth16<>>>(f);
    case swapped_16:
      return call<Memory, swapped_16, GouraudTraits<Rgb565Swapped, Depth16<>>>(f);
    case gouraud_24:
      return call<Memory, gouraud_24, GouraudTraits<Rgb565, Depth24<>>>(f);
    case span_flat:
      return call<Memory, span_flat, FlatTraits<Rgb565, Depth24<>, Spanning>>(f);
    case span_gouraud:
      return call<Memory, span_gouraud, GouraudTraits<Rgb565, Depth24<>, Spanning>>(f);
    case layers_16:
      return call<Memory, layers_16, SeeThroughTraits<Rgb565, Depth16<>>>(f);
    case layers_24:
      return call<Memory, layers_24, SeeThroughTraits<Rgb565, Depth24<>>>(f);
    case span_layers:
      return call<Memory, span_layers, SeeThroughTraits<Rgb565, Depth24<>, Spanning>>(f);
    case surfaces_24:
      return call<Memory, surfaces_24, SurfaceTraits<ZBuffer>>(f);
    case span_surfaces:
      return call<Memory, span_surfaces, SurfaceTraits<Spanning>>(f);
    case textures_16:
      return call<Memory, textures_16, TexturesOnly<Depth16<>>>(f);
    case span_textures:
      return call<Memory, span_textures, TexturesOnly<Depth24<>, Spanning>>(f);
    case sort_flat:
      return call<Memory, sort_flat, FlatTraits<Rgb565, Depth24<>, DepthSort>>(f);
    case gouraud_24_larger:
      break;
  }
  return call<Memory, gouraud_24_larger, GouraudTraits<Rgb565, Depth24<larger>>>(f);
}

}  // namespace selftest_detail

/// Bytes that a run takes on this machine.
[[nodiscard]] constexpr std::size_t selftest_bytes(const SelftestScene& scene, const SelftestRun& run) {
  return selftest_detail::with_traits<0xffffffff>(
      run.renderer, [&]<class Traits>() -> std::size_t { return selftest_detail::bytes<Traits>(scene, run.band); });
}

/// Whether a run went as its scene means it to go.
[[nodiscard]] constexpr bool as_expected(const SelftestScene& scene, Status status) {
  if (scene.starved == Pool::none) return status.ok();
  // What z-buffers keep of polygons that go on below a band, `span` keeps of those that are awake on a row.
  const Pool named = status.pool == Pool::awake ? Pool::active : status.pool;
  return status.fault == Fault::pool_full && named == scene.starved;
}

/// The visibility algorithm of a run.
[[nodiscard]] constexpr const char* visibility_of(const SelftestScene& scene, const SelftestRun& run) {
  if (is_spanning(run.renderer)) return "span";
  if (run.renderer == SelftestRenderer::sort_flat) return "depth-sort";
  return run.band == scene.capacity.height ? "zbuffer" : "scanline-z";
}

/// Draws a scene in `memory`, which has `selftest_bytes` bytes and an alignment of Arena::alignment. `see` gets each
/// band when it is finished. Renderers that no run for a machine with `Memory` bytes wants are not linked.
template <std::uint32_t Memory, class See>
SelftestResult draw_selftest(const SelftestScene& scene, const SelftestRun& run, const SelftestModels& models,
                             std::span<std::byte> memory, See&& see) {
  return selftest_detail::with_traits<Memory>(run.renderer, [&]<class Traits>() -> SelftestResult {
    return selftest_detail::draw<Traits>(scene, run.band, models, memory, see);
  });
}

/// Whether the table says enough memory for each run; a question for 32-bit machines.
[[nodiscard]] consteval bool selftest_memory_is_stated() {
  bool enough = true;
  for_each_selftest_run(0xffffffff, [&](const SelftestScene& scene, const SelftestRun& run) {
    enough = enough && selftest_bytes(scene, run) <= run.memory;
  });
  return enough;
}
static_assert(sizeof(void*) > 4 || selftest_memory_is_stated());

}  // namespace spanline::scenes
