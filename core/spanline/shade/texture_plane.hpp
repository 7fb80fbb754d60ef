#pragma once
#include <array>
#include <cstdint>

#include "spanline/math/bits.hpp"
#include "spanline/math/reciprocal.hpp"
#include "spanline/model/material.hpp"
#include "spanline/raster/linear_function.hpp"
#include "spanline/raster/texture_vertex.hpp"

namespace spanline {

/// Texture coordinates over a polygon, as a function of (x, y) alone.
///
/// Affine polygons have u and v as linear functions. In perspective, w = 1/z, u·w and v·w are linear, and a division
/// gives u and v (lecture 004: s/w, t/w, 1/w). It is made at absolute screen columns that are multiples of 16; between
/// two of them a parabola stands for the hyperbola, drawn as four chords of 4 columns. Where 16 columns change w by
/// more than a quarter, or a block's end lies so far outside the polygon that its words mean nothing, each pixel
/// divides for itself.
struct TexturePlane {
  enum class Way : std::uint8_t {
    affine,  ///< u and v are texture coordinates
    blocks,  ///< w, u and v are 30-bit words of 1/z, u/z and v/z
    exact,   ///< the same, too steep for blocks: a division a pixel
  };

  LinearFunction w, u, v;
  std::uint32_t base_u, base_v;  ///< texture coordinates where u/w and v/w are 0, in their fixed-point formats
  std::int8_t shift_u, shift_v;  ///< Q30 of u/w to the texture coordinate: to the left, or negative to the right
  std::int16_t origin;           ///< screen column from which columns count
  Way way;

  void next_row() {
    w.next_row();
    u.next_row();
    v.next_row();
  }
  void skip_rows(std::int32_t rows) {
    w.skip_rows(rows);
    u.skip_rows(rows);
    v.skip_rows(rows);
  }
};

/// What fits a texture plane to a polygon: values at its corners for `fit_fine`, and the constants.
struct TexturePlaneValues {
  std::array<std::int32_t, 3> w, u, v;
  int bits;  ///< of them
  std::uint32_t base_u, base_v, shift_u, shift_v;
  TexturePlane::Way way;
};

/// The fixed-point formats of texture coordinates, in texels of one level: u with `fraction_u` fraction bits and v with
/// `fraction_v`, both modulo 2^32.
struct TexelScale {
  int log2_width, log2_height;
  int fraction_u, fraction_v;  ///< [16, 24]
  std::int32_t offset;         ///< 2^-16 texels added to both: −½ for bilinear filtering
};

/// The values for three corners.
[[nodiscard]] TexturePlaneValues texture_plane_values(const std::array<TextureVertex, 3>& corners,
                                                      TextureMapping mapping, const TexelScale& scale);

/// Makes a texture plane of a polygon's gradients.
template <class Gradients>
void fit_texture_plane(const Gradients& gradients, const TexturePlaneValues& values, TexturePlane& plane) {
  gradients.fit_fine(values.u, values.bits, plane.u);
  gradients.fit_fine(values.v, values.bits, plane.v);
  plane.base_u = values.base_u;
  plane.base_v = values.base_v;
  plane.shift_u = static_cast<std::int8_t>(values.shift_u);
  plane.shift_v = static_cast<std::int8_t>(values.shift_v);
  plane.origin = static_cast<std::int16_t>(gradients.origin());
  plane.way = values.way;
  if (values.way == TexturePlane::Way::affine) {
    plane.u.at_origin += values.base_u;
    plane.v.at_origin += values.base_v;
    return;
  }
  gradients.fit_fine(values.w, values.bits, plane.w);
  // A block's ends lie within 15 columns of the polygon, whose words are in [0, 2^30]: below this slope they are in
  // [−2^29, 3·2^29] there, and none wraps.
  constexpr std::uint32_t steepest = 1u << 25;
  const auto steep = [](const LinearFunction& f) { return magnitude(signed_word(f.dx)) >= steepest; };
  if (steep(plane.w) || steep(plane.u) || steep(plane.v)) plane.way = TexturePlane::Way::exact;
}

/// Walks the texture coordinates of a row, piece by piece: in each u and v are linear.
class TextureBlocks {
 public:
  static constexpr std::int32_t block_columns = 16, piece_columns = 4;

  /// Where it stands, and steps to the right. Inside a block the steps change from one piece to the next.
  struct Coordinates {
    std::uint32_t u, v, du, dv, ddu, ddv;
    void forward() {
      u += du;
      v += dv;
    }
    void back() {
      u -= du;
      v -= dv;
    }
    /// From one piece to the next of the block.
    void bend() {
      du -= ddu;
      dv -= ddv;
    }
  };

