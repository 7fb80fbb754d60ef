#pragma once
#include "spanline/math/matrix.hpp"

namespace spanline {

/// Where an instance stands: world = translation + scale · (rotation · model). One scale for all axes keeps normals
/// normal; the converter bakes other scales into the mesh.
struct Transform {
  Rotation rotation{};
  Fixed<24> scale = Fixed<24>::from_int(1);  ///< (0, 128)
  Position translation{};
};

}  // namespace spanline
