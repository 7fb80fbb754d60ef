#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <type_traits>

#include "spanline/frame/arena.hpp"
#include "spanline/frame/band_drawer.hpp"
#include "spanline/frame/capacity.hpp"
#include "spanline/frame/status.hpp"
#include "spanline/frame/traits.hpp"
#include "spanline/geometry/instance.hpp"
#include "spanline/geometry/polygon_assembly.hpp"
#include "spanline/model/camera.hpp"
#include "spanline/model/fog.hpp"
#include "spanline/shade/lighting.hpp"

namespace spanline {

template <class Traits>
class BandPartner;

/// What a frame shows besides its instances.
struct FrameSettings {
  Camera camera{};
  Lighting lighting{};
  Rgb888 background{0, 0, 0};
  Cull cull = Cull::back;
  std::uint8_t stipple_seed = 0;  ///< [0, 127]: of materials that are seen through by random patterns
  Fog fog{};                      ///< for renderers with the general shader
  bool dither = false;            ///< ordered dither, likewise
};

/// Numbers of a frame (design: the lectures' sets P, F, B; and what visibility did, where the traits count it).
struct Statistics {
  PolygonCounts polygons;
  VisibilityCounters visibility;
};

/// The front door: takes a frame's instances, then draws it band by band.
///
///     Renderer<FlatTraits<>> renderer(capacity, memory);
///     renderer.begin(settings);
///     renderer.add(mesh, transform, material);   // as many as there are
///     renderer.draw([&](const auto& band) { send(band); return true; });
///
/// It owns no memory: `bytes_needed` bytes are the caller's, and so are the tables of meshes and lights, which must
/// stay until `draw` has returned. Nothing is allocated. The order of submission settles ties.
template <class Traits>
class Renderer {
 public:
  using Depth = typename Traits::Depth;
  using DepthWord = typename Depth::Word;
  using Format = typename Traits::Format;
  using Pixel = typename Format::Pixel;
  using Shaders = typename Traits::Shaders;
  using BandView = typename BandDrawer<Traits>::BandView;

  /// Bytes that a configuration takes of the caller's memory, alignment included.
  [[nodiscard]] static constexpr std::size_t bytes_needed(const Capacity& capacity) {
    Arena counting;
    Pools pools;
    typename BandDrawer<Traits>::Pools bands;
    pools.take(counting, capacity);
    bands.take(counting, capacity);
    return counting.size() + Arena::alignment - 1;
  }

  /// Divides `memory` into pools. `status()` tells whether it was enough and the capacity valid; if not, the renderer
  /// refuses every frame.
  Renderer(const Capacity& capacity, std::span<std::byte> memory) : drawer_(capacity, {}) {
    const bool links_fit = capacity.polygons < no_link && capacity.fans < fan_flag && capacity.instances < no_link &&
                           Visibility::takes(capacity);
    if (!capacity.valid() || !links_fit) {
      status_ = {Fault::bad_configuration, Pool::none, 0};
      return;
    }
    Arena arena = Arena::aligned(memory);
    typename BandDrawer<Traits>::Pools bands;
    pools_.take(arena, capacity);
    bands.take(arena, capacity);
    if (arena.overrun()) {
      status_ = {Fault::pool_full, Pool::memory, static_cast<std::uint32_t>(bytes_needed(capacity))};
      return;
    }
    table_.references = pools_.references;
    table_.fans = pools_.fans;
    table_.groups = pools_.groups;
    table_.buckets = pools_.buckets;
    drawer_ = BandDrawer<Traits>(capacity, bands);
    bucket_of_row_ = BandOfRow(Visibility::bucket_lines(capacity));
  }

  [[nodiscard]] Status status() const { return status_; }

