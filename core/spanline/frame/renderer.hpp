#pragma once
/// @file
/// The renderer.
///
/// ```cpp
/// #include <spanline/frame/ready_made_traits.hpp>
///
/// using Picture = Renderer<FlatTraits<>>;
/// constexpr Capacity size{.width = 320, .height = 240, .vertices = 8, .polygons = 6, .fans = 6, .active = 6};
/// alignas(8) static std::byte memory[Picture::bytes_needed(size)];
///
/// Status draw(const FrameSettings& settings, const Mesh& mesh) {
///   Picture renderer(size, memory);
///   if (const Status begun = renderer.begin(settings); !begun.ok()) return begun;
///   if (const Status added = renderer.add(mesh, {}, {.colour = {240, 160, 60}}); !added.ok()) return added;
///   return renderer.draw([](const auto& band) { return send(band.y0, band.y1, band.pixels); });
/// }
/// ```
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "spanline/frame/band_drawer.hpp"
#include "spanline/frame/frame_pools.hpp"
#include "spanline/frame/frame_settings.hpp"
#include "spanline/frame/shader_choice.hpp"
#include "spanline/frame/status.hpp"
#include "spanline/frame/surface_maker.hpp"
#include "spanline/frame/traits.hpp"
#include "spanline/geometry/instance.hpp"
#include "spanline/geometry/polygon_assembly.hpp"
#include "spanline/geometry/vertex_store.hpp"
#include "spanline/memory/arena.hpp"
#include "spanline/memory/capacity.hpp"
#include "spanline/model/cull.hpp"
#include "spanline/raster/band_of_row.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/visibility/counters.hpp"

namespace spanline {

template <class Traits>
class BandPartner;

/// Numbers of a frame (design: the lectures' sets P, F, B; and what visibility did, where the traits count it).
struct Statistics {
  PolygonCounts polygons;         ///< how many there were, and how many were left out
  VisibilityCounters visibility;  ///< what the algorithm did; zeros where the traits do not count
};

/// The front door: takes a frame's instances, then draws it band by band.
///
/// It owns no memory: `bytes_needed` bytes are the caller's, and so are the tables of meshes and lights, which must
/// stay until `draw` has returned. Nothing is allocated. The order of submission settles ties.
template <class Traits>
class Renderer {
 public:
  using Depth = typename Traits::Depth;      ///< the format of depths
  using DepthWord = typename Depth::Word;    ///< of the depth buffer
  using Format = typename Traits::Format;    ///< the pixel format
  using Pixel = typename Format::Pixel;      ///< a word of it
  using Shaders = typename Traits::Shaders;  ///< the list of shaders
  /// What a sink gets: a Band of these words.
  using BandView = typename BandDrawer<Traits>::BandView;

