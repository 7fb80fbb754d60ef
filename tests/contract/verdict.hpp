#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

#include "drawing.hpp"

namespace spanline::contract {

/// What an algorithm promises (design: visibility).
enum class Exactness : std::uint8_t {
  exact,        ///< the z-buffer's bytes, always
  near_exact,   ///< at most 1 % of the pixels differ, each within one pixel of an edge or split
  order_bound,  ///< the z-buffer's picture where no two polygons overlap in depth
};

/// The class that the list states; throws for a word that is none.
[[nodiscard]] Exactness exactness_of(const sim::VisibilityEntry& entry);

// What is wrong with a picture; empty if nothing is.

/// Pixels, and depths where both have them.
[[nodiscard]] std::string difference(const Drawing& want, const Drawing& got);

/// `owners` shows which polygon the reference has where: its pixels are ids. A pixel lies at an edge or split if one of
/// its eight neighbours belongs to another polygon, or to the background.
[[nodiscard]] std::string far_difference(const Drawing& want, const Drawing& got, const Drawing& owners);

/// By class. `depths_overlap`: whether polygons of the scene do.
[[nodiscard]] std::string fault_of(Exactness exactness, const Drawing& want, const Drawing& got, const Drawing& owners,
                                   bool depths_overlap);

/// Draws a scene by an algorithm, or as all of them must.
struct Drawer {
  Drawing (*by)(const sim::VisibilityEntry&, const Scene&, const Manner&);
  Drawing (*reference)(const Scene&, Manner);
};

/// Draws the scene by every algorithm that is listed, and holds each against its class; also against its counters.
[[nodiscard]] std::string fault_in(const Scene& scene, const Manner& manner, const Drawer& drawer = {draw, reference});

}  // namespace spanline::contract