  /// Starts a frame. Fails for a camera whose planes or focal length are out of range, and draws nothing then.
  Status begin(const FrameSettings& settings) {
    ready_ = false;
    drawer_.forget_clears();
    table_.clear();
    statistics_ = {};
    peaks_ = {};
    used_ = {};
    if (!status_.ok()) return status_;
    if (!settings_valid(settings.camera)) return {Fault::bad_settings, Pool::none, 0};
    lighting_ = settings.lighting;
    cull_ = settings.cull;
    stipple_seed_ = settings.stipple_seed;
    effects_wanted_ = settings.fog.curve != FogCurve::none || settings.dither;
    dither_wanted_ = settings.dither;
    background_ = Format::from(settings.background);
    prepare_effects(settings);
    view_ = {settings.camera, viewport(), Depth::bits, Depth::nearest, Depth::farthest};
    ready_ = true;
    return {};
  }

  /// Adds an instance of a validated mesh; the Mesh object itself must stay until `draw` has returned. Where a pool is
  /// full what fits is kept, and the status names the pool and the size that the frame has wanted so far.
  Status add(const Mesh& mesh, const Transform& transform, const Material& material) {
    if (!ready_) return status_.ok() ? Status{Fault::bad_settings, Pool::none, 0} : status_;
    const bool mapped = has_textures && material.texturing.lies_on(mesh);
    const bool relief = under_relief(mesh, material);
    const bool volume = material.volume.source != SolidSource::none;
    const bool textured = has_textures && (mapped || relief || volume);
    const bool local_light = material.shines() || !lighting_.point_lights.empty();
    const bool texels_have_alpha = mapped && has_alpha(material.texturing);
    const bool holes = texels_have_alpha && material.texturing.alpha == TexelAlpha::cut_out;
    const bool varies = varying_opacity(mesh) || (texels_have_alpha && !holes);
    const std::uint8_t shader = shader_for<Traits>(material, {!mesh.vertex_colours.empty(), textured, effects_wanted_,
                                                              varies, local_light, relief, volume, dither_wanted_});
    const std::uint32_t first_id = used_.ids;
    used_.ids += static_cast<std::uint32_t>(mesh.triangle_count());
    // Opacities of vertices go with the group's own light.
    if (shader >= Shaders::count || (local_light && varying_opacity(mesh)))
      return {Fault::shader_missing, Pool::none, 0};
    // An algorithm that decides by whole spans cannot look through holes, unless it has layers.
    if (!Visibility::tests_depth && !Shaders::see_through && holes) return {Fault::shader_missing, Pool::none, 0};

    const InstanceGeometry geometry(view_, mesh, transform);
    if (geometry.placement() == Placement::outside) {
      statistics_.polygons.total += static_cast<std::uint32_t>(mesh.triangle_count());
      statistics_.polygons.outside += static_cast<std::uint32_t>(mesh.triangle_count());
      return {};
    }
    const bool shaded = needs_shades(mesh, material);
    if (const Status room = reserve(mesh, shaded, textured); !room.ok()) return room;

    const Link number = table_.group_count++;
    PolygonGroup& group = table_.groups[number];
    ShadingGroup& shading = pools_.shading[number];
    VertexStore store{
        pools_.vertices.subspan(used_.vertices),
        shaded ? pools_.shades.subspan(used_.shades) : std::span<std::uint32_t>{},
        textured ? pools_.textures.subspan(used_.textures) : std::span<TextureVertex>{},
        has_volumes && volume ? pools_.third_coordinates.subspan(used_.textures) : std::span<std::int32_t>{},
        static_cast<Link>(mesh.vertex_count()),
        0};
    group = {store.vertices.data(),
             mesh.indices.data(),
             table_.polygon_count,
             first_id,
             geometry.placement() != Placement::inside,
             Shaders::see_through && (holes || varies || is_see_through(material)),
             holes};
    shading.clear();
    shading.mesh = &mesh;
    shading.vertex_shades = store.shades.data();
    shading.first_id = first_id;
    shading.colour = LitColour::from(material.colour);
    shading.shader = shader;
    describe_surface(mesh, transform, material, number, textured, local_light, store, shading);
    if constexpr (Shaders::see_through) shading.layering = layering_of(material, number, stipple_seed_);
    set_lights(lighting_, transform, shading);
    if (shaded) prepare_shades(mesh, material, number, local_light, shading, store.shades.data());
    return assemble(mesh, transform, material, geometry, group, store);
  }

