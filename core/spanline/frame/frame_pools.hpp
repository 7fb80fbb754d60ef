#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/frame/band_drawer.hpp"
#include "spanline/frame/instance_plan.hpp"
#include "spanline/frame/shader_set.hpp"
#include "spanline/frame/status.hpp"
#include "spanline/geometry/polygon_assembly.hpp"
#include "spanline/geometry/vertex_store.hpp"
#include "spanline/memory/arena.hpp"
#include "spanline/memory/capacity.hpp"
#include "spanline/memory/pool_peaks.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/world/world.hpp"

namespace spanline {

/// All memory of a frame except its bands, in the order in which the arena hands it out, and how much of it is in use.
template <class Traits>
struct FramePools {
  using Set = ShaderSet<Traits>;  ///< what the list of shaders contains
  /// Whether the visibility algorithm works in the world, and so instances are kept as they stand there.
  static constexpr bool needs_world = BandDrawer<Traits>::Visibility::needs == AlgorithmNeeds::world;

  std::span<PolygonGroup> groups;             ///< one for each instance, for visibility
  std::span<PlacedInstance> placed;           ///< one for each instance, if the algorithm needs the world
  std::span<ShadingGroup> shading;            ///< one for each instance, for shaders
  std::span<std::uint16_t> ramps;             ///< gouraud::ramp_size pixels for each instance, for smooth shading
  std::span<ScreenVertex> vertices;           ///< of all instances, and those that clipping adds
  std::span<std::uint32_t> shades;            ///< one for each vertex of smooth instances
  std::span<TextureVertex> textures;          ///< one for each vertex of textured instances
  std::span<std::int32_t> third_coordinates;  ///< texture coordinate r, parallel to `textures`, for solids
  std::span<TexturedGroup> textured;          ///< one for each instance, for shaders of textures and local light
  std::span<PixelwiseGroup> pixelwise;        ///< one for each instance, for reliefs and solids
  std::span<LocalLighting> local_lights;      ///< one for each instance, for point lights and highlights
  std::span<PolygonReference> references;     ///< the records of the polygon table
  std::span<Link> fans;                       ///< records of the polygon table (FanRecords)
  std::span<Link> buckets;                    ///< start of each band's list in the polygon table

  /// Whether a renderer accepts these sizes, and if not, why.
  [[nodiscard]] static constexpr Status check(const Capacity& c) {
    using Visibility = typename BandDrawer<Traits>::Visibility;
    constexpr Fault bad = Fault::bad_configuration;
    if (!c.valid()) return bad;
    if (c.instances >= no_link) return {bad, Pool::instances, no_link - 1u};
    if (c.polygons >= no_link) return {bad, Pool::polygons, no_link - 1u};
    if (c.fans >= fan_flag) return {bad, Pool::fans, fan_flag - 1u};
    if (Visibility::takes(c)) return {};
    if constexpr (requires { Visibility::most_layers; })
      return c.members >= no_link ? Status{bad, Pool::members, no_link - 1u}
                                  : Status{bad, Pool::layers, Visibility::most_layers};
    else if constexpr (requires { Visibility::most_awake; })
      return {bad, c.awake >= c.layers ? Pool::awake : Pool::layers, Visibility::most_awake};
    else
      return {bad, c.active >= c.fragments ? Pool::active : Pool::fragments, no_link - 1u};
  }

  /// Takes the pools from an arena.
  constexpr void take(Arena& arena, const Capacity& c) {
    groups = arena.take<PolygonGroup>(c.instances);
    placed = arena.take<PlacedInstance>(needs_world ? c.instances : 0);
    shading = arena.take<ShadingGroup>(c.instances);
    ramps = arena.take<std::uint16_t>(Set::has_ramps ? c.instances * gouraud::ramp_size : 0);
    vertices = arena.take<ScreenVertex>(c.vertices);
    shades = arena.take<std::uint32_t>(Set::has_shades ? c.shades : 0);
    textures = arena.take<TextureVertex>(Set::has_textures ? c.textures : 0);
    third_coordinates = arena.take<std::int32_t>(Set::has_volumes ? c.textures : 0);
    textured = arena.take<TexturedGroup>(Set::has_textures || Set::has_local_light ? c.instances : 0);
    pixelwise = arena.take<PixelwiseGroup>(Set::has_pixelwise ? c.instances : 0);
    local_lights = arena.take<LocalLighting>(Set::has_local_light ? c.instances : 0);
    references = arena.take<PolygonReference>(c.polygons);
    fans = arena.take<Link>(std::size_t{c.fans} * FanRecords::numbers_in_record);
    buckets = arena.take<Link>(bucket_count(c));
  }

  /// Number of buckets of the polygon table.
  [[nodiscard]] static constexpr std::uint32_t bucket_count(const Capacity& c) {
    const std::uint32_t lines = std::max<std::uint32_t>(1, BandDrawer<Traits>::Visibility::bucket_lines(c));
    return (c.height + lines - 1) / lines;
  }

  /// How much of the pools the frame has used, and how much it lacked, in entries.
  struct Used {
    std::uint32_t vertices = 0;          ///< entries
    std::uint32_t shades = 0;            ///< entries
    std::uint32_t textures = 0;          ///< entries
    std::uint32_t ids = 0;               ///< triangles that have been numbered
    std::uint32_t instances_wanted = 0;  ///< entries that were asked for and not available; likewise those below
    std::uint32_t vertices_wanted = 0;   ///< entries that were not available
    std::uint32_t shades_wanted = 0;     ///< entries that were not available
    std::uint32_t textures_wanted = 0;   ///< entries that were not available
    std::uint32_t polygons_wanted = 0;   ///< entries that were not available
    std::uint32_t fans_wanted = 0;       ///< entries that were not available
  };
  Used used;  ///< by the frame so far