  TextureBlocks(const TexturePlane& plane, std::int32_t column) : plane_(plane), column_(column) {
    if (plane.way == TexturePlane::Way::affine) {
      at_ = {plane.u.at(column), plane.v.at(column), plane.u.dx, plane.v.dx, 0, 0};
      rest_ = whole_row;
      return;
    }
    const std::int32_t into_block = (column + plane.origin) & (block_columns - 1);
    const std::int32_t start = column - into_block;
    if (plane.way == TexturePlane::Way::blocks) {
      last_ = node_at(start);
      begin_block(start);
    }
    if (!curved_) {
      divide();
      return;
    }
    const std::int32_t piece = into_block / piece_columns, into_piece = into_block % piece_columns;
    for (std::int32_t i = 0; i < piece; ++i) {
      at_.u += at_.du * piece_columns;
      at_.v += at_.dv * piece_columns;
      at_.bend();
    }
    at_.u += at_.du * word(into_piece);
    at_.v += at_.dv * word(into_piece);
    rest_ = word(piece_columns - into_piece);
  }

  /// Pixels left in the piece, and to the end of the pieces that one source serves with `bend` between them.
  [[nodiscard]] std::uint32_t rest() const { return rest_; }
  [[nodiscard]] std::uint32_t rest_of_block() const {
    return curved_ ? word(block_columns - ((column_ + plane_.origin) & (block_columns - 1))) : rest_;
  }
  [[nodiscard]] const Coordinates& coordinates() const { return at_; }
  [[nodiscard]] std::int32_t column() const { return column_; }
  /// Whether it stands at the start of a whole block of 16 columns in four pieces.
  [[nodiscard]] bool at_block() const { return curved_ && ((column_ + plane_.origin) & (block_columns - 1)) == 0; }

  /// Behind `rest_of_block` pixels.
  void next() { next(rest_of_block()); }
  /// Behind as many pixels; at most `rest_of_block`, and fewer of affine polygons alone.
  void next(std::uint32_t length) {
    column_ += signed_word(length);
    if (plane_.way == TexturePlane::Way::affine) {
      at_.u += at_.du * length;
      at_.v += at_.dv * length;
      return;
    }
    next_division();
  }

 private:
  /// 1/w: 2^62 / (w · 2^zeros).
  struct Inverse {
    std::uint32_t mantissa;
    std::int32_t zeros;
    explicit Inverse(std::uint32_t w) : mantissa(0), zeros(leading_zeros_32(w)) {
      mantissa = reciprocal_32(w << zeros);
    }
    /// (w − w0) / w for a difference of at most a quarter of w, in Q16; and the bow of a parabola that follows from it:
    /// at the middle the hyperbola leaves the chord by (distance of the ends) · (w − w0) / (2 (w0 + w)), which is
    /// share/4 · (1 + share/2 + …), good to a thousandth of the distance.
    [[nodiscard]] std::int32_t bow(std::int32_t difference) const {
      const std::int32_t share = (signed_word(word(difference) << zeros) >> 15) * signed_word(mantissa >> 16) >> 15;
      return (share + (share * share >> 17)) >> 2;
    }
    /// part/w in Q30, for part in [0, w].
    [[nodiscard]] std::uint32_t share(std::uint32_t part) const { return multiply_high(part << zeros, mantissa); }
  };

  /// Chords of the parabola through both ends whose middle lies `bow`/2^16 of their distance off the straight line:
  /// their steps fall by an eighth of that from one to the next. The chords are moved by 3/64 of it, which more than
  /// halves the mean error of the columns.
  static void set_axis(std::uint32_t from, std::uint32_t to, std::int32_t bow, std::uint32_t& at, std::uint32_t& step,
                       std::uint32_t& bend) {
    const std::int32_t distance = signed_word(to - from);
    const std::int32_t off = signed_word(word(distance >> 12) * word(bow)) >> 4;
    at = from + word(3 * off >> 6);
    step = word((distance + 3 * off) >> 4);
    bend = word(off >> 3);
  }

 public:
  /// Blocks that follow each other and are all drawn as parabolas: the words are linear, so what holds for the first
  /// and the last end holds for those between, and none needs a check.
  class CertainBlocks {
   public:
    [[nodiscard]] std::uint32_t count() const { return count_; }
    /// The block behind the one that came last.
    [[nodiscard, gnu::always_inline]] Coordinates next() {
      const std::uint32_t from_u = at_u_, from_v = at_v_;
      w_ += dw_;
      u_ += du_;
      v_ += dv_;
      const Inverse inverse(w_);
      at_u_ = base_u_ + (inverse.share(u_) << left_u_ >> right_u_);
      at_v_ = base_v_ + (inverse.share(v_) << left_v_ >> right_v_);
      Coordinates c;
      const std::int32_t bow = inverse.bow(signed_word(dw_));
      set_axis(from_u, at_u_, bow, c.u, c.du, c.ddu);
      set_axis(from_v, at_v_, bow, c.v, c.dv, c.ddv);
      return c;
    }

   private:
    friend class TextureBlocks;
    std::uint32_t count_ = 0;
    std::uint32_t w_, u_, v_, at_u_, at_v_;  ///< at the end of the block that came last
    std::uint32_t dw_, du_, dv_;             ///< a block
    std::uint32_t base_u_, base_v_;
    std::uint32_t left_u_, right_u_, left_v_, right_v_;
  };