  /// Adds triangles that are on screen already: corners three by three (outcodes set where they leave the viewport),
  /// and a colour each in RGB565. Both tables must stay until `draw` has returned. For flat shading; of the material,
  /// opacity and transparency count. 32,767 triangles a call on 32-bit machines.
  Status add_screen(std::span<const ScreenVertex> vertices, std::span<const std::uint16_t> colours) {
    static constexpr Material opaque{};  // made once, not by each caller
    return add_screen(vertices, colours, opaque);
  }
  Status add_screen(std::span<const ScreenVertex> vertices, std::span<const std::uint16_t> colours,
                    const Material& material) {
    if (!ready_) return status_.ok() ? Status{Fault::bad_settings, Pool::none, 0} : status_;
    if (vertices.size() / 3 >= fan_flag) return {Fault::too_many_triangles, Pool::none, 0};
    const std::uint8_t shader = shader_for<Traits>(material, {});
    const std::uint32_t first_id = used_.ids;
    used_.ids += static_cast<std::uint32_t>(vertices.size() / 3);
    if (shader >= Shaders::count) return {Fault::shader_missing, Pool::none, 0};
    if (const Status room = reserve_group(); !room.ok()) return room;
    const Link number = table_.group_count++;
    table_.groups[number] = {vertices.data(), nullptr, table_.polygon_count,
                             first_id,        true,    Shaders::see_through && is_see_through(material)};
    ShadingGroup& shading = pools_.shading[number];
    shading.clear();
    shading.screen_colours = colours.data();
    shading.first_id = first_id;
    shading.shader = shader;
    if constexpr (Shaders::see_through) shading.layering = layering_of(material, number, stipple_seed_);
    PolygonAssembly assembly(table_, bucket_of_row_, viewport(), cull_);
    assembly.run_screen(vertices);
    return finish(assembly, 0, false, false);
  }

  /// For a FillingSink, between `begin` and `draw`: starts to clear the first band, while instances are added. False
  /// where the sink gives up, as it will for `draw`.
  template <class Sink>
  bool clear_ahead(Sink&& sink) {
    return !ready_ || drawer_.clear_ahead(scene(), 0, sink);
  }

  /// Draws the frame, top to bottom. For each band: `sink.acquire(buffer)` where the sink has it, which waits until
  /// that colour band is free again; then the drawing; then `sink(band)`. Either may return false to give the frame up.
  /// With statistics, `sink.covered(id)` is told of every triangle that covers a pixel centre, where the sink has it.
  template <class Sink>
  Status draw(Sink&& sink) {
    return draw_share(BandShare::all, sink);
  }
  /// Draws the bands 0, 2, 4, … alone, while a BandPartner draws the others.
  template <class Sink>
  Status draw_even(Sink&& sink) {
    return draw_share(BandShare::even, sink);
  }

  /// The steps of `draw`, for programs with a loop of their own (benchmarks): start, then for each band in order clear
  /// and draw, then end.
  void start_bands() { drawer_.start(BandShare::all); }
  void clear_band(std::uint32_t band) { drawer_.clear_band(scene(), band); }
  template <class Sink>
  BandView draw_band(std::uint32_t band, Sink& sink) {
    return drawer_.draw_band(scene(), band, sink);
  }
  Status end_bands() {
    note_peaks();
    return drawer_.end(scene());
  }

  /// The memory of a colour band, counted from 0, for present loops that hand it to a display; empty where the band
  /// does not exist. Frames use them in turn; with three and more the next frame goes on where the last one ended.
  [[nodiscard]] std::span<Pixel> colour_band(unsigned buffer) const { return drawer_.colour_band(buffer); }
  [[nodiscard]] const Statistics& statistics() const { return statistics_; }
  /// Of the last frame that was drawn.
  [[nodiscard]] const PoolPeaks& peaks() const { return peaks_; }
  [[nodiscard]] const Capacity& capacity() const { return drawer_.capacity(); }

