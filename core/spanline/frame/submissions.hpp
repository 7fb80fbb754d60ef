#pragma once
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
#include "spanline/geometry/instance.hpp"
#include "spanline/geometry/polygon_assembly.hpp"
#include "spanline/geometry/vertex_store.hpp"
#include "spanline/memory/arena.hpp"
#include "spanline/memory/capacity.hpp"
#include "spanline/model/cull.hpp"
#include "spanline/model/polygon_range.hpp"
#include "spanline/raster/band_of_row.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/world/order_runs.hpp"
#include "spanline/world/submission_order.hpp"
#include "spanline/world/world.hpp"

namespace spanline {

/// The instances of a frame: it places what a renderer is given on the screen, makes surfaces for it, and enters its
/// polygons into the polygon table, all in the caller's pools.
template <class Traits>
class Submissions {
 public:
  using Visibility = typename BandDrawer<Traits>::Visibility;  ///< the visibility algorithm
  /// Whether the algorithm looks at the world behind the polygons.
  static constexpr bool needs_world = Visibility::needs == AlgorithmNeeds::world;

  /// Takes the pools from an arena.
  void take(Arena& arena, const Capacity& capacity) {
    pools_.take(arena, capacity);
    viewport_ = {capacity.width, capacity.height};
    bucket_of_row_ = BandOfRow(Visibility::bucket_lines(capacity));
    table_.references = pools_.references;
    table_.fans = FanRecords(pools_.fans);
    table_.groups = pools_.groups;
    table_.buckets = pools_.buckets;
  }

  /// Forgets the frame before.
  void clear() {
    table_.clear();
    counts_ = {};
    pools_.used = {};
  }
  /// Starts a frame with settings that are in their ranges.
  void begin(const FrameSettings& settings) {
    cull_ = settings.cull;
    needs_ = {!settings.lighting.point_lights.empty(), settings.fog.curve != FogCurve::none, settings.dither};
    surfaces_.begin(settings);
    view_ = {settings.camera, viewport_, Traits::Depth::bits, Traits::Depth::nearest, Traits::Depth::farthest};
    if constexpr (needs_world) world_ = {settings.camera, {}};
  }

  /// As Renderer::add.
  Status add(const Mesh& mesh, const Transform& transform, const Material& material) {
    return place(mesh, transform, material, number_triangles(mesh.triangle_count()),
                 [&](auto assemble) { assemble(PolygonRange::whole(mesh)); });
  }

  /// As Renderer::add_in_order.
  template <SubmissionOrder Order>
  Status add_in_order(Order&& order, std::span<const OrderedInstance> instances) {
    const std::uint32_t first_id = pools_.used.ids;
    InstanceNumber at{0, first_id};
    Status first_fault;
    for (OrderRuns runs(order); runs.more();) {
      const Status status = place_run(runs, instances, at);
      // After the first fault, later instances may need more of the same pool.
      const bool wants_more = status.fault == Fault::pool_full && status.pool == first_fault.pool;
      if (first_fault.ok() || wants_more) first_fault = status;
    }
    pools_.used.ids = first_id;
    for (const OrderedInstance& instance : instances) number_triangles(instance.mesh->triangle_count());
    return first_fault;
  }

  /// As Renderer::add_screen.
  Status add_screen(std::span<const ScreenVertex> vertices, std::span<const std::uint16_t> colours,
                    const Material& material) {
    return place_on_screen(vertices, colours, material, vertices.size() / 3,
                           [&](PolygonAssembly& assembly) { assembly.run_screen(vertices); });
  }
  /// As Renderer::add_screen with corner counts.
  Status add_screen(std::span<const ScreenVertex> vertices, std::span<const std::uint8_t> corners,
                    std::span<const std::uint16_t> colours, const Material& material) {
    std::size_t corner_count = 0;
    for (const std::uint8_t count : corners) {
      const unsigned own = count & ~unsigned{Mesh::planar};
      if (own < 3 || own > Mesh::max_corners) return Fault::bad_corners;
      corner_count += own;
    }
    if (corner_count != vertices.size()) return Fault::bad_corners;
    return place_on_screen(vertices, colours, material, corner_count - 2 * corners.size(),
                           [&](PolygonAssembly& assembly) { assembly.run_screen(vertices, corners); });
  }

  /// The polygons that have been added.
  [[nodiscard]] PolygonTable& table() { return table_; }
  /// What draws each group of the table.
  [[nodiscard]] std::span<const ShadingGroup> shading() const { return pools_.shading; }
  /// The world behind the polygons, null if the algorithm does not look at it.
  [[nodiscard]] const World* world() const {
    if constexpr (needs_world)
      return &world_;
    else
      return nullptr;
  }
  /// How many polygons were submitted, and how many were left out and why.
  [[nodiscard]] const PolygonCounts& counts() const { return counts_; }
  /// Bytes of each pool that the frame has taken.
  [[nodiscard]] PoolPeaks taken() const { return pools_.taken(table_); }

 private:
  struct NoWorld {};
  using Set = ShaderSet<Traits>;

  /// Numbers an instance's triangles. Triangles that are not drawn have numbers too.
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
  /// Opens a group as planned; there must be room for it. Its geometry and its light are added later.
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

  /// Transforms an instance to the screen and adds polygons of it to the table: those of each range for which
  /// `parts(assemble)` calls assemble(range). `parts` is not called if no polygon can be visible.
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

