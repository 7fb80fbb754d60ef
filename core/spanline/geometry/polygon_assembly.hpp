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
#include "spanline/raster/band_of_row.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/raster/polygon_table.hpp"

namespace spanline {

/// The lectures' sets of a frame: V = ((P \ F) \ B) \ O (lecture 002 and 001). What is neither outside nor culled was
/// submitted to visibility. Polygons count as the triangles of their fans.
struct PolygonCounts {
  std::uint32_t total = 0;    ///< P
  std::uint32_t outside = 0;  ///< F: outside the view
  std::uint32_t back = 0;     ///< B: left out by orientation
};

/// Puts the polygons of one instance into the polygon table: orientation, rejection and clipping, sorted into bands by
/// their first row. Polygons that find no room are left out and counted.
class PolygonAssembly {
 public:
  PolygonAssembly(PolygonTable& table, const BandOfRow& band_of_row, Viewport viewport, Cull cull)
      : table_(table), band_of_row_(band_of_row), viewport_(viewport), cull_(cull) {}

  /// What clipping needs of an instance; null pointers where its placement rules clipping out.
  struct ClipContext {
    const Clipper* clipper = nullptr;
    const ViewTransform* transform = nullptr;
    const PointProjection* projection = nullptr;
    TextureVertexMaker textures{};
    VertexStore* store = nullptr;
  };

  /// Assembles all polygons of `mesh`, whose vertices are at `vertices`; `scissored` where it may leave the viewport.
  void run(const Mesh& mesh, const ScreenVertex* vertices, bool scissored, const ClipContext& clip);

  /// Assembles triangles whose corners stand three by three in `vertices`.
  void run_screen(std::span<const ScreenVertex> vertices);

  PolygonCounts counts;
  std::uint32_t polygons_wanted = 0;  ///< that found the polygon pool full
  std::uint32_t fans_wanted = 0;      ///< that found the fan pool full

 private:
  template <bool Scissored>
  void run_triangles(const Mesh& mesh, const ScreenVertex* vertices, const ClipContext& clip);
  template <bool Scissored, Cull Culled>
  void run_triangles(const Mesh& mesh, const ScreenVertex* vertices, const ClipContext& clip);
  void run_polygons(const Mesh& mesh, const ScreenVertex* vertices, bool scissored, const ClipContext& clip);
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