 private:
  friend class BandPartner<Traits>;
  using Visibility = typename BandDrawer<Traits>::Visibility;
  static constexpr std::uint8_t general = Shaders::template index_of<GeneralShader<Format>>,
                                translucent = Shaders::first([]<class Shader>() { return Translucent<Shader>; });
  static constexpr bool has_ids = Shaders::template index_of<IdShader> < Shaders::count;
  static constexpr bool has_translucent = translucent < Shaders::count;
  static constexpr bool has_ramps = Shaders::template index_of<GouraudShader<Format>> < Shaders::count;
  static constexpr bool has_shades =
      has_ramps || has_translucent || Shaders::template index_of<GouraudColourShader<Format>> < Shaders::count;
  static constexpr bool has_textures =
      Shaders::first([]<class Shader>() { return DrawsTextures<ColourShader<Shader>>; }) < Shaders::count;
  static constexpr bool has_relief = Shaders::first([]<class Shader>() {
                                       return std::is_same_v<ColourShader<Shader>, ReliefShader<Format>>;
                                     }) < Shaders::count;
  static constexpr bool has_volumes =
      Shaders::first([]<class Shader>() { return DrawsVolumes<ColourShader<Shader>>; }) < Shaders::count;
  static constexpr bool has_pixelwise = has_relief || has_volumes;
  static constexpr bool has_effects =
      general < Shaders::count || has_translucent || has_pixelwise ||
      Shaders::first([]<class Shader>() { return Fogged<ColourShader<Shader>>; }) < Shaders::count;
  [[nodiscard]] static constexpr bool is_general(std::uint8_t shader) {
    if constexpr (has_translucent) {
      if (shader == translucent) return true;
    }
    return has_effects && shader == general;
  }
  [[nodiscard]] static bool under_relief(const Mesh& mesh, const Material& material) {
    return material.relief.heights != nullptr && !mesh.texture_coordinates.empty();
  }
  /// Whether vertices have opacities of their own, and there is a shader for them: others say so, or draw ids.
  [[nodiscard]] static bool varying_opacity(const Mesh& mesh) {
    if constexpr (has_ids) return false;
    return !mesh.vertex_opacities.empty();
  }
  [[nodiscard]] static vertex_shade::Kind kind_of_shades(const Mesh& mesh, const Material& material) {
    if (has_translucent && varying_opacity(mesh)) return vertex_shade::Kind::colour_and_opacity;
    return shade_kind(mesh, material);
  }
  static constexpr bool has_local_light = Shaders::template index_of<LocalFlatShader<Format>> < Shaders::count;
  struct NoEffects {};

  void prepare_effects([[maybe_unused]] const FrameSettings& settings) {
    if constexpr (has_effects) {
      effects_.fogged = settings.fog.curve != FogCurve::none;
      effects_.fog_colour = settings.fog.colour;
      effects_.dither = settings.dither;
      if (effects_.fogged) effects_.fog.fill(settings.fog, settings.camera);
    }
  }

  /// Every pool but the bands', in the order in which the arena cuts them.
  struct Pools {
    std::span<PolygonGroup> groups;
    std::span<ShadingGroup> shading;
    std::span<std::uint16_t> ramps;
    std::span<ScreenVertex> vertices;
    std::span<std::uint32_t> shades;
    std::span<TextureVertex> textures;
    std::span<std::int32_t> third_coordinates;
    std::span<TexturedGroup> textured;
    std::span<PixelwiseGroup> pixelwise;
    std::span<LocalLighting> local_lights;
    std::span<PolygonReference> references;
    std::span<FanTriangle> fans;
    std::span<Link> buckets;

    constexpr void take(Arena& arena, const Capacity& c) {
      groups = arena.take<PolygonGroup>(c.instances);
      shading = arena.take<ShadingGroup>(c.instances);
      ramps = arena.take<std::uint16_t>(has_ramps ? c.instances * gouraud::ramp_size : 0);
      vertices = arena.take<ScreenVertex>(c.vertices);
      shades = arena.take<std::uint32_t>(has_shades ? c.shades : 0);
      textures = arena.take<TextureVertex>(has_textures ? c.textures : 0);
      third_coordinates = arena.take<std::int32_t>(has_volumes ? c.textures : 0);
      textured = arena.take<TexturedGroup>(has_textures || has_local_light ? c.instances : 0);
      pixelwise = arena.take<PixelwiseGroup>(has_pixelwise ? c.instances : 0);
      local_lights = arena.take<LocalLighting>(has_local_light ? c.instances : 0);
      references = arena.take<PolygonReference>(c.polygons);
      fans = arena.take<FanTriangle>(c.fans);
      buckets = arena.take<Link>(bucket_count(c));
    }
  };

