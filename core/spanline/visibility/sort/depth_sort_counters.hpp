#pragma once
#include <string_view>

namespace spanline {

/// Depth sort's own counters: their indices in VisibilityCounters::own. The first seven count the pairs of polygons
/// that each of the overlap tests decided; N is the one that the sort takes for the nearer, F the farther one. Polygons
/// whose depth extents do not overlap are no pairs. A pair is counted in every band that it
/// reaches into, and again after one of them was moved.
struct DepthSortCounter {
  enum Place : unsigned {
    x_extents,          ///< their columns do not overlap
    y_extents,          ///< their rows do not overlap
    behind_plane,       ///< all of F is on the opposite side of N from the eye
    in_front_of_plane,  ///< all of N is on the same side of F as the eye
    projections,        ///< their projections do not overlap
    swapped_in_front,   ///< all of F is on the same side of N as the eye
    swapped_behind,     ///< all of N is on the opposite side of F from the eye
    moves,              ///< polygons that were moved before another one in the list
    resolved,           ///< pairs that were compared row by row
    knots,              ///< groups of see-through polygons that were laid row by row, since they penetrate
    crossings,          ///< columns where see-through polygons cross each other or an opaque one
    shaded              ///< all pixels written, the background included, see-through surfaces not
  };
};

inline constexpr std::string_view depth_sort_counter_names[] = {
    "x_extents", "y_extents", "behind_plane", "in_front_of_plane", "projections", "swapped_in_front", "swapped_behind",
    "moves",     "resolved",  "knots",        "crossings",         "shaded"};

}  // namespace spanline
