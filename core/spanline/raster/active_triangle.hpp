#pragma once
#include <cstdint>

#include "spanline/raster/edge.hpp"
#include "spanline/raster/fixed_edges.hpp"
#include "spanline/raster/linear_function.hpp"

namespace spanline {

/// Edges of a triangle of any size: two that are walked; the third is made when its first row comes.
struct LargeEdges {
  Edge left, right;

  void skip_rows(std::int32_t rows) {
    for (; rows > 0; --rows) {
      left.next_row();
      right.next_row();
    }
  }
};

/// A triangle between its first row and its last: an entry of the active-edge table, with its plane equation. It is
/// made when the triangle becomes active and lives while it is.
struct ActiveTriangle {
  LinearFunction depth;          ///< plane word on the current row, at column `origin`
  std::int32_t origin;           ///< screen column that columns of edges and functions count from
  std::int32_t row;              ///< current row, biased
  std::int32_t rows_to_knee;     ///< rows until the left or right edge gives way to the third
  std::int32_t rows_after_knee;  ///< rows of the third edge
  enum class Size : std::uint8_t { small, medium, large };

  /// One word, so that set-up writes it at once.
  class Flags {
   public:
    Flags() = default;
    Flags(Size size, bool third_on_right, bool clipped)
        : bits_(static_cast<std::uint32_t>(size) | (third_on_right ? third_on_right_bit : 0) |
                (clipped ? clipped_bit : 0)) {}
    /// `large` edges are in `large`, others in `fixed`.
    [[nodiscard]] Size size() const { return static_cast<Size>(bits_ & size_mask); }
    /// The third edge is on the right.
    [[nodiscard]] bool third_on_right() const { return (bits_ & third_on_right_bit) != 0; }
    /// Runs must be cut to the viewport's columns.
    [[nodiscard]] bool clipped() const { return (bits_ & clipped_bit) != 0; }
    /// The third edge is in place.
    [[nodiscard]] bool past_knee() const { return (bits_ & past_knee_bit) != 0; }
    void set_past_knee() { bits_ |= past_knee_bit; }

   private:
    static constexpr std::uint32_t size_mask = 3, third_on_right_bit = 4, clipped_bit = 8, past_knee_bit = 16;
    std::uint32_t bits_;
  } flags;

  union {
    FixedEdges fixed;
    LargeEdges large;
  };

  /// Copies what a triangle of its size has.
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

  /// Steps a small or medium triangle over rows before and after its knee, where its counts of rows allow it.
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
};

}  // namespace spanline