  /// Bytes that a configuration takes of the caller's memory, alignment included.
  [[nodiscard]] static constexpr std::size_t bytes_needed(const Capacity& capacity) {
    Arena counting;
    FramePools<Traits> pools;
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

  /// Whether the memory was enough and the capacity in its ranges.
  [[nodiscard]] Status status() const { return status_; }

  /// Starts a frame. Fails for a camera whose planes or focal length are out of range, and draws nothing then.
  Status begin(const FrameSettings& settings) {
    ready_ = false;
    drawer_.forget_clears();
    table_.clear();
    counts_ = {};
    counters_ = {};
    peaks_ = {};
    pools_.used = {};
    if (!status_.ok()) return status_;
    if (!settings_valid(settings.camera)) return {Fault::bad_settings, Pool::none, 0};
    cull_ = settings.cull;
    background_ = Format::from(settings.background);
    surfaces_.begin(settings);
    view_ = {settings.camera, viewport(), Depth::bits, Depth::nearest, Depth::farthest};
    ready_ = true;
    return {};
  }

  /// Adds an instance of a validated mesh; the Mesh object itself must stay until `draw` has returned. Where a pool is
  /// full what fits is kept, and the status names the pool and the size that the frame has wanted so far.
  Status add(const Mesh& mesh, const Transform& transform, const Material& material) {
    if (!ready_) return status_.ok() ? Status{Fault::bad_settings, Pool::none, 0} : status_;
    const SurfaceNeeds needs = surfaces_.needs_of(mesh, material);
    const std::uint8_t shader = shader_for<Traits>(material, needs);
    const std::uint32_t first_id = pools_.used.ids;
    pools_.used.ids += static_cast<std::uint32_t>(mesh.triangle_count());
    // Opacities of vertices go with the group's own light.
    if (shader >= Shaders::count || (needs.local_light && Set::varying_opacity(mesh)))
      return {Fault::shader_missing, Pool::none, 0};
    // An algorithm that decides by whole spans cannot look through holes, unless it has layers.
    if (!Visibility::tests_depth && !Shaders::see_through && needs.holes) return {Fault::shader_missing, Pool::none, 0};

    const InstanceGeometry geometry(view_, mesh, transform);
    if (geometry.placement() == Placement::outside) {
      counts_.total += static_cast<std::uint32_t>(mesh.triangle_count());
      counts_.outside += static_cast<std::uint32_t>(mesh.triangle_count());
      return {};
    }
    const bool shaded = Set::needs_shades(mesh, material);
    if (const Status room = pools_.reserve(table_.group_count, mesh, shaded, needs.textured); !room.ok()) return room;

    const Link number = table_.group_count++;
    PolygonGroup& group = table_.groups[number];
    ShadingGroup& shading = pools_.shading[number];
    const auto& used = pools_.used;
    VertexStore store{
        pools_.vertices.subspan(used.vertices),
        shaded ? pools_.shades.subspan(used.shades) : std::span<std::uint32_t>{},
        needs.textured ? pools_.textures.subspan(used.textures) : std::span<TextureVertex>{},
        Set::has_volumes && needs.volume ? pools_.third_coordinates.subspan(used.textures) : std::span<std::int32_t>{},
        static_cast<Link>(mesh.vertex_count()),
        0};
    group = {store.vertices.data(),
             mesh.indices.data(),
             table_.polygon_count,
             first_id,
             geometry.placement() != Placement::inside,
             Shaders::see_through && (needs.holes || needs.varies || is_see_through(material)),
             needs.holes};
    shading.clear();
    shading.mesh = &mesh;
    shading.first_id = first_id;
    shading.shader = shader;
    surfaces_.make(mesh, transform, material, needs, view_.camera, number, store, pools_);
    return assemble(mesh, transform, material, geometry, group, store);
  }

  /// Adds triangles that are on screen already: corners three by three (outcodes set where they leave the viewport),
  /// and a colour each in RGB565. Both tables must stay until `draw` has returned. For flat shading; of the material,
  /// opacity and transparency count. 32,767 triangles a call on 32-bit machines.
  Status add_screen(std::span<const ScreenVertex> vertices, std::span<const std::uint16_t> colours) {
    static constexpr Material opaque{};  // made once, not by each caller
    return add_screen(vertices, colours, opaque);
  }
  /// The same with the opacity and the transparency of a material.
  Status add_screen(std::span<const ScreenVertex> vertices, std::span<const std::uint16_t> colours,
                    const Material& material) {
    if (!ready_) return status_.ok() ? Status{Fault::bad_settings, Pool::none, 0} : status_;
    if (vertices.size() / 3 >= fan_flag) return {Fault::too_many_triangles, Pool::none, 0};
    const std::uint8_t shader = shader_for<Traits>(material, {});
    const std::uint32_t first_id = pools_.used.ids;
    pools_.used.ids += static_cast<std::uint32_t>(vertices.size() / 3);
    if (shader >= Shaders::count) return {Fault::shader_missing, Pool::none, 0};
    if (const Status room = pools_.reserve_group(table_.group_count); !room.ok()) return room;
    const Link number = table_.group_count++;
    table_.groups[number] = {vertices.data(), nullptr, table_.polygon_count,
                             first_id,        true,    Shaders::see_through && is_see_through(material)};
    ShadingGroup& shading = pools_.shading[number];
    shading.clear();
    shading.screen_colours = colours.data();
    shading.first_id = first_id;
    shading.shader = shader;
    surfaces_.set_layering(material, number, shading);
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
  void start_bands() { drawer_.start(scene(), BandShare::all); }
  /// Prepares a band, [0, `capacity().bands()`).
  void clear_band(std::uint32_t band) { drawer_.clear_band(scene(), band); }
  /// Draws a band that was cleared. The sink is told of covered triangles alone.
  template <class Sink>
  BandView draw_band(std::uint32_t band, Sink& sink) {
    return drawer_.draw_band(scene(), band, sink);
  }
  /// Ends the frame, and says what has run full.
  Status end_bands() {
    note_peaks();
    return drawer_.end(scene());
  }

  /// The memory of a colour band, counted from 0, for present loops that hand it to a display; empty where the band
  /// does not exist. Frames use them in turn; with three and more the next frame goes on where the last one ended.
  [[nodiscard]] std::span<Pixel> colour_band(unsigned buffer) const { return drawer_.colour_band(buffer); }
  /// Numbers of the frame so far, complete behind `draw`.
  [[nodiscard]] Statistics statistics() const {
    if constexpr (Traits::statistics) return {counts_, counters_};
    return {counts_, {}};
  }
  /// Bytes of each pool that the last frame took.
  [[nodiscard]] const PoolPeaks& peaks() const { return peaks_; }
  /// The sizes that it was made for.
  [[nodiscard]] const Capacity& capacity() const { return drawer_.capacity(); }

 private:
  friend class BandPartner<Traits>;
  struct NoCounters {};
  using Counters = std::conditional_t<Traits::statistics, VisibilityCounters, NoCounters>;
  using Visibility = typename BandDrawer<Traits>::Visibility;
  using Set = ShaderSet<Traits>;
  [[nodiscard]] Viewport viewport() const { return {capacity().width, capacity().height}; }
  [[nodiscard]] static bool settings_valid(const Camera& camera) {
    const bool planes = camera.near_plane < camera.far_plane;
    return planes && camera.focal.raw() > 0 &&
           (camera.projection == Projection::orthographic || camera.near_plane.raw() > 0);
  }

  [[nodiscard]] BandScene<Pixel> scene() { return scene(table_, counters_); }
  [[nodiscard]] BandScene<Pixel> scene(PolygonTable& table, Counters& counters) const {
    if constexpr (Traits::statistics)
      return {table, pools_.shading, background_, &counters, nullptr};
    else
      return {table, pools_.shading, background_, nullptr, nullptr};
  }
  template <class Sink>
  Status draw_share(BandShare share, Sink& sink) {
    if (!ready_) return status_.ok() ? Status{Fault::bad_settings, Pool::none, 0} : status_;
    const Status drawn = drawer_.draw(scene(), share, sink);
    if (drawn.fault != Fault::sink_failed) note_peaks();
    return drawn;
  }

  Status assemble(const Mesh& mesh, [[maybe_unused]] const Transform& transform, const Material& material,
                  const InstanceGeometry& geometry, const PolygonGroup& group, VertexStore& store) {
    geometry.transform_vertices(store.vertices.data());
    PolygonAssembly assembly(table_, bucket_of_row_, viewport(), cull_);
    const Clipper clipper = geometry.clipper(Set::kind_of_shades(mesh, material));
    const bool shaded = !store.shades.empty(), textured = !store.textures.empty();
    std::size_t room = store.vertices.size();
    if (shaded) room = std::min(room, store.shades.size());
    if (textured) room = std::min(room, store.textures.size());
    store.vertices = store.vertices.first(room);
    [[maybe_unused]] Nearness nearness;
    TextureVertexMaker textures;
    if constexpr (Set::has_textures) {
      if (textured) {
        nearness = geometry.nearness();
        textures = TextureVertexMaker::for_instance(nearness);
        if (Set::has_volumes && !store.thirds.empty())
          geometry.make_volume_vertices(nearness, material.volume, store.textures.data(), store.thirds.data());
        else if (material.texturing.coordinates == TextureCoordinates::sphere_map)
          geometry.make_sphere_map_vertices(nearness, material.texture_matrix, transform.rotation,
                                            store.textures.data());
        else
          geometry.make_texture_vertices(nearness, material.texture_matrix, store.textures.data());
      }
    }
    assembly.run(mesh, group.vertices, group.scissored, geometry.clip_context(clipper, store, textures));
    pools_.used.vertices += store.count;
    if (shaded) pools_.used.shades += store.count;
    if (textured) pools_.used.textures += store.count;
    return finish(assembly, store.wanted_vertices, shaded, textured);
  }

  Status finish(const PolygonAssembly& assembly, std::uint32_t vertices_missing, bool shaded, bool textured) {
    counts_.total += assembly.counts.total;
    counts_.outside += assembly.counts.outside;
    counts_.back += assembly.counts.back;
    return pools_.missing(assembly, vertices_missing, shaded, textured);
  }

  void note_peaks() {
    peaks_ = pools_.taken(table_);
    peaks_.colour_bands = drawer_.pools().colour.size_bytes();
    peaks_.depth_band = Visibility::tests_depth ? drawer_.pools().depth.size_bytes() : 0;
    drawer_.visibility().note_peaks(peaks_);
  }

  BandDrawer<Traits> drawer_;
  Status status_{};
  bool ready_ = false;
  FramePools<Traits> pools_{};
  SurfaceMaker<Traits> surfaces_;
  PolygonTable table_{};
  BandOfRow bucket_of_row_{};
  Cull cull_{};
  Pixel background_{};
  FrameView view_{};
  PolygonCounts counts_{};
  [[no_unique_address]] Counters counters_{};
  PoolPeaks peaks_{};
};

}  // namespace spanline
