#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "drawing.hpp"
#include "spanline/raster/linear_function.hpp"

namespace spanline::contract {

/// The spanning scan-line algorithm as lecture 002 writes it down ("Spanning Scan-Line", "Many Polygons !"): an edge
/// table ET, an active-edge table AET sorted by column, an in/out flag a polygon that every edge inverts, an in-polygon
/// list IPL in the order of depth, and a false edge wherever polygons cross inside a span ("Penetrating Polygons").
/// Plain and slow; columns are exact quotients.
class Textbook {
 public:
  /// An entry of the AET. The first and the last one, x0 and xN, are the borders of the picture.
  struct ActiveEdge {
    int column = 0;
    std::uint32_t polygon = 0;         ///< id; 0: a border, or a false edge
    std::size_t upper = 0, lower = 0;  ///< corners of the polygon
    bool is_false = false;
  };
  struct Row {
    std::vector<ActiveEdge> edges;                   ///< AET
    std::vector<std::vector<std::uint32_t>> inside;  ///< IPL behind each edge but the last: ids, nearest first;
                                                     ///< the background, which is always in, left out
  };

  /// The screen triangles of a scene, which must stay.
  explicit Textbook(const Scene& scene);

  [[nodiscard]] Row row(int y) const;
  /// Ids and depths, smaller is nearer.
  [[nodiscard]] Drawing draw() const;

 private:
  struct Edge {
    std::uint32_t polygon;
    std::size_t upper, lower;
    int first_row, end_row;  ///< ymax of the lecture
    std::int64_t x0, y0, dx, dy;

    [[nodiscard]] int column(int y) const;
  };

  [[nodiscard]] std::uint32_t depth(std::uint32_t id, int x, int y) const;
  /// The order of the IPL.
  [[nodiscard]] bool in_front(std::uint32_t a, std::uint32_t b, int x, int y) const;
  [[nodiscard]] std::uint32_t closest(const std::vector<std::uint32_t>& list, int x, int y) const;

  const Scene& scene_;
  std::vector<LinearFunction> planes_;  ///< PT
  std::vector<Edge> edges_;             ///< ET
};

}  // namespace spanline::contract
