#pragma once
#include <array>
#include <cstdint>

#include "spanline/math/fixed.hpp"
#include "spanline/math/integer.hpp"

namespace spanline {

/// A vector of three components in one format. The names of variables say which space (model, world, view) they are in.
template <class T>
struct Vec3 {
  T x{}, y{}, z{};
  friend constexpr Vec3 operator+(Vec3 a, Vec3 b) {
    return {static_cast<T>(a.x + b.x), static_cast<T>(a.y + b.y), static_cast<T>(a.z + b.z)};
  }
  friend constexpr Vec3 operator-(Vec3 a, Vec3 b) {
    return {static_cast<T>(a.x - b.x), static_cast<T>(a.y - b.y), static_cast<T>(a.z - b.z)};
  }
  constexpr Vec3 operator-() const { return {static_cast<T>(-x), static_cast<T>(-y), static_cast<T>(-z)}; }
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

using Direction = Vec3<Q2_30>;  ///< a unit vector
using Position = Vec3<Q16_16>;  ///< a point in world units

/// a·b for unit vectors, in [−1, 1]. Each of the three products is rounded.
[[nodiscard]] constexpr Q2_30 dot(Direction a, Direction b) {
  return multiply<Q2_30>(a.x, b.x) + multiply<Q2_30>(a.y, b.y) + multiply<Q2_30>(a.z, b.z);
}

/// a×b for unit vectors.
[[nodiscard]] constexpr Direction cross(Direction a, Direction b) {
  return {multiply<Q2_30>(a.y, b.z) - multiply<Q2_30>(a.z, b.y), multiply<Q2_30>(a.z, b.x) - multiply<Q2_30>(a.x, b.z),
          multiply<Q2_30>(a.x, b.y) - multiply<Q2_30>(a.y, b.x)};
}

/// The unit vector along (x, y, z), integers of any common scale up to 2^62; (0, 0, 0) gives (0, 0, 0). The error is at
/// most 2^-28 in each component.
[[nodiscard]] constexpr Direction normalise(std::int64_t x, std::int64_t y, std::int64_t z) {
  const auto absolute = [](std::int64_t v) { return static_cast<std::uint64_t>(v < 0 ? -v : v); };
  const std::uint64_t greatest = absolute(x) | absolute(y) | absolute(z);
  if (greatest == 0) return {};
  // Scale the greatest component to 30 bits: the sum of squares then fits 62 bits, and the root has 30 exact bits.
  const int shift = 34 - std::countl_zero(greatest);
  const auto scale = [shift](std::int64_t v) { return shift >= 0 ? v >> shift : v * (std::int64_t{1} << -shift); };
  x = scale(x);
  y = scale(y);
  z = scale(z);
  const auto length = static_cast<std::int64_t>(square_root(static_cast<std::uint64_t>(x * x + y * y + z * z)));
  const auto component = [length](std::int64_t v) {
    return Q2_30::from_raw(static_cast<std::int32_t>(divide_rounded(v * (std::int64_t{1} << 30), length)));
  };
  return {component(x), component(y), component(z)};
}

/// The unit vector that points from `from` to `to`.
[[nodiscard]] constexpr Direction direction_between(Position from, Position to) {
  const auto difference = [](Q16_16 a, Q16_16 b) { return static_cast<std::int64_t>(b.raw()) - a.raw(); };
  return normalise(difference(from.x, to.x), difference(from.y, to.y), difference(from.z, to.z));
}

}  // namespace spanline