  /// How much of the pools the frame has taken.
  struct Used {
    std::uint32_t vertices = 0, shades = 0, textures = 0, ids = 0;
    std::uint32_t instances_wanted = 0, vertices_wanted = 0, shades_wanted = 0, textures_wanted = 0,
                  polygons_wanted = 0, fans_wanted = 0;  ///< and not found
  };

  [[nodiscard]] Viewport viewport() const { return {capacity().width, capacity().height}; }
  [[nodiscard]] static bool needs_shades(const Mesh& mesh, const Material& material) {
    if (has_translucent && varying_opacity(mesh)) return true;
    return has_shades && material.shading == ShadingMode::gouraud;
  }

  [[nodiscard]] static bool settings_valid(const Camera& camera) {
    const bool planes = camera.near_plane < camera.far_plane;
    return planes && camera.focal.raw() > 0 &&
           (camera.projection == Projection::orthographic || camera.near_plane.raw() > 0);
  }

  /// Buckets of the polygon table.
  [[nodiscard]] static constexpr std::uint32_t bucket_count(const Capacity& c) {
    const std::uint32_t lines = std::max<std::uint32_t>(1, Visibility::bucket_lines(c));
    return (c.height + lines - 1) / lines;
  }

  [[nodiscard]] BandScene<Pixel> scene() { return scene(table_, statistics_.visibility); }
  [[nodiscard]] BandScene<Pixel> scene(PolygonTable& table, VisibilityCounters& counters) const {
    return {table, pools_.shading, background_, &counters};
  }
  template <class Sink>
  Status draw_share(BandShare share, Sink& sink) {
    if (!ready_) return status_.ok() ? Status{Fault::bad_settings, Pool::none, 0} : status_;
    const Status drawn = drawer_.draw(scene(), share, sink);
    if (drawn.fault != Fault::sink_failed) note_peaks();
    return drawn;
  }

  /// Counts what does not fit, and says what would.
  static Status refuse(Pool pool, std::uint32_t& missing_so_far, std::size_t missing, std::size_t size) {
    missing_so_far += static_cast<std::uint32_t>(missing);
    return {Fault::pool_full, pool, static_cast<std::uint32_t>(size) + missing_so_far};
  }
  Status reserve_group() {
    if (table_.group_count < pools_.groups.size()) return {};
    return refuse(Pool::instances, used_.instances_wanted, 1, pools_.groups.size());
  }
  Status reserve(const Mesh& mesh, bool shaded, bool textured) {
    if (const Status room = reserve_group(); !room.ok()) return room;
    const std::size_t count = mesh.vertex_count();
    if (count > pools_.vertices.size() - used_.vertices)
      return refuse_all(Pool::vertices, used_.vertices_wanted, used_.vertices, count, pools_.vertices.size());
    if (shaded && count > pools_.shades.size() - used_.shades)
      return refuse_all(Pool::shades, used_.shades_wanted, used_.shades, count, pools_.shades.size());
    if (textured && count > pools_.textures.size() - used_.textures)
      return refuse_all(Pool::textures, used_.textures_wanted, used_.textures, count, pools_.textures.size());
    return {};
  }
  /// An instance's vertices fit whole or not at all: the free rest counts as taken by it.
  static Status refuse_all(Pool pool, std::uint32_t& missing_so_far, std::uint32_t used, std::size_t count,
                           std::size_t size) {
    const std::size_t free_rest = missing_so_far == 0 ? size - used : 0;
    return refuse(pool, missing_so_far, count - free_rest, size);
  }

