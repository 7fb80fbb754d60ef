#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "render/frame.hpp"
#include "render/frame_pass.hpp"

namespace spanline::sim {

/// Divides the obscured triangles of a frame by what hides them. `ids` is the frame's picture of ids, `obscured` holds
/// for the triangles that cover a pixel centre and are seen at none, and `objects` has the number of the object of each
/// triangle; if it is empty, there is one object. Each obscured triangle is in one of the three sets.
///
/// It takes the frame's polygons as the renderer does, on the same snapped corners, and walks the rows of the obscured
/// ones without a depth test: a pixel that such a triangle covers is hidden by the triangle that the picture shows
/// there.
[[nodiscard]] ObscuredBy divide_obscured(const PassInput& input, const std::vector<std::uint32_t>& ids,
                                         const std::vector<bool>& obscured, std::span<const std::uint32_t> objects);

}  // namespace spanline::sim
