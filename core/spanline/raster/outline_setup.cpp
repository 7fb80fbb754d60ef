#include "spanline/raster/outline_setup.hpp"

#include "spanline/raster/medium_triangle.hpp"

namespace spanline {
namespace {

FixedEdge medium_edge(const OutlineSide& side, std::int32_t origin, std::int32_t row) {
  FixedEdge edge = medium_triangle::edge_from(medium_triangle::start_of_edge(side.upper->x - 16 * origin), side.dx(),
                                              side.dy(), side.offset());
  edge.column += edge.step * word(row - side.first_row());
  return edge;
}

}  // namespace

void place_wide_edges(const OutlineSides& sides, const PlacedOutline& outline, ActiveTriangle& active) {
  const auto [left, right] = sides;
  if (outline.header.size() == ActiveTriangle::Size::large) {
    active.large = {Edge::between(*left.upper, *left.lower, active.row),
                    Edge::between(*right.upper, *right.lower, active.row)};
    return;
  }
  const FixedEdge on_left = medium_edge(left, outline.origin, active.row);
  const FixedEdge on_right = medium_edge(right, outline.origin, active.row);
  active.fixed.left = on_left.column;
  active.fixed.left_step = on_left.step;
  active.fixed.right = on_right.column;
  active.fixed.right_step = on_right.step;
}

void place_outline_edges(const PlacedOutline& outline, ActiveTriangle& active) { place_edges(outline, active); }

}  // namespace spanline