  /// Adds polygons in screen coordinates, whose fans are so many triangles, by `run(assembly)`.
  template <class Run>
  Status place_on_screen(std::span<const ScreenVertex> vertices, std::span<const std::uint16_t> colours,
                         const Material& material, std::size_t triangles, Run run) {
    if (needs_world) return Fault::no_world;
    if (triangles >= fan_flag) return Fault::too_many_triangles;
    const std::uint32_t first_id = number_triangles(triangles);
    const InstancePlan plan = plan_screen_triangles<Traits>(material);
    if (plan.missing != MissingShader::none) return plan.missing;
    if (const Status room = pools_.reserve_group(table_.group_count); !room.ok()) return room;

    const Link number = open_group(plan, material, first_id);
    PolygonGroup& group = table_.groups[number];
    group.vertices = vertices.data();
    group.scissored = true;
    pools_.shading[number].screen_colours = colours.data();
    PolygonAssembly assembly(table_, bucket_of_row_, viewport_, cull_);
    keep_planar_polygons(assembly, {}, {});
    run(assembly);
    return finish(assembly, 0, plan);
  }
  static void keep_planar_polygons(PolygonAssembly& assembly, std::span<const std::uint32_t> shades,
                                   vertex_shade::Kind shade_kind) {
    if constexpr (requires { Visibility::takes_outlines; })
      assembly.keep_planar_polygons(Traits::Depth::bits, shades, shade_kind);
  }

  /// An instance of a list, and the number of its first triangle.
  struct InstanceNumber {
    std::uint32_t instance, first_id;

    /// Goes to another instance. The way is counted from this one, since orders often name neighbours.
    void move_to(std::uint32_t number, std::span<const OrderedInstance> instances) {
      const auto triangles = [&](std::uint32_t i) {
        return static_cast<std::uint32_t>(instances[i].mesh->triangle_count());
      };
      while (instance < number) first_id += triangles(instance++);
      while (instance > number) first_id -= triangles(--instance);
    }
  };

  /// Places what a run of an order names of its instance. `at` is the instance of the run before.
  template <class Order>
  Status place_run(OrderRuns<Order>& runs, std::span<const OrderedInstance> instances, InstanceNumber& at) {
    const std::uint32_t number = runs.instance();
    bool taken = false, exist = number < instances.size();
    Status status;
    if (exist) {
      const OrderedInstance& instance = instances[number];
      at.move_to(number, instances);
      status = place(*instance.mesh, instance.transform, instance.material, at.first_id, [&](auto assemble) {
        taken = true;
        const PolygonRange whole = PolygonRange::whole(*instance.mesh);
        runs.take_run([&](const Submission& submission) {
          const PolygonRange part = submission.whole ? whole : submission.polygons;
          const bool exists = part.first <= whole.count && part.count <= whole.count - part.first;
          if (exists) assemble(part);
          exist = exist && exists;
        });
      });
    }
    if (!taken) runs.take_run([](const Submission&) {});
    return exist ? status : Fault::bad_order;
  }

  template <class Parts>
  Status assemble(const Mesh& mesh, [[maybe_unused]] const Transform& transform,
                  [[maybe_unused]] const Material& material, const InstancePlan& plan, const InstanceGeometry& geometry,
                  const PolygonGroup& group, VertexStore& store, Parts parts) {
    geometry.transform_vertices(store.vertices.data());
    PolygonAssembly assembly(table_, bucket_of_row_, viewport_, cull_);
    const Clipper clipper = geometry.clipper(plan.shades);
    std::size_t room = store.vertices.size();
    if (plan.shaded()) room = std::min(room, store.shades.size());
    if (plan.textured()) room = std::min(room, store.textures.size());
    store.vertices = store.vertices.first(room);
    PolygonAssembly::ClipContext clip = geometry.clip_context(clipper, store);
    [[maybe_unused]] Nearness nearness;
    if constexpr (Set::has_textures) {
      if (plan.textured()) {
        nearness = geometry.nearness();
        clip.textures = TextureVertexMaker::for_instance(nearness);
        make_texture_vertices(transform, material, plan, geometry, nearness, store);
      }
    }
    if constexpr (Set::has_ids || Traits::statistics) clip.fan_lines = FanLineMaker::for_view(view_);
    // Sphere maps are not linear over polygons.
    if (plan.coordinates != CoordinateSource::sphere_map) keep_planar_polygons(assembly, store.shades, plan.shades);
    parts([&](const PolygonRange& range) { assembly.run(mesh, group.vertices, group.scissored, clip, range); });
    pools_.close_store(store, plan);
    return finish(assembly, store.wanted_vertices, plan);
  }
  /// Not inlined, so that its frame is gone from the stack before polygons are clipped.
  [[gnu::noinline]] static void make_texture_vertices(const Transform& transform, const Material& material,
                                                      const InstancePlan& plan, const InstanceGeometry& geometry,
                                                      const Nearness& nearness, VertexStore& store) {
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
    counts_.whole += assembly.counts.whole;
    return pools_.missing(assembly, vertices_missing, plan);
  }

  PolygonTable table_{};
  FramePools<Traits> pools_{};
  SurfaceMaker<Traits> surfaces_;
  Viewport viewport_{};
  BandOfRow bucket_of_row_{};
  FrameNeeds needs_{};
  Cull cull_{};
  FrameView view_{};
  PolygonCounts counts_{};
  [[no_unique_address]] std::conditional_t<needs_world, World, NoWorld> world_{};
};

}  // namespace spanline