  /// What shaders other than flat and Gouraud need to know of group `number`.
  void describe_surface([[maybe_unused]] const Mesh& mesh, [[maybe_unused]] const Transform& transform,
                        [[maybe_unused]] const Material& material, [[maybe_unused]] Link number,
                        [[maybe_unused]] bool textured, [[maybe_unused]] bool local_light,
                        [[maybe_unused]] const VertexStore& store, [[maybe_unused]] ShadingGroup& shading) {
    if constexpr (has_textures || has_local_light) {
      if (!textured && !is_general(shading.shader) && !(has_local_light && local_light)) return;
      TexturedGroup& more = pools_.textured[number];
      more = {textured ? store.textures.data() : nullptr, material.texturing, material.colour,
              !store.shades.empty() && material.shading == ShadingMode::gouraud, kind_of_shades(mesh, material)};
      if constexpr (has_effects) more.effects = &effects_;
      if constexpr (has_pixelwise) {
        pools_.pixelwise[number] = {material.relief, material.volume, store.thirds.data()};
        more.pixelwise = &pools_.pixelwise[number];
      }
      if constexpr (has_local_light) {
        // In place: it is too large for a temporary on small stacks.
        if (local_light)
          more.local =
              new (&pools_.local_lights[number]) LocalLighting(lighting_, view_.camera, mesh, transform, material);
      }
      shading.textured = &more;
    }
  }

  static void light_vertices(const Mesh& mesh, [[maybe_unused]] const Material& material,
                             [[maybe_unused]] bool local_light, const ShadingGroup& shading, std::uint32_t* shades) {
    if constexpr (has_relief) {
      if (under_relief(mesh, material)) return shade_vertices_for_relief(mesh, shading, shades);
    }
    if constexpr (has_local_light) {
      if (has_volumes && shade_kind(mesh, material) == vertex_shade::Kind::highlight_and_intensity)
        return shade_solid_vertices_locally(mesh, *shading.textured->local, shades);
      if (local_light) return shade_vertices_locally(mesh, material.colour, *shading.textured->local, shades);
    }
    shade_vertices(mesh, shading, shades);
  }

  void prepare_shades(const Mesh& mesh, const Material& material, Link number, bool local_light, ShadingGroup& shading,
                      std::uint32_t* shades) {
    if constexpr (has_translucent) {
      if (varying_opacity(mesh)) return shade_translucent_vertices(mesh, material.colour, shading, shades);
    }
    light_vertices(mesh, material, local_light, shading, shades);
    if constexpr (has_ramps) {
      if (!mesh.vertex_colours.empty()) return;
      std::uint16_t* ramp = pools_.ramps.data() + number * gouraud::ramp_size;
      fill_ramp<Format>(LitColour::from(material.colour), ramp);
      shading.ramp = ramp;
    }
  }

  Status assemble(const Mesh& mesh, [[maybe_unused]] const Transform& transform, const Material& material,
                  const InstanceGeometry& geometry, const PolygonGroup& group, VertexStore& store) {
    geometry.transform_vertices(store.vertices.data());
    PolygonAssembly assembly(table_, bucket_of_row_, viewport(), cull_);
    const Clipper clipper = geometry.clipper(kind_of_shades(mesh, material));
    const bool shaded = !store.shades.empty(), textured = !store.textures.empty();
    std::size_t room = store.vertices.size();
    if (shaded) room = std::min(room, store.shades.size());
    if (textured) room = std::min(room, store.textures.size());
    store.vertices = store.vertices.first(room);
    [[maybe_unused]] Nearness nearness;
    TextureVertexMaker textures;
    if constexpr (has_textures) {
      if (textured) {
        nearness = geometry.nearness();
        textures = TextureVertexMaker::for_instance(nearness);
        if (has_volumes && !store.thirds.empty())
          geometry.make_volume_vertices(nearness, material.volume, store.textures.data(), store.thirds.data());
        else if (material.texturing.coordinates == TextureCoordinates::sphere_map)
          geometry.make_sphere_map_vertices(nearness, material.texture_matrix, transform.rotation,
                                            store.textures.data());
        else
          geometry.make_texture_vertices(nearness, material.texture_matrix, store.textures.data());
      }
    }
    assembly.run(mesh, group.vertices, group.scissored, geometry.clip_context(clipper, store, textures));
    used_.vertices += store.count;
    if (shaded) used_.shades += store.count;
    if (textured) used_.textures += store.count;
    return finish(assembly, store.wanted_vertices, shaded, textured);
  }

