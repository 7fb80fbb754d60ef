#pragma once
#include <cstdint>
#include <span>

#include "spanline/geometry/clipper.hpp"
#include "spanline/geometry/projection.hpp"
#include "spanline/geometry/texture_vertices.hpp"
#include "spanline/geometry/view_space.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/raster/polygon_table.hpp"

namespace spanline {

/// Which polygons are left out by the sign of their area on screen. Front faces are counter-clockwise.
enum class Cull : std::uint8_t { back, front, none };

/// The lectures' sets of a frame: V = ((P \ F) \ B) \ O (lecture 002 and 001). What is neither outside nor culled was
/// submitted to visibility. Polygons count as the triangles of their fans.
struct PolygonCounts {
  std::uint32_t total = 0;    ///< P
  std::uint32_t outside = 0;  ///< F: outside the view
  std::uint32_t back = 0;     ///< B: left out by orientation
};

/// Divides rows into bands: row / lines without a divide. The inverse is rounded up, by less than 1; over 2,047 rows
/// that is less than 2^11 / 2^shift < 1 / lines, so no row reaches the next band by it.
class BandOfRow {
 public:
  BandOfRow() = default;
  /// lines in [1, 2047].
  explicit BandOfRow(std::uint32_t lines) : shift_(52 - leading_zeros_32(lines)) {
    inverse_ = ((1u << shift_) + lines - 1) / lines;  // at most 2^21
  }
  /// row in [0, 2047].
  [[nodiscard]] std::int32_t operator()(std::int32_t row) const {
    return signed_word((word(row) * inverse_) >> shift_);
  }

 private:
  std::uint32_t inverse_ = 1u << 21;
  int shift_ = 21;
};

/// Room for vertices, with their shades and textures, that clipping makes, behind those of the instance.
struct VertexStore {
  std::span<ScreenVertex> vertices;   ///< of the instance: its own come first
  std::span<std::uint32_t> shades;    ///< parallel to `vertices`, or empty
  std::span<TextureVertex> textures;  ///< parallel to `vertices`, or empty
  std::span<std::int32_t> thirds;     ///< third texture coordinates, parallel to `textures`, or empty
  Link count = 0;                     ///< in use
  std::uint32_t wanted_vertices = 0;  ///< that did not fit
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
