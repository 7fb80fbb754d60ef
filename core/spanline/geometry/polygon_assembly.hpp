#pragma once
#include <cstdint>
#include <span>

#include "spanline/geometry/clipper.hpp"
#include "spanline/geometry/fan_lines.hpp"
#include "spanline/geometry/outline_layout.hpp"
#include "spanline/geometry/projection.hpp"
#include "spanline/geometry/texture_vertices.hpp"
#include "spanline/geometry/vertex_store.hpp"
#include "spanline/geometry/view_space.hpp"
#include "spanline/model/cull.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/model/polygon_range.hpp"
#include "spanline/raster/band_of_row.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/raster/outline.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/raster/vertex_shade.hpp"

namespace spanline {

/// The sizes of the lectures' sets of polygons, V = ((P \ F) \ B) \ O (lectures 001 and 002), in a frame. Polygons that
/// are neither outside nor culled are submitted to visibility. A polygon counts as the triangles of its fan.
struct PolygonCounts {
  std::uint32_t total = 0;    ///< P: all polygons
  std::uint32_t outside = 0;  ///< F: polygons outside the view
  std::uint32_t back = 0;     ///< B: polygons culled by their orientation
  /// Polygons of more than three corners that are one entry of the polygon table each. Their fans count above.
  std::uint32_t whole = 0;
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
    FanLineMaker fan_lines{};
  };

  /// Assembles the polygons of `range` of `mesh`, whose screen vertices are `vertices`. `scissored` says that the mesh
  /// may leave the viewport.
  void run(const Mesh& mesh, const ScreenVertex* vertices, bool scissored, const ClipContext& clip,
           const PolygonRange& range);

  /// Assembles triangles, each of three consecutive vertices.
  void run_screen(std::span<const ScreenVertex> vertices);
  /// Assembles polygons, each of as many consecutive vertices as its corner count says (as in Mesh::corners).
  void run_screen(std::span<const ScreenVertex> vertices, std::span<const std::uint8_t> corner_counts);

  /// Lets marked polygons (Mesh::planar) of more than three corners be one entry each. `shades` are those of the
  /// instance's vertices, or empty; a polygon over which they are not linear stays a fan.
  void keep_planar_polygons(int depth_bits, std::span<const std::uint32_t> shades, vertex_shade::Kind shade_kind) {
    keeps_planar_ = true;
    depth_bits_ = depth_bits;
    shades_ = shades;
    shade_kind_ = shade_kind;
  }

  PolygonCounts counts;
  std::uint32_t polygons_wanted = 0;  ///< polygons that found no room in the pool `polygons`
  std::uint32_t fans_wanted = 0;      ///< records that found no room in the pool `fans`

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
  /// Whether a polygon with this corner count is to be one entry, if it can be.
  [[nodiscard]] bool is_planar(std::uint8_t corner_count) const {
    return keeps_planar_ && corner_count > (3 | Mesh::planar);
  }
  bool take_planar(const Outline& outline, Link triangle, Link polygon);
  bool take_quad(const Outline& quad, Link triangle, Link polygon);
  bool take_screen_quad(const ScreenVertex* vertices, Link first, Link triangle, Link polygon);
  void take_screen_fan(const Outline& outline, Link triangle, Link polygon);
  bool take_any_planar(const Outline& outline, Link triangle, Link polygon);
  [[nodiscard]] bool has_linear_shades(const Outline& outline, unsigned reference) const;
  void enter(const Outline& outline, const OutlineLayout& layout, Link triangle, Link polygon);
  Link enter_with_lines(const Outline& outline, const OutlineLayout& layout, Link triangle, Link polygon,
                        unsigned lines);
  void divide_clipped(const Mesh& mesh, const ClipContext& clip, const Outline& corners);
  template <class Append>
  void enter_by(const OutlineLayout& layout, Link records, Append append);
  void enter_inlined(const Outline& outline, const OutlineLayout& layout, Link triangle, Link polygon);
  void take_fan_triangle(const Outline& outline, unsigned i, Link triangle, Link polygon);
  bool take_outside(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c, std::int32_t& band,
                    std::uint32_t& back) const;
  struct ClippedPolygon;
  void clip_triangle(const Mesh& mesh, const ClipContext& clip, const Outline& corners, Link triangle, Link polygon);
  bool take_clipped(ClippedPolygon& clipped, const ClipContext& clip, const Outline& corners, Link triangle,
                    Link polygon);
  bool clip_outline(const Mesh& mesh, const ClipContext& clip, const Outline& corners, Link triangle, Link polygon);
  PolygonTable& table_;
  BandOfRow band_of_row_;
  Viewport viewport_;
  Cull cull_;
  bool keeps_planar_ = false;
  bool clockwise_ = false;    ///< whether the outline `undivided_` is
  Link undivided_ = no_link;  ///< a record whose lines are still to be made
  int depth_bits_ = 16;
  std::span<const std::uint32_t> shades_;
  vertex_shade::Kind shade_kind_ = vertex_shade::Kind::intensity;
};

}  // namespace spanline
