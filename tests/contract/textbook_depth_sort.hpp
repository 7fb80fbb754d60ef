#pragma once
#include <cstddef>
#include <cstdint>
#include <list>
#include <vector>

#include "drawing.hpp"
#include "spanline/raster/linear_function.hpp"
#include "support/exact_triangle.hpp"

namespace spanline::contract {

/// Depth sort as lecture 002 writes it down ("Newell, Newell, Sancha Algorithm"): the polygons are sorted by depth,
/// rearrange(P, Q) puts pairs in order or splits P, and what comes out is drawn from back to front without any
/// comparison of pixels. Plain and slow.
///
/// A fragment is a set of pixels. A split sorts P's pixels by whether P is in front of Q's plane there; since that is
/// the comparison that makes a z-buffer's picture, the two pictures must be the same. "All of Q" in a test means Q at
/// all of its pixels.
class TextbookDepthSort {
 public:
  /// The screen triangles of a scene, which must stay.
  explicit TextbookDepthSort(const Scene& scene);

  /// Ids and depths, smaller is nearer.
  [[nodiscard]] const Drawing& drawing() const { return drawing_; }
  /// How often a polygon was moved before another one, and how often one was split.
  [[nodiscard]] int moves() const { return moves_; }
  [[nodiscard]] int splits() const { return splits_; }

 private:
  struct Pixel {
    int x, y;
  };
  struct Fragment {
    std::uint32_t id;
    std::vector<Pixel> pixels;  ///< row by row, each from left to right
    int left, right, top, bottom;
    bool was_moved = false;

    Fragment(std::uint32_t id, std::vector<Pixel> pixels);
    [[nodiscard]] bool holds(Pixel pixel) const;
  };
  struct Polygon {
    test::ExactTriangle exact;
    LinearFunction plane;
    std::int32_t nearest, farthest;  ///< of its corners

    [[nodiscard]] std::uint32_t depth(Pixel pixel) const;
  };
  using Fragments = std::list<Fragment>;
  enum class Order : std::uint8_t { kept, exchanged, split };

  [[nodiscard]] bool in_front(std::uint32_t a, std::uint32_t b, Pixel pixel) const;
  /// Whether all of `f` is in front of a polygon's plane, or all of it behind.
  [[nodiscard]] bool all_in_front(const Fragment& f, std::uint32_t plane) const;
  [[nodiscard]] bool all_behind(const Fragment& f, std::uint32_t plane) const;
  [[nodiscard]] bool overlap_in_depth(const Fragment& p, const Fragment& q) const;
  [[nodiscard]] static bool overlap_in_projection(const Fragment& p, const Fragment& q);
  [[nodiscard]] Order rearrange(const Fragment& p, const Fragment& q) const;
  /// Puts the parts of P in its place.
  void split(Fragments& list, Fragments::iterator p, const Fragment& q);
  /// Moves pieces before one another until the first of the list is in front of all others.
  void settle_first(Fragments& list);
  void paint(const Fragment& fragment);

  std::vector<Polygon> polygons_;  ///< by id; the first is none
  Drawing drawing_;
  int moves_ = 0, splits_ = 0;
};

}  // namespace spanline::contract
