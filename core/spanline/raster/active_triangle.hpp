#pragma once
#include <cstdint>

#include "spanline/raster/edge.hpp"
#include "spanline/raster/fixed_edges.hpp"
#include "spanline/raster/linear_function.hpp"

namespace spanline {

/// Exact edges of a triangle of any size. Two are stepped; the third is computed when its first row is reached.
struct LargeEdges {
  Edge left, right;

  void skip_rows(std::int32_t rows) {
    for (; rows > 0; --rows) {
      left.next_row();
      right.next_row();
    }
  }
};

/// A triangle that covers the current row: an entry of the active-edge table, with its plane equation. It exists from
/// the triangle's first row to its last.
struct ActiveTriangle {
  LinearFunction depth;          ///< plane word on the current row; its column 0 is screen column `origin`
  std::int32_t origin;           ///< screen column where the columns of edges and functions are 0
  std::int32_t row;              ///< current row, biased
  std::int32_t rows_to_knee;     ///< rows left until the third edge, or an outline's next one, replaces one of the two
  std::int32_t rows_after_knee;  ///< rows left after those
  enum class Size : std::uint8_t { small = 0, medium, large };

  /// Flags in one word, so that set-up writes them with one store.
  class Flags {
   public:
    Flags() = default;
    Flags(Size size, bool third_on_right, bool clipped)
        : bits_(static_cast<std::uint32_t>(size) | (third_on_right ? third_on_right_bit : 0) |
                (clipped ? clipped_bit : 0)) {}
    /// The edges are in `large` for Size::large, otherwise in `fixed`.
    [[nodiscard]] Size size() const { return static_cast<Size>(bits_ & size_mask); }
    /// Whether this is a triangle of the small class.
    [[nodiscard]] bool small_triangle() const { return (bits_ & (size_mask | outline_bit)) == 0; }
    /// Whether the third edge is the right one.
    [[nodiscard]] bool third_on_right() const { return (bits_ & third_on_right_bit) != 0; }
    /// Whether runs must be cut to the viewport's columns.
    [[nodiscard]] bool clipped() const { return (bits_ & clipped_bit) != 0; }
    /// Whether the third edge has replaced the left or right one.
    [[nodiscard]] bool past_knee() const { return (bits_ & past_knee_bit) != 0; }
    void set_past_knee() { bits_ |= past_knee_bit; }
    /// Whether this is a polygon of any number of corners. It has no third edge: where one of its edges ends, both are
    /// placed anew (raster/outline_setup.hpp).
    [[nodiscard]] bool outline() const { return (bits_ & outline_bit) != 0; }
    void set_outline() { bits_ |= outline_bit; }

   private:
    static constexpr std::uint32_t size_mask = 3, third_on_right_bit = 4, clipped_bit = 8, past_knee_bit = 16,
                                   outline_bit = 32;
    std::uint32_t bits_;
  } flags;

  union {
    FixedEdges fixed;
    LargeEdges large;
  };

  /// Copies `other`, but of its edges only the kind in use.
  void assign(const ActiveTriangle& other) {
    depth = other.depth;
    origin = other.origin;
    row = other.row;
    rows_to_knee = other.rows_to_knee;
    rows_after_knee = other.rows_after_knee;
    flags = other.flags;
    if (flags.size() == Size::large)
      large = other.large;
    else
      fixed = other.fixed;
  }

  /// Steps a small or medium triangle over `before` rows above its knee and `after` rows below it. The caller updates
  /// the counts of rows.
  void skip_rows(std::int32_t before, std::int32_t after) {
    fixed.skip_rows(before);
    if (after > 0) {
      if (!flags.past_knee()) {
        fixed.put_third(flags.third_on_right());
        flags.set_past_knee();
      }
      fixed.skip_rows(after);
    }
    depth.skip_rows(before + after);
  }
  [[nodiscard]] std::int32_t end_row() const { return row + rows_to_knee + rows_after_knee; }
  /// A function of the whole screen, from column 0 of row 0, as one from the column of origin of the current row.
  [[nodiscard]] LinearFunction moved_here(LinearFunction function) const {
    function.at_origin += function.dx * word(origin) + function.dy * word(row - row_bias);
    return function;
  }
};

}  // namespace spanline
