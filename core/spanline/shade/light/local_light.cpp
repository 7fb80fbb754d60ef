#include "spanline/shade/light/local_light.hpp"

#include <algorithm>

#include "spanline/math/bits.hpp"
#include "spanline/math/integer.hpp"
#include "spanline/math/inverse_root.hpp"
#include "spanline/math/power.hpp"
#include "spanline/shade/light/gouraud.hpp"

namespace spanline {
namespace {

constexpr std::uint32_t full = 65535;
constexpr std::int32_t unit = 1 << 30;
/// The most fraction bits of a mesh step, used where nothing is far away, and the bits of a coordinate.
constexpr int finest_exponent = 8, coordinate_bits = 44;

/// N·v, Q30, of a packed normal and a unit vector.
std::int32_t on(PackedNormal n, const Direction& v) {
  // Components are cut to 20 fraction bits, so that the sum fits 32 bits.
  const std::int32_t sum = n.x() * (v.x.raw() >> 10) + n.y() * (v.y.raw() >> 10) + n.z() * (v.z.raw() >> 10);
  constexpr std::int64_t q30_a_unit = ((std::int64_t{1} << 42) + 255) / 511;
  return static_cast<std::int32_t>((sum * q30_a_unit) >> 32);
}

std::int32_t product(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>((static_cast<std::int64_t>(a) * b) >> 30);
}

/// The fading of a point light with distance, (1 − distance²/range²)², 65536ths.
std::uint32_t fading(const DirectedLength& distance, std::int64_t range) {
  // The range is converted to the units of the distance, which has 30 bits. Both are then shifted so that the range
  // fits 31 bits.
  const int range_bits = 64 - leading_zeros_64(static_cast<std::uint64_t>(range) | 1) - distance.exponent;
  if (range_bits > 60) return 65536;
  std::int64_t scaled =
      distance.exponent >= 0 ? range >> distance.exponent : range * (std::int64_t{1} << -distance.exponent);
  const int excess = std::max(0, range_bits - 31);
  scaled >>= excess;
  const std::uint64_t square = distance.square >> 2 * excess;
  const auto whole = static_cast<std::uint64_t>(scaled) * static_cast<std::uint64_t>(scaled);
  if (square >= whole) return 0;
  // Both squares are below 2^62; the quotient needs 16 fraction bits.
  const std::uint64_t share = (whole >> 46) != 0 ? square / (whole >> 16) : (square << 16) / whole;
  const std::uint32_t left = share >= 65536 ? 0 : 65536 - static_cast<std::uint32_t>(share);
  return static_cast<std::uint32_t>((std::uint64_t{left} * left) >> 16);
}

}  // namespace

LocalLighting::LocalLighting(const Lighting& lighting, const Camera& camera, const Mesh& mesh,
                             const Transform& transform, const Material& material)
    : mesh_(&mesh),
      ambient_(static_cast<std::uint32_t>(std::clamp<std::int32_t>(lighting.ambient.raw(), 0, full))),
      local_eye_(camera.projection == Projection::perspective),
      backwards_(transform.rotation.transposed() * camera.axes.row[2]),
      specular_(material.specular),
      shininess_(std::clamp<std::uint8_t>(material.shininess, 1, 128)) {
  // The exponent leaves room for the farthest point: a difference of positions has at most 2^17 world units a
  // component.
  constexpr int world_log2 = 19;
  const int scale_log2 =
      64 - leading_zeros_64(static_cast<std::uint64_t>(std::max<std::int32_t>(1, transform.scale.raw()))) - 24;
  exponent_ = std::min(
      {finest_exponent, coordinate_bits - 1 - (world_log2 - scale_log2 - mesh.step_exponent), coordinate_bits - 33});
  const std::size_t directional = std::min(lighting.lights.size(), Lighting::max_lights);
  for (std::size_t i = 0; i < directional; ++i) {
    const DirectionalLight& light = lighting.lights[i];
    lights_[light_count_++] = {transform.rotation.transposed() * light.towards,
                               {},
                               0,
                               word(std::max<std::int32_t>(0, light.intensity.raw())),
                               false};
  }
  const std::size_t points = std::min(lighting.point_lights.size(), Lighting::max_lights);
  for (std::size_t i = 0; i < points; ++i) {
    const PointLight& light = lighting.point_lights[i];
    lights_[light_count_++] = {{},
                               local_point(light.position, transform),
                               local_length(light.range.raw(), 16, transform),
                               word(std::max<std::int32_t>(0, light.intensity.raw())),
                               true};
  }
  eye_ = local_point(camera.eye, transform);
}

/// Converts a length in world units with `fraction_bits` fraction bits to units of the mesh: divides it by the scale,
/// which has 24 fraction bits, and by 2^step_exponent.
std::int64_t LocalLighting::local_length(std::int64_t numerator, int fraction_bits, const Transform& transform) const {
  if (numerator == 0) return 0;
  const auto size = static_cast<std::uint64_t>(numerator < 0 ? -numerator : numerator);
  const int room = leading_zeros_64(size) - 1;
  const std::int64_t quotient =
      numerator * (std::int64_t{1} << room) / std::max<std::int32_t>(1, transform.scale.raw());
  const int shift = fraction_bits - 24 + room + mesh_->step_exponent - exponent_;
  return shift > 62 ? 0 : shift_rounded(quotient, shift);
}

LocalLighting::Point LocalLighting::local_point(const Position& position, const Transform& transform) const {
  const auto difference = [](Q16_16 a, Q16_16 b) { return static_cast<std::int64_t>(a.raw()) - b.raw(); };
  const std::int64_t x = difference(position.x, transform.translation.x),
                     y = difference(position.y, transform.translation.y),
                     z = difference(position.z, transform.translation.z);
  const auto component = [&](int axis) {
    const Direction along = transform.rotation.column(axis);
    return local_length(along.x.raw() * x + along.y.raw() * y + along.z.raw() * z, 46, transform);
  };
  return {component(0), component(1), component(2)};
}

LocalLighting::Point LocalLighting::vertex_point(std::size_t vertex) const {
  const auto coordinate = [&](std::int64_t steps, std::int32_t offset) {
    return shift_rounded(steps + offset, -exponent_);
  };
  const Vec3<std::int32_t>& offset = mesh_->offset;
  const Vertex32 v = mesh_->vertex(vertex);
  return {coordinate(v.x, offset.x), coordinate(v.y, offset.y), coordinate(v.z, offset.z)};
}

SurfaceLight LocalLighting::at(const Point& point, PackedNormal normal) const {
  Direction to_eye = backwards_;
  std::int32_t eye_cosine = 0;
  if (shines()) {
    if (local_eye_) to_eye = direction_and_length(eye_.x - point.x, eye_.y - point.y, eye_.z - point.z).direction;
    eye_cosine = on(normal, to_eye);
  }
  std::uint64_t diffuse = ambient_, highlight = 0;
  for (std::uint32_t i = 0; i < light_count_; ++i) {
    const Light& light = lights_[i];
    Direction towards = light.towards;
    std::uint64_t intensity = light.intensity;
    if (light.point) {
      const DirectedLength way =
          direction_and_length(light.position.x - point.x, light.position.y - point.y, light.position.z - point.z);
      towards = way.direction;
      if (light.range != 0) intensity = intensity * fading(way, light.range) >> 16;
    }
    const std::int32_t cosine = on(normal, towards);
    if (cosine <= 0 || intensity == 0) continue;
    diffuse += intensity * word(cosine) >> 30;
    if (!shines()) continue;
    const std::int32_t between = dot(towards, to_eye).raw(), mirrored = product(cosine, eye_cosine);
    const std::int64_t along = std::int64_t{2} * mirrored - between;  // R·V
    if (along > 0)
      highlight +=
          intensity * power(word(static_cast<std::int32_t>(std::min<std::int64_t>(along, unit))), shininess_) >> 16;
  }
  const auto saturated = [](std::uint64_t value) {
    return static_cast<Intensity>(std::min<std::uint64_t>(value, full));
  };
  return {saturated(diffuse), saturated(highlight)};
}

SurfaceLight LocalLighting::at_vertex(std::size_t vertex) const {
  if (mesh_->vertex_normals.empty()) return {full, 0};
  return at(vertex_point(vertex), mesh_->vertex_normals[vertex]);
}

SurfaceLight LocalLighting::on_polygon(std::uint32_t polygon) const {
  if (mesh_->polygon_normals.empty()) return {full, 0};
  const std::size_t first = mesh_->first_corner(polygon), corners = std::max(1u, mesh_->corner_count(polygon));
  Point sum{};
  for (std::size_t i = 0; i < corners; ++i) sum = sum + vertex_point(mesh_->indices[first + i]);
  const auto count = static_cast<std::int64_t>(corners);
  return at({sum.x / count, sum.y / count, sum.z / count}, mesh_->polygon_normals[polygon]);
}

void shade_vertices_locally(const Mesh& mesh, Rgb888 colour, const LocalLighting& lighting, std::uint32_t* shades) {
  const std::size_t count = mesh.vertex_count();
  for (std::size_t i = 0; i < count; ++i) {
    const SurfaceLight light = lighting.at_vertex(i);
    const Rgb888 own = mesh.vertex_colours.empty() ? colour : mesh.vertex_colours[i];
    if (lighting.shines())
      shades[i] = gouraud::shade_of(own, light.diffuse, lighting.specular(), light.highlight);
    else if (mesh.vertex_colours.empty())
      shades[i] = gouraud::shade_of(light.diffuse);
    else
      shades[i] = gouraud::shade_of(own, light.diffuse);
  }
}

void shade_solid_vertices_locally(const Mesh& mesh, const LocalLighting& lighting, std::uint32_t* shades) {
  const std::size_t count = mesh.vertex_count();
  for (std::size_t i = 0; i < count; ++i) {
    const SurfaceLight light = lighting.at_vertex(i);
    shades[i] = vertex_shade::pack(gouraud::shade_of(light.highlight), gouraud::shade_of(light.diffuse));
  }
}

}  // namespace spanline
