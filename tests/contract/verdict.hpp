#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "drawing.hpp"

namespace spanline::contract {

// What is wrong with a picture; empty if nothing is.

/// Pixels, and depths where both have them.
[[nodiscard]] std::string difference(const Drawing& want, const Drawing& got);

/// `owners` shows which polygon the reference has where: its pixels are ids. A pixel lies at an edge or split if one of
/// its eight neighbours belongs to another polygon, or to the background.
[[nodiscard]] std::string far_difference(const Drawing& want, const Drawing& got, const Drawing& owners);

/// Of an order-bound algorithm: a pixel that an order decides (ordered_pixels.hpp), or that no polygon covers, is not
/// the reference's; or a polygon is missing where pictures are of ids.
[[nodiscard]] std::string disorder(const Drawing& want, const Drawing& got, const Drawing& owners,
                                   const std::vector<bool>& ordered);

/// By class.
[[nodiscard]] std::string fault_of(Exactness exactness, const Drawing& want, const Drawing& got, const Drawing& owners,
                                   const Scene& scene);

/// Draws a scene by an algorithm, or as all of them must.
struct Drawer {
  Drawing (*by)(const AlgorithmEntry&, const Scene&, const Manner&);
  Drawing (*reference)(const Scene&, Manner);
};

/// Draws the scene by every algorithm that is listed, and holds each against its class; also against its counters.
[[nodiscard]] std::string fault_in(const Scene& scene, const Manner& manner, const Drawer& drawer = {draw, reference});

}  // namespace spanline::contract
