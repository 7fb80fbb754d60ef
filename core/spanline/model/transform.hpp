#pragma once
/// @file
/// Where an instance of a mesh stands.
///
/// ```cpp
/// constexpr Transform turned{
///     .rotation = rotation_y(Angle::from_degrees(30)), .scale = 0.5_q24, .translation = {1.0_q16, {}, -2.0_q16}};
/// ```
#include "spanline/math/matrix.hpp"

namespace spanline {

/// The place of an instance: world = translation + scale · (rotation · model). A single scale for all axes keeps
/// normals perpendicular to their surfaces; the converter applies other scales to the mesh.
struct Transform {
  Rotation rotation{};                       ///< rows of Q2.30, orthonormal; the identity by default
  Fixed<24> scale = Fixed<24>::from_int(1);  ///< Q8.24, (0, 128); 1 by default
  Position translation{};                    ///< world units, Q16.16, (−32768, 32768); none by default
};

}  // namespace spanline