  Status finish(const PolygonAssembly& assembly, std::uint32_t vertices_missing, bool shaded, bool textured) {
    statistics_.polygons.total += assembly.counts.total;
    statistics_.polygons.outside += assembly.counts.outside;
    statistics_.polygons.back += assembly.counts.back;
    if (vertices_missing != 0) {
      // Up to three parallel pools: the one with the least room is named.
      constexpr std::size_t unbounded = ~std::size_t{0};
      const std::size_t vertices_left = pools_.vertices.size() - used_.vertices,
                        shades_left = shaded ? pools_.shades.size() - used_.shades : unbounded,
                        textures_left = textured ? pools_.textures.size() - used_.textures : unbounded;
      const Status full = refuse(Pool::vertices, used_.vertices_wanted, vertices_missing, pools_.vertices.size());
      if (vertices_left < shades_left && vertices_left < textures_left) return full;
      if (shades_left <= textures_left)
        return refuse(Pool::shades, used_.shades_wanted, vertices_missing, pools_.shades.size());
      return refuse(Pool::textures, used_.textures_wanted, vertices_missing, pools_.textures.size());
    }
    if (assembly.fans_wanted != 0)
      return refuse(Pool::fans, used_.fans_wanted, assembly.fans_wanted, pools_.fans.size());
    if (assembly.polygons_wanted != 0)
      return refuse(Pool::polygons, used_.polygons_wanted, assembly.polygons_wanted, pools_.references.size());
    return {};
  }

  void note_peaks() {
    peaks_.instances = table_.group_count *
                       (sizeof(PolygonGroup) + sizeof(ShadingGroup) + (has_ramps ? gouraud::ramp_size * 2 : 0) +
                        (has_local_light ? sizeof(LocalLighting) : 0) + (has_pixelwise ? sizeof(PixelwiseGroup) : 0));
    peaks_.vertices = used_.vertices * sizeof(ScreenVertex);
    peaks_.shades = used_.shades * sizeof(std::uint32_t);
    peaks_.textures = used_.textures * (sizeof(TextureVertex) + (has_volumes ? sizeof(std::int32_t) : 0)) +
                      (has_textures || has_local_light ? table_.group_count * sizeof(TexturedGroup) : 0);
    peaks_.polygons = table_.polygon_count * sizeof(PolygonReference);
    peaks_.fans = table_.fan_count * sizeof(FanTriangle);
    peaks_.active = Visibility::Memory::bytes(drawer_.visibility().peak());
    if constexpr (Shaders::see_through)
      peaks_.layers = Visibility::Memory::layer_bytes(
          std::min<std::size_t>(drawer_.visibility().layers_wanted(), capacity().layers));
    peaks_.buckets = pools_.buckets.size_bytes();
    peaks_.colour_bands = drawer_.pools().colour.size_bytes();
    peaks_.depth_band = Visibility::tests_depth ? drawer_.pools().depth.size_bytes() : 0;
    if constexpr (requires(const typename Visibility::Memory& memory) { memory.band_bytes(); })
      peaks_.depth_band += drawer_.pools().visibility.band_bytes();
  }

  BandDrawer<Traits> drawer_;
  Status status_{};
  bool ready_ = false;
  Pools pools_{};
  PolygonTable table_{};
  BandOfRow bucket_of_row_{};
  Lighting lighting_{};
  Cull cull_{};
  std::uint8_t stipple_seed_ = 0;
  bool effects_wanted_ = false;  ///< fog or dither
  bool dither_wanted_ = false;
  Pixel background_{};
  FrameView view_{};
  [[no_unique_address]] std::conditional_t<has_effects, FrameEffects, NoEffects> effects_;
  Used used_{};
  Statistics statistics_{};
  PoolPeaks peaks_{};
};

}  // namespace spanline
