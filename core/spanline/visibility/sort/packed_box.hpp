#pragma once
#include <cstdint>

#include "spanline/raster/gradients.hpp"
#include "spanline/visibility/sort/screen_extent.hpp"

namespace spanline {

/// How boxes on screen are rounded to 7 bits a side: to units of 2^shift pixels, so that a picture has 128 at most.
struct BoxScale {
  int columns = 0, rows = 0;  ///< log2 of a unit's columns and rows

  BoxScale() = default;
  explicit BoxScale(Viewport viewport) {
    while ((viewport.width - 1) >> columns > 127) ++columns;
    while ((viewport.height - 1) >> rows > 127) ++rows;
  }
};

/// A box on screen in one word, for the first two overlap tests of depth sort: first column, first row, 127 − last
/// column and 127 − last row, a byte each, in units of BoxScale. One addition compares all four sides of two boxes.
class PackedBox {
 public:
  PackedBox() = default;
  /// The box of the pixels [first, end), which are not empty.
  PackedBox(std::int32_t first_column, std::int32_t end_column, std::int32_t first_row, std::int32_t end_row,
            BoxScale scale)
      : bits_(word(first_column >> scale.columns) | word(first_row >> scale.rows) << 8 |
              word(127 - ((end_column - 1) >> scale.columns)) << 16 | word(127 - ((end_row - 1) >> scale.rows)) << 24) {
  }

  PackedBox(const ScreenExtent& extent, BoxScale scale)
      : PackedBox(extent.first_column, extent.end_column, extent.first_row, extent.end_row, scale) {}

  /// A box that overlaps all others.
  [[nodiscard]] static PackedBox everywhere() { return {}; }

  /// Columns and rows that the box may have, not cut to the picture.
  [[nodiscard]] std::int32_t first_column(BoxScale scale) const { return signed_word((bits_ & 127) << scale.columns); }
  [[nodiscard]] std::int32_t end_column(BoxScale scale) const {
    return signed_word((128 - (bits_ >> 16 & 127)) << scale.columns);
  }
  [[nodiscard]] std::int32_t first_row(BoxScale scale) const { return signed_word((bits_ >> 8 & 127) << scale.rows); }
  [[nodiscard]] std::int32_t end_row(BoxScale scale) const { return signed_word((128 - (bits_ >> 24)) << scale.rows); }

  /// A box as others are compared with it: its bytes are exchanged by halves, so that each meets the opposite side of
  /// the other box. A first column plus 127 − a last column is at least 128 where the boxes lie apart.
  class Facing {
   public:
    explicit Facing(PackedBox box) : bits_(box.bits_ >> 16 | box.bits_ << 16) {}

    /// The tests of lectures 002 and 003, "Do the polygons' x not overlap?" and "Do the polygons' y not overlap?", both
    /// at once.
    [[nodiscard]] bool overlaps(PackedBox other) const { return ((bits_ + other.bits_) & 0x80808080u) == 0; }
    /// The first of them alone.
    [[nodiscard]] bool x_extents_overlap(PackedBox other) const { return ((bits_ + other.bits_) & 0x00800080u) == 0; }
    /// The second.
    [[nodiscard]] bool y_extents_overlap(PackedBox other) const { return ((bits_ + other.bits_) & 0x80008000u) == 0; }

   private:
    std::uint32_t bits_;
  };

 private:
  std::uint32_t bits_ = 0;
};

}  // namespace spanline