  /// Of the next `count` ≥ 1 whole blocks, from the start of a block on: all, or none where it is not certain.
  [[nodiscard]] CertainBlocks certain(std::uint32_t count) const {
    CertainBlocks blocks;
    const std::int32_t end = column_ + block_columns, last = column_ + block_columns * signed_word(count);
    const std::uint32_t w = plane_.w.at(last);
    blocks.dw_ = plane_.w.dx * block_columns;
    if (!in_range(w, plane_.u.at(last), plane_.v.at(last)) || magnitude(signed_word(blocks.dw_)) > w >> 2)
      return blocks;
    blocks.count_ = count;
    blocks.w_ = last_.w;
    blocks.u_ = plane_.u.at(end);
    blocks.v_ = plane_.v.at(end);
    blocks.at_u_ = last_.u;
    blocks.at_v_ = last_.v;
    blocks.du_ = plane_.u.dx * block_columns;
    blocks.dv_ = plane_.v.dx * block_columns;
    blocks.base_u_ = plane_.base_u;
    blocks.base_v_ = plane_.base_v;
    const auto part = [](int shift) { return word(shift > 0 ? shift : 0); };
    blocks.left_u_ = part(plane_.shift_u);
    blocks.right_u_ = part(-plane_.shift_u);
    blocks.left_v_ = part(plane_.shift_v);
    blocks.right_v_ = part(-plane_.shift_v);
    return blocks;
  }
  /// Behind certain blocks that have all been drawn.
  void leave(const CertainBlocks& blocks) {
    column_ += block_columns * signed_word(blocks.count_);
    last_ = {blocks.w_, blocks.at_u_, blocks.at_v_, true};
    next_division();
  }

 private:
  static constexpr std::uint32_t whole_row = 4096;  // longer than any run

  /// The end of a block.
  struct Node {
    std::uint32_t w;
    std::uint32_t u, v;  ///< texture coordinates
    bool valid;          ///< w positive, u/w and v/w in [0, 1]
  };
  [[nodiscard]] static std::uint32_t shifted(std::uint32_t q30, int shift) {
    return shift >= 0 ? q30 << shift : q30 >> -shift;
  }
  void divide(Node& node, std::uint32_t u, std::uint32_t v, const Inverse& inverse) const {
    node.u = plane_.base_u + shifted(inverse.share(u), plane_.shift_u);
    node.v = plane_.base_v + shifted(inverse.share(v), plane_.shift_v);
  }
  [[nodiscard]] static bool in_range(std::uint32_t w, std::uint32_t u, std::uint32_t v) {
    return signed_word(w) > 0 && u <= w && v <= w;
  }
  [[nodiscard]] Node node_at(std::int32_t column) const {
    Node node{plane_.w.at(column), 0, 0, false};
    const std::uint32_t u = plane_.u.at(column), v = plane_.v.at(column);
    node.valid = in_range(node.w, u, v);
    if (node.valid) divide(node, u, v, Inverse(node.w));
    return node;
  }

  /// A pixel by a division of its own. Inside the polygon all is in range but for rounding.
  void divide() {
    const auto within = [](std::uint32_t value, std::uint32_t most) {
      return signed_word(value) < 0 ? 0 : value < most ? value : most;
    };
    Node node{plane_.w.at(column_), 0, 0, true};
    if (signed_word(node.w) <= 0) node.w = 1;
    divide(node, within(plane_.u.at(column_), node.w), within(plane_.v.at(column_), node.w), Inverse(node.w));
    at_ = {node.u, node.v, 0, 0, 0, 0};
    rest_ = 1;
  }

  /// The step to a new block, or to the next pixel where each divides.
  void next_division() {
    if (plane_.way == TexturePlane::Way::blocks && ((column_ + plane_.origin) & (block_columns - 1)) == 0) {
      begin_block(column_);
      if (curved_) return;
    }
    divide();
  }

  /// The block that begins at `column`, whose first node is known: the second, and the parabola between them.
  void begin_block(std::int32_t column) {
    const Node first = last_;
    const std::int32_t end = column + block_columns;
    last_ = {plane_.w.at(end), 0, 0, false};
    const std::uint32_t u = plane_.u.at(end), v = plane_.v.at(end);
    last_.valid = in_range(last_.w, u, v);
    curved_ = false;
    if (!last_.valid) return;
    const Inverse inverse(last_.w);
    divide(last_, u, v, inverse);
    const std::int32_t difference = signed_word(last_.w - first.w);
    if (!first.valid || magnitude(difference) > last_.w >> 2) return;
    curved_ = true;
    const std::int32_t bow = inverse.bow(difference);
    set_axis(first.u, last_.u, bow, at_.u, at_.du, at_.ddu);
    set_axis(first.v, last_.v, bow, at_.v, at_.dv, at_.ddv);
    rest_ = piece_columns;
  }
  const TexturePlane& plane_;
  std::int32_t column_;
  std::uint32_t rest_ = 1;
  bool curved_ = false;
  Coordinates at_{};
  Node last_{};  ///< the end of the block
};

}  // namespace spanline
