#pragma once
#include "spanline/math/matrix.hpp"

namespace spanline {

/// Where an instance stands: world = translation + scale · (rotation · model). One scale for all axes keeps normals
/// normal; the converter bakes other scales into the mesh.
struct Transform {
  Rotation rotation{};
  Q16_16 scale = Q16_16::from_int(1);  ///< (0, 256)
  Position translation{};
};

}  // namespace spanline
