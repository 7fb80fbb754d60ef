#pragma once
#include <cstddef>
#include <limits>

#include "drawing.hpp"

namespace spanline::contract {

/// Ids and depths (smaller is nearer) of a scene's screen triangles, pixel by pixel over all of them: coverage by edge
/// functions in 64 bits, the word of the plane equation as depth, and of equally near triangles the first. Shares no
/// idea with the algorithms, only what they all must share: the plane's word.
///
/// `kept`: of each row only that many triangles exist, those with the nearest corners, of equally near ones the first:
/// what is left where an algorithm has records for so many and no more (core/spanline/visibility/span/wake_bucket.hpp).
[[nodiscard]] Drawing brute_force(const Scene& scene, std::size_t kept = std::numeric_limits<std::size_t>::max());

/// Pixels whose id is that of a triangle that does not cover them, or of none that exists.
[[nodiscard]] std::size_t garbage_pixels(const Scene& scene, const Drawing& ids);

}  // namespace spanline::contract
