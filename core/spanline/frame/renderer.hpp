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
#include "spanline/frame/instance_plan.hpp"
#include "spanline/frame/status.hpp"
#include "spanline/frame/surface_maker.hpp"
#include "spanline/frame/traits.hpp"
#include "spanline/geometry/instance.hpp"
#include "spanline/geometry/polygon_assembly.hpp"
#include "spanline/geometry/vertex_store.hpp"
#include "spanline/memory/arena.hpp"
#include "spanline/memory/capacity.hpp"
#include "spanline/model/cull.hpp"
#include "spanline/model/polygon_range.hpp"
#include "spanline/raster/band_of_row.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/visibility/counters.hpp"
#include "spanline/world/submission_order.hpp"

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

  /// What a renderer would say of a configuration: sizes outside their ranges are bad_configuration, and so are pools
  /// with more entries than can be numbered, which the status names with the most that they can have. That differs from
  /// core to core, and with the shaders: `Spanning` addresses its records by 16 bits on 32-bit cores.
  [[nodiscard]] static constexpr Status check(const Capacity& capacity) { return FramePools<Traits>::check(capacity); }
  /// Whether a renderer takes a configuration, for programs that hold a constant one against it:
  ///
  ///     static_assert(Renderer<FlatTraits<>>::takes(capacity));
  [[nodiscard]] static constexpr bool takes(const Capacity& capacity) { return check(capacity).ok(); }

  /// Divides `memory` into pools. `status()` tells whether it was enough and the capacity valid; if not, the renderer
  /// refuses every frame.
  Renderer(const Capacity& capacity, std::span<std::byte> memory) : drawer_(capacity, {}) {
    status_ = check(capacity);
    Arena arena = Arena::aligned(memory);
    typename BandDrawer<Traits>::Pools bands;
    if (status_.ok()) {
      pools_.take(arena, capacity);
      bands.take(arena, capacity);
      if (arena.overrun())
        status_ = {Fault::pool_full, Pool::memory, static_cast<std::uint32_t>(bytes_needed(capacity))};
    }
    if (!status_.ok()) {
      frame_ = status_;
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

  /// Starts a frame. Where the settings are out of their ranges it says so, and so do all calls for this frame: nothing
  /// is added or drawn.
  Status begin(const FrameSettings& settings) {
    drawer_.forget_clears();
    table_.clear();
    counts_ = {};
    counters_ = {};
    peaks_ = {};
    pools_.used = {};
    bands_in_turn_ = 0;
    frame_ = status_.ok() ? check_settings(settings) : status_;
    if (!frame_.ok()) return frame_;
    cull_ = settings.cull;
    background_ = Format::from(settings.background);
    needs_ = {!settings.lighting.point_lights.empty(), settings.fog.curve != FogCurve::none, settings.dither};
    surfaces_.begin(settings);
    view_ = {settings.camera, viewport(), Depth::bits, Depth::nearest, Depth::farthest};
    return {};
  }

  /// Adds an instance of a validated mesh; the Mesh object itself must stay until `draw` has returned. What the shaders
  /// cannot draw is left out, and the status names the shader that is missing. Where a pool is full what fits is kept,
  /// and the status names the pool and the size that the frame has wanted so far.
  Status add(const Mesh& mesh, const Transform& transform, const Material& material) {
    if (!frame_.ok()) return frame_;
    return place(mesh, transform, material, number_triangles(mesh.triangle_count()),
                 [&](auto assemble) { assemble(PolygonRange::whole(mesh)); });
  }

  /// Adds instances, or parts of them, as an order hands them over (world/submission_order.hpp). Triangles are numbered
  /// as the list of instances has them, whatever the order. What finds no room is left out and the rest is added; the
  /// status is that of the first one that did not fit, or `bad_order` for an instance or polygons that do not exist.
  template <SubmissionOrder Order>
  Status add_in_order(Order&& order, std::span<const OrderedInstance> instances) {
    if (!frame_.ok()) return frame_;
    const std::uint32_t first_id = pools_.used.ids;
    Status first_fault;
    Submission next;
    for (bool more = order.next(next); more;) {
      const std::uint32_t number = next.instance;
      Status status = Fault::bad_order;
      bool taken = false;  // whether the submissions of this instance were gone through
      if (number < instances.size()) {
        const OrderedInstance& instance = instances[number];
        std::uint32_t id = first_id;
        for (const OrderedInstance& before : instances.first(number))
          id += static_cast<std::uint32_t>(before.mesh->triangle_count());
        bool exist = true;
        status = place(*instance.mesh, instance.transform, instance.material, id, [&](auto assemble) {
          const PolygonRange whole = PolygonRange::whole(*instance.mesh);
          taken = true;
          do {
            const PolygonRange part = next.whole ? whole : next.polygons;
            const bool exists = part.first <= whole.count && part.count <= whole.count - part.first;
            if (exists) assemble(part);
            exist = exist && exists;
            more = order.next(next);
          } while (more && next.instance == number);
        });
        if (!exist) status = Fault::bad_order;
      }
      while (more && !taken) {
        more = order.next(next);
        if (more && next.instance != number) break;
      }
      // Behind the first fault, the same pool may want more.
      const bool wants_more = status.fault == Fault::pool_full && status.pool == first_fault.pool;
      if (first_fault.ok() || wants_more) first_fault = status;
    }
    pools_.used.ids = first_id;
    for (const OrderedInstance& instance : instances) number_triangles(instance.mesh->triangle_count());
    return first_fault;
  }

  /// Adds triangles that are on screen already: corners three by three (outcodes set where they leave the viewport),
  /// and a colour each in RGB565. Both tables must stay until `draw` has returned. They are flat, whatever the frame's
  /// light, fog and dither; of the material, opacity and transparency count. 32,767 triangles a call on 32-bit
  /// machines.
  Status add_screen(std::span<const ScreenVertex> vertices, std::span<const std::uint16_t> colours) {
    static constexpr Material opaque{};  // made once, not by each caller
    return add_screen(vertices, colours, opaque);
  }
  /// The same with the opacity and the transparency of a material.
  Status add_screen(std::span<const ScreenVertex> vertices, std::span<const std::uint16_t> colours,
                    const Material& material) {
    if (!frame_.ok()) return frame_;
    if (needs_world) return Fault::no_world;
    if (vertices.size() / 3 >= fan_flag) return Fault::too_many_triangles;
    const std::uint32_t first_id = number_triangles(vertices.size() / 3);
    const InstancePlan plan = plan_screen_triangles<Traits>(material);
    if (plan.missing != MissingShader::none) return plan.missing;
    if (const Status room = pools_.reserve_group(table_.group_count); !room.ok()) return room;

    const Link number = open_group(plan, material, first_id);
    PolygonGroup& group = table_.groups[number];
    group.vertices = vertices.data();
    group.scissored = true;
    pools_.shading[number].screen_colours = colours.data();
    PolygonAssembly assembly(table_, bucket_of_row_, viewport(), cull_);
    assembly.run_screen(vertices);
    return finish(assembly, 0, plan);
  }

  /// For a FillingSink, between `begin` and `draw`: starts to clear the first band, while instances are added. False
  /// where the sink gives up, as it will for `draw`.
  template <class Sink>
  bool clear_ahead(Sink&& sink) {
    return !frame_.ok() || drawer_.clear_ahead(scene(), 0, sink);
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
  /// and draw, then end. Without a frame, before `start_bands`, and for a band that the picture does not have they do
  /// nothing and say so; the view of such a band is empty.
  Status start_bands() {
    if (!frame_.ok()) return frame_;
    bands_in_turn_ = capacity().bands();
    drawer_.start(scene(), BandShare::all);
    return {};
  }
  /// Prepares a band, [0, `capacity().bands()`).
  Status clear_band(std::uint32_t band) {
    if (!frame_.ok()) return frame_;
    // By a product: Cortex-M0+ has no division.
    if (band >= capacity().height || band * capacity().band_lines >= capacity().height) return Fault::bad_step;
    drawer_.clear_band(scene(), band);
    return {};
  }
  /// Draws a band that was cleared. The sink is told of covered triangles alone.
  template <class Sink>
  BandView draw_band(std::uint32_t band, Sink& sink) {
    if (band >= bands_in_turn_) return {};
    return drawer_.draw_band(scene(), band, sink);
  }
  /// Ends a frame that was drawn by steps, or that the sink of `draw` gave up. Its pools may have been too small.
  Status end_bands() {
    if (!frame_.ok()) return frame_;
    if (bands_in_turn_ == 0) return Fault::bad_step;
    bands_in_turn_ = 0;
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
  struct NoWorld {};
  using Counters = std::conditional_t<Traits::statistics, VisibilityCounters, NoCounters>;
  using Visibility = typename BandDrawer<Traits>::Visibility;
  using Set = ShaderSet<Traits>;
  static constexpr bool needs_world = Visibility::needs == AlgorithmNeeds::world;

  [[nodiscard]] Viewport viewport() const { return {capacity().width, capacity().height}; }
  [[nodiscard]] BandScene<Pixel> scene() { return scene(table_, counters_); }
  [[nodiscard]] BandScene<Pixel> scene(PolygonTable& table, Counters& counters) const {
    BandScene<Pixel> scene{table, pools_.shading, background_, nullptr, nullptr};
    if constexpr (Traits::statistics) scene.counters = &counters;
    if constexpr (needs_world) {
      scene.world = &world_;
    }
    return scene;
  }
  template <class Sink>
  Status draw_share(BandShare share, Sink& sink) {
    if (!frame_.ok()) return frame_;
    bands_in_turn_ = capacity().bands();
    const Status drawn = drawer_.draw(scene(), share, sink);
    if (drawn.fault == Fault::sink_failed) return drawn;
    bands_in_turn_ = 0;
    note_peaks();
    return drawn;
  }

  /// Numbers of the frame's triangles count on through those that are not drawn.
  std::uint32_t number_triangles(std::size_t count) {
    const std::uint32_t first_id = pools_.used.ids;
    pools_.used.ids += static_cast<std::uint32_t>(count);
    return first_id;
  }
  template <class Parts>
  Status leave_outside(const Mesh& mesh, Parts parts) {
    parts([&](const PolygonRange& range) {
      const std::uint32_t count = range.triangle_count(mesh);
      counts_.total += count;
      counts_.outside += count;
    });
    return {};
  }
  /// A group as planned, for which there is room: its geometry and its light are still to come.
  Link open_group(const InstancePlan& plan, const Material& material, std::uint32_t first_id) {
    const Link number = table_.group_count++;
    table_.groups[number] = {nullptr, nullptr, table_.polygon_count, first_id, true, plan.see_through, plan.holes};
    ShadingGroup& shading = pools_.shading[number];
    shading.clear();
    shading.first_id = first_id;
    shading.shader = plan.shader;
    surfaces_.set_layering(material, number, shading);
    return number;
  }

  /// Puts an instance on the screen, and those of its polygons into the table that `parts(assemble)` calls
  /// assemble(range) for. Where there is nothing to assemble, `parts` is not called.
  template <class Parts>
  Status place(const Mesh& mesh, const Transform& transform, const Material& material, std::uint32_t first_id,
               Parts parts) {
    const InstancePlan plan = plan_instance<Traits>(mesh, material, needs_, !Visibility::tests_depth);
    if (plan.missing != MissingShader::none) return plan.missing;
    const InstanceGeometry geometry(view_, mesh, transform);
    if (geometry.placement() == Placement::outside) return leave_outside(mesh, parts);
    if (const Status room = pools_.reserve(table_.group_count, mesh, plan); !room.ok()) return room;

    VertexStore store = pools_.open_store(mesh, plan);
    const Link number = open_group(plan, material, first_id);
    PolygonGroup& group = table_.groups[number];
    group.vertices = store.vertices.data();
    group.indices = mesh.indices.data();
    group.scissored = geometry.placement() != Placement::inside;
    if constexpr (needs_world) {
      pools_.placed[number] = {&mesh, transform, number};
      world_ = {view_.camera, pools_.placed.first(table_.group_count)};
    }
    surfaces_.make(mesh, transform, material, plan, view_.camera, number, store, pools_);
    return assemble(mesh, transform, material, plan, geometry, group, store, parts);
  }

  template <class Parts>
  Status assemble(const Mesh& mesh, [[maybe_unused]] const Transform& transform,
                  [[maybe_unused]] const Material& material, const InstancePlan& plan, const InstanceGeometry& geometry,
                  const PolygonGroup& group, VertexStore& store, Parts parts) {
    geometry.transform_vertices(store.vertices.data());
    PolygonAssembly assembly(table_, bucket_of_row_, viewport(), cull_);
    const Clipper clipper = geometry.clipper(plan.shades);
    std::size_t room = store.vertices.size();
    if (plan.shaded()) room = std::min(room, store.shades.size());
    if (plan.textured()) room = std::min(room, store.textures.size());
    store.vertices = store.vertices.first(room);
    [[maybe_unused]] Nearness nearness;
    TextureVertexMaker textures;
    if constexpr (Set::has_textures) {
      if (plan.textured()) {
        nearness = geometry.nearness();
        textures = TextureVertexMaker::for_instance(nearness);
        make_texture_vertices(transform, material, plan, geometry, nearness, store);
      }
    }
    const PolygonAssembly::ClipContext clip = geometry.clip_context(clipper, store, textures);
    parts([&](const PolygonRange& range) { assembly.run(mesh, group.vertices, group.scissored, clip, range); });
    pools_.close_store(store, plan);
    return finish(assembly, store.wanted_vertices, plan);
  }
  static void make_texture_vertices(const Transform& transform, const Material& material, const InstancePlan& plan,
                                    const InstanceGeometry& geometry, const Nearness& nearness, VertexStore& store) {
    if (Set::has_volumes && plan.coordinates == CoordinateSource::solid)
      geometry.make_volume_vertices(nearness, material.volume, store.textures.data(), store.thirds.data());
    else if (plan.coordinates == CoordinateSource::sphere_map)
      geometry.make_sphere_map_vertices(nearness, material.texture_matrix, transform.rotation, store.textures.data());
    else
      geometry.make_texture_vertices(nearness, material.texture_matrix, store.textures.data());
  }

  Status finish(const PolygonAssembly& assembly, std::uint32_t vertices_missing, const InstancePlan& plan) {
    counts_.total += assembly.counts.total;
    counts_.outside += assembly.counts.outside;
    counts_.back += assembly.counts.back;
    return pools_.missing(assembly, vertices_missing, plan);
  }

  void note_peaks() {
    peaks_ = pools_.taken(table_);
    peaks_.colour_bands = drawer_.pools().colour.size_bytes();
    peaks_.depth_band = Visibility::tests_depth ? drawer_.pools().depth.size_bytes() : 0;
    drawer_.visibility().note_peaks(peaks_);
  }

  BandDrawer<Traits> drawer_;
  Status status_{};                  ///< of the configuration and its memory
  Status frame_{Fault::no_frame};    ///< what keeps the frame from being added to and drawn
  std::uint32_t bands_in_turn_ = 0;  ///< all of them between start_bands and end_bands
  FramePools<Traits> pools_{};
  SurfaceMaker<Traits> surfaces_;
  PolygonTable table_{};
  BandOfRow bucket_of_row_{};
  FrameNeeds needs_{};
  Cull cull_{};
  Pixel background_{};
  FrameView view_{};
  PolygonCounts counts_{};
  [[no_unique_address]] Counters counters_{};
  [[no_unique_address]] std::conditional_t<needs_world, World, NoWorld> world_{};
  PoolPeaks peaks_{};
};

}  // namespace spanline
