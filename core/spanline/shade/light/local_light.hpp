#pragma once
#include <cstdint>

#include "spanline/model/camera.hpp"
#include "spanline/model/light.hpp"
#include "spanline/model/material.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/model/transform.hpp"
#include "spanline/pixel/pixel_format.hpp"

namespace spanline {

/// What reaches the eye from a point of a surface: of its colour, and of its highlights' colour.
struct SurfaceLight {
  Intensity diffuse, highlight;  ///< [0, 65535]
};

/// Light that depends on where a surface is, and on the eye: every light of a frame, of either kind, and the highlights
/// of a material, as one instance sees them, in its mesh's own axes.
///
///     diffuse   = min(1, ambient + Σ i · max(0, N·L))
///     highlight = min(1, Σ i · max(0, R·V)^shininess) over the lights with N·L > 0, R = 2(N·L)N − L
///
/// with L towards the light, V towards the eye, and i its intensity there (lecture 003; Phong 1975). An orthographic
/// view has the same V everywhere. Within 1/1024 of the formula (tested).
class LocalLighting {
 public:
  LocalLighting() = default;
  LocalLighting(const Lighting& lighting, const Camera& camera, const Mesh& mesh, const Transform& transform,
                const Material& material);

  [[nodiscard]] bool shines() const { return specular_ != Rgb888{0, 0, 0}; }
  [[nodiscard]] Rgb888 specular() const { return specular_; }

  /// The light on a vertex of the mesh; full where it has no normals.
  [[nodiscard]] SurfaceLight at_vertex(std::size_t vertex) const;
  /// The light on a polygon of the mesh: at the mean of its corners. In a mesh with polygons of more than three corners
  /// it counts its way to the polygon.
  [[nodiscard]] SurfaceLight on_polygon(std::uint32_t polygon) const;

 private:
  /// Units of 2^-exponent_ steps of the mesh.
  using Point = Vec3<std::int64_t>;
  struct Light {
    Direction towards;  ///< of a directional light
    Point position;     ///< of a point light
    std::int64_t range;
    std::uint32_t intensity;  ///< 1/65536
    bool point;
  };

  [[nodiscard]] Point local_point(const Position& position, const Transform& transform) const;
  [[nodiscard]] std::int64_t local_length(std::int64_t numerator, int fraction_bits, const Transform& transform) const;
  [[nodiscard]] Point vertex_point(std::size_t vertex) const;
  [[nodiscard]] SurfaceLight at(const Point& point, PackedNormal normal) const;

  const Mesh* mesh_ = nullptr;
  int exponent_ = 0;
  std::uint32_t ambient_ = 0;
  std::uint32_t light_count_ = 0;
  Light lights_[2 * Lighting::max_lights] = {};
  bool local_eye_ = false;
  Point eye_{};          ///< in perspective
  Direction backwards_;  ///< in an orthographic view
  Rgb888 specular_{0, 0, 0};
  std::uint8_t shininess_ = 1;
};

/// Gouraud light: a shade for every vertex of the mesh. With highlights all are lit colours, otherwise as in
/// `shade_vertices`.
void shade_vertices_locally(const Mesh& mesh, Rgb888 colour, const LocalLighting& lighting, std::uint32_t* shades);
/// The same for solids: light and highlight (Kind::highlight_and_intensity).
void shade_solid_vertices_locally(const Mesh& mesh, const LocalLighting& lighting, std::uint32_t* shades);

}  // namespace spanline