  /// Checks that there is room for one more group.
  Status reserve_group(std::uint32_t groups_taken) {
    if (groups_taken < groups.size()) return {};
    return refuse(Pool::instances, used.instances_wanted, 1, groups.size());
  }
  /// Checks that there is room for an instance of a mesh.
  Status reserve(std::uint32_t groups_taken, const Mesh& mesh, const InstancePlan& plan) {
    if (const Status room = reserve_group(groups_taken); !room.ok()) return room;
    const std::size_t count = mesh.vertex_count();
    if (count > vertices.size() - used.vertices)
      return refuse_all(Pool::vertices, used.vertices_wanted, used.vertices, count, vertices.size());
    if (plan.shaded() && count > shades.size() - used.shades)
      return refuse_all(Pool::shades, used.shades_wanted, used.shades, count, shades.size());
    if (plan.textured() && count > textures.size() - used.textures)
      return refuse_all(Pool::textures, used.textures_wanted, used.textures, count, textures.size());
    return {};
  }
  /// The store of vertices for an instance that has found room: its mesh's vertices count as used, the rest is free.
  [[nodiscard]] VertexStore open_store(const Mesh& mesh, const InstancePlan& plan) const {
    VertexStore store;
    store.vertices = vertices.subspan(used.vertices);
    if (plan.shaded()) store.shades = shades.subspan(used.shades);
    if (plan.textured()) store.textures = textures.subspan(used.textures);
    if (Set::has_volumes && plan.has_third_coordinates()) store.thirds = third_coordinates.subspan(used.textures);
    store.count = static_cast<Link>(mesh.vertex_count());
    return store;
  }
  /// Marks as used what an instance has taken of its store.
  void close_store(const VertexStore& store, const InstancePlan& plan) {
    used.vertices += store.count;
    if (plan.shaded()) used.shades += store.count;
    if (plan.textured()) used.textures += store.count;
  }
  /// Reports what an assembly found no room for.
  Status missing(const PolygonAssembly& assembly, std::uint32_t vertices_missing, const InstancePlan& plan) {
    if (vertices_missing != 0) {
      // Vertices lie in up to three parallel pools; the one with the least room is reported.
      constexpr std::size_t unbounded = ~std::size_t{0};
      const std::size_t vertices_left = vertices.size() - used.vertices,
                        shades_left = plan.shaded() ? shades.size() - used.shades : unbounded,
                        textures_left = plan.textured() ? textures.size() - used.textures : unbounded;
      const Status full = refuse(Pool::vertices, used.vertices_wanted, vertices_missing, vertices.size());
      if (vertices_left < shades_left && vertices_left < textures_left) return full;
      if (shades_left <= textures_left)
        return refuse(Pool::shades, used.shades_wanted, vertices_missing, shades.size());
      return refuse(Pool::textures, used.textures_wanted, vertices_missing, textures.size());
    }
    if (assembly.fans_wanted != 0)
      return refuse(Pool::fans, used.fans_wanted, assembly.fans_wanted, fans.size() / FanRecords::numbers_in_record);
    if (assembly.polygons_wanted != 0)
      return refuse(Pool::polygons, used.polygons_wanted, assembly.polygons_wanted, references.size());
    return {};
  }
  /// Bytes of the pools that a frame's table and vertices use.
  [[nodiscard]] PoolPeaks taken(const PolygonTable& table) const {
    PoolPeaks peaks;
    peaks.instances = table.group_count * (sizeof(PolygonGroup) + (needs_world ? sizeof(PlacedInstance) : 0) +
                                           sizeof(ShadingGroup) + (Set::has_ramps ? gouraud::ramp_size * 2 : 0) +
                                           (Set::has_local_light ? sizeof(LocalLighting) : 0) +
                                           (Set::has_pixelwise ? sizeof(PixelwiseGroup) : 0));
    peaks.vertices = used.vertices * sizeof(ScreenVertex);
    peaks.shades = used.shades * sizeof(std::uint32_t);
    peaks.textures = used.textures * (sizeof(TextureVertex) + (Set::has_volumes ? sizeof(std::int32_t) : 0)) +
                     (Set::has_textures || Set::has_local_light ? table.group_count * sizeof(TexturedGroup) : 0);
    peaks.polygons = table.polygon_count * sizeof(PolygonReference);
    peaks.fans = table.fans.used() * FanRecords::numbers_in_record * sizeof(Link);
    peaks.buckets = buckets.size_bytes();
    return peaks;
  }

 private:
  /// Counts what does not fit, and reports the size that would have sufficed.
  static Status refuse(Pool pool, std::uint32_t& missing_so_far, std::size_t missing, std::size_t size) {
    missing_so_far += static_cast<std::uint32_t>(missing);
    return {Fault::pool_full, pool, static_cast<std::uint32_t>(size) + missing_so_far};
  }
  /// An instance's vertices are taken all or none. When they do not fit, the remaining room counts as used by them.
  static Status refuse_all(Pool pool, std::uint32_t& missing_so_far, std::uint32_t taken, std::size_t count,
                           std::size_t size) {
    const std::size_t free_rest = missing_so_far == 0 ? size - taken : 0;
    return refuse(pool, missing_so_far, count - free_rest, size);
  }
};

}  // namespace spanline
