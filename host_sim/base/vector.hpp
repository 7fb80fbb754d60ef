#pragma once
#include <cmath>

namespace spanline::sim {

/// Three doubles: a point or a direction on the host's side, where floats are allowed.
struct Vector3 {
  double x = 0, y = 0, z = 0;
  friend constexpr Vector3 operator+(Vector3 a, Vector3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vector3 operator-(Vector3 a, Vector3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vector3 operator*(Vector3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
  constexpr Vector3 operator-() const { return {-x, -y, -z}; }
  friend constexpr bool operator==(const Vector3&, const Vector3&) = default;
};

[[nodiscard]] constexpr double dot(Vector3 a, Vector3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

[[nodiscard]] constexpr Vector3 cross(Vector3 a, Vector3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

[[nodiscard]] inline double greatest_component(Vector3 v) {
  return std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z)));
}

[[nodiscard]] inline bool finite(Vector3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Length without overflow or underflow of the squares.
[[nodiscard]] inline double length(Vector3 v) {
  const double greatest = greatest_component(v);
  if (greatest == 0 || !std::isfinite(greatest)) return greatest;
  const Vector3 scaled{v.x / greatest, v.y / greatest, v.z / greatest};
  return greatest * std::sqrt(dot(scaled, scaled));
}

/// The unit vector along v; the zero vector for a vector that has no direction.
[[nodiscard]] inline Vector3 normalised(Vector3 v) {
  const double greatest = greatest_component(v);
  if (greatest == 0 || !std::isfinite(greatest)) return {};
  const Vector3 scaled{v.x / greatest, v.y / greatest, v.z / greatest};
  const double size = std::sqrt(dot(scaled, scaled));
  return {scaled.x / size, scaled.y / size, scaled.z / size};
}

/// Turns v about the unit vector `axis` by `radians`, counter-clockwise when looking against it (Rodrigues' formula).
[[nodiscard]] inline Vector3 rotated(Vector3 v, Vector3 axis, double radians) {
  const double c = std::cos(radians), s = std::sin(radians);
  return v * c + cross(axis, v) * s + axis * (dot(axis, v) * (1 - c));
}

/// A point's map: three rows of a linear part and a translation.
struct Affine {
  Vector3 row[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Vector3 translation{};

  [[nodiscard]] Vector3 direction(Vector3 v) const { return {dot(row[0], v), dot(row[1], v), dot(row[2], v)}; }
  [[nodiscard]] Vector3 point(Vector3 v) const { return direction(v) + translation; }
  [[nodiscard]] double determinant() const { return dot(row[0], cross(row[1], row[2])); }
  /// Normals go by the inverse transposed. The cofactors are that times the determinant, whose sign is taken out; the
  /// result is not of unit length.
  [[nodiscard]] Vector3 normal(Vector3 n) const {
    const Vector3 mapped{dot(cross(row[1], row[2]), n), dot(cross(row[2], row[0]), n), dot(cross(row[0], row[1]), n)};
    return determinant() < 0 ? -mapped : mapped;
  }
  friend Affine operator*(const Affine& a, const Affine& b) {
    Affine product;
    for (int i = 0; i < 3; ++i) product.row[i] = b.row[0] * a.row[i].x + b.row[1] * a.row[i].y + b.row[2] * a.row[i].z;
    product.translation = a.point(b.translation);
    return product;
  }
};

}  // namespace spanline::sim
