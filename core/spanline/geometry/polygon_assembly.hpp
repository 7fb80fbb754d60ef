#pragma once
#include <cstdint>
#include <span>

#include "spanline/geometry/clipper.hpp"
#include "spanline/geometry/projection.hpp"
#include "spanline/geometry/texture_vertices.hpp"
#include "spanline/geometry/vertex_store.hpp"
#include "spanline/geometry/view_space.hpp"
#include "spanline/model/cull.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/model/polygon_range.hpp"
#include "spanline/raster/band_of_row.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/raster/polygon_table.hpp"

namespace spanline {

/// The sizes of the lectures' sets of polygons, V = ((P \ F) \ B) \ O (lectures 001 and 002), in a frame. Polygons that
/// are neither outside nor culled are submitted to visibility. A polygon counts as the triangles of its fan.
struct PolygonCounts {
  std::uint32_t total = 0;    ///< P: all polygons
  std::uint32_t outside = 0;  ///< F: polygons outside the view
  std::uint32_t back = 0;     ///< B: polygons culled by their orientation
};

/// Puts the polygons of one instance into the polygon table, after rejection, culling and clipping, sorted into bands
/// by their first row. Polygons that find no room are left out and counted.
class PolygonAssembly {
 public:
  PolygonAssembly(PolygonTable& table, const BandOfRow& band_of_row, Viewport viewport, Cull cull)
      : table_(table), band_of_row_(band_of_row), viewport_(viewport), cull_(cull) {}

  /// The data that clipping needs of an instance. Pointers are null if the instance's placement shows that nothing
  /// needs clipping.
  struct ClipContext {
    const Clipper* clipper = nullptr;
    const ViewTransform* transform = nullptr;
    const PointProjection* projection = nullptr;
    TextureVertexMaker textures{};
    VertexStore* store = nullptr;
  };

  /// Assembles the polygons of `range` of `mesh`, whose screen vertices are `vertices`. `scissored` says that the mesh
  /// may leave the viewport.
  void run(const Mesh& mesh, const ScreenVertex* vertices, bool scissored, const ClipContext& clip,
           const PolygonRange& range);

  /// Assembles triangles, each of three consecutive vertices.
  void run_screen(std::span<const ScreenVertex> vertices);

  PolygonCounts counts;
  std::uint32_t polygons_wanted = 0;  ///< polygons that found no room in the pool `polygons`
  std::uint32_t fans_wanted = 0;      ///< polygons that found no room in the pool `fans`

 private:
  template <bool Scissored>
  void run_triangles(const Mesh& mesh, const ScreenVertex* vertices, const ClipContext& clip,
                     const PolygonRange& range);
  template <bool Scissored, Cull Culled>
  void run_triangles(const Mesh& mesh, const ScreenVertex* vertices, const ClipContext& clip,
                     const PolygonRange& range);
  void run_polygons(const Mesh& mesh, const ScreenVertex* vertices, bool scissored, const ClipContext& clip,
                    const PolygonRange& range);
  template <bool Scissored>
  bool take(Cull cull, const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c, std::int32_t& band,
            std::uint32_t& back) const;
  void append(std::int32_t band, Link source);
  void append_fan(std::int32_t band, const FanTriangle& fan);
  void clip_triangle(const Mesh& mesh, const ClipContext& clip, const ScreenVertex* vertices, const Link (&corner)[3],
                     Link triangle, Link polygon);
  PolygonTable& table_;
  BandOfRow band_of_row_;
  Viewport viewport_;
  Cull cull_;
};

}  // namespace spanline
