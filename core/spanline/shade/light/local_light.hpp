#pragma once
#include <cstdint>

#include "spanline/model/camera.hpp"
#include "spanline/model/light.hpp"
#include "spanline/model/material.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/model/transform.hpp"
#include "spanline/pixel/pixel_format.hpp"

namespace spanline {

/// The light that a point of a surface reflects to the eye, split by the colour that it multiplies: the surface's, and
/// the highlights'.
struct SurfaceLight {
  Intensity diffuse, highlight;  ///< 1/65536, [0, 65535]
};

/// Light that depends on the position of a surface and of the eye: all lights of a frame, directional and point lights,
/// and the highlights of a material. It is computed for one instance, in the axes of its mesh.
///
///     diffuse   = min(1, ambient + Σ i · max(0, N·L))
///     highlight = min(1, Σ i · max(0, R·V)^shininess) over the lights with N·L > 0, R = 2(N·L)N − L
///
/// where L points to the light, V points to the eye, and i is the light's intensity at the surface (lecture 003; Phong
/// 1975). In an orthographic view V is constant. The error is at most 1/1024 (tested).
class LocalLighting {
 public:
  LocalLighting() = default;
  LocalLighting(const Lighting& lighting, const Camera& camera, const Mesh& mesh, const Transform& transform,
                const Material& material);

  [[nodiscard]] bool shines() const { return specular_ != Rgb888{0, 0, 0}; }
  [[nodiscard]] Rgb888 specular() const { return specular_; }

  /// The light at a vertex of the mesh; full light if the mesh has no normals.
  [[nodiscard]] SurfaceLight at_vertex(std::size_t vertex) const;
  /// The light on a polygon of the mesh, taken at the mean of its corners. In a mesh with polygons of more than three
  /// corners the polygon is found by counting from the first one.
  [[nodiscard]] SurfaceLight on_polygon(std::uint32_t polygon) const;

 private:
  /// A position in the mesh's axes, units of 2^-exponent_ mesh steps.
  using Point = Vec3<std::int64_t>;
  struct Light {
    Direction towards;  ///< unit vector to the light; directional lights only
    Point position;     ///< point lights only
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
  Point eye_{};          ///< position of the eye; perspective views only
  Direction backwards_;  ///< unit vector to the eye; orthographic views only
  Rgb888 specular_{0, 0, 0};
  std::uint8_t shininess_ = 1;
};

/// Gouraud shading: computes the shade of every vertex of the mesh. With highlights all shades are lit colours;
/// otherwise their kind is that of `shade_vertices`.
void shade_vertices_locally(const Mesh& mesh, Rgb888 colour, const LocalLighting& lighting, std::uint32_t* shades);
/// Computes the shades of a solid's vertices: intensity and highlight (Kind::highlight_and_intensity).
void shade_solid_vertices_locally(const Mesh& mesh, const LocalLighting& lighting, std::uint32_t* shades);

}  // namespace spanline
