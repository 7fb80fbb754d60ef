#include "spanline/shade/texture/texture_blocks.hpp"

#include "spanline/cpu/texture_chords.hpp"
#include "spanline/cpu/texture_reciprocal.hpp"
#include "spanline/shade/texture/texture_range.hpp"

namespace spanline {

using namespace texture_range;

TextureBlocks::TextureBlocks(const TexturePlane& plane, std::int32_t column) : plane_(plane), column_(column) {
  if (plane.way == TexturePlane::Way::affine) {
    at_ = {{.du = plane.u.dx, .ddu = 0, .dv = plane.v.dx, .ddv = 0, .u = plane.u.at(column), .v = plane.v.at(column)}};
    rest_ = whole_row;
    return;
  }
  const std::int32_t into_block = (column + plane.origin) & (block_columns - 1);
  if (plane.way == TexturePlane::Way::blocks) {
    last_ = node_at(column - into_block);
    begin_block(column - into_block);
  }
  if (!curved_) {
    divide();
    return;
  }
  at_.skip(word(into_block), at_);
  rest_ = word(piece_columns - into_block % piece_columns);
}

void TextureBlocks::next(std::uint32_t length) {
  column_ += signed_word(length);
  if (plane_.way == TexturePlane::Way::affine) {
    at_.u += at_.du * length;
    at_.v += at_.dv * length;
    return;
  }
  next_division();
}

void TextureBlocks::divide(Node& node, std::uint32_t u, std::uint32_t v) const {
  const int zeros = leading_zeros_32(node.w);
  const TextureReciprocal inverse = TextureReciprocal::of(node.w << zeros);
  const auto shifted = [](std::uint32_t q30, int shift) { return shift >= 0 ? q30 >> shift : q30 << -shift; };
  node.share_u = inverse.share(u << zeros);
  node.share_v = inverse.share(v << zeros);
  node.u = plane_.base_u + shifted(node.share_u, plane_.shift_u);
  node.v = plane_.base_v + shifted(node.share_v, plane_.shift_v);
}

TextureBlocks::Node TextureBlocks::node_at(std::int32_t column) const {
  Node node{plane_.w.at(column), 0, 0, 0, 0, false};
  const std::uint32_t u = plane_.u.at(column), v = plane_.v.at(column);
  node.valid = in_range(node.w, u, v);
  if (node.valid) divide(node, u, v);
  return node;
}

/// Computes one pixel by its own division. The clamps only remove rounding errors as long as the pixel is inside the
/// polygon.
void TextureBlocks::divide() {
  const auto within = [](std::uint32_t value, std::uint32_t most) {
    return signed_word(value) < 0 ? 0 : value < most ? value : most;
  };
  Node node{plane_.w.at(column_), 0, 0, 0, 0, true};
  if (signed_word(node.w) <= 0) node.w = 1;
  divide(node, within(plane_.u.at(column_), node.w), within(plane_.v.at(column_), node.w));
  at_ = {{.du = 0, .ddu = 0, .dv = 0, .ddv = 0, .u = node.u, .v = node.v}};
  rest_ = 1;
}

/// Moves to a new block, or to the next pixel where each pixel divides.
void TextureBlocks::next_division() {
  if (plane_.way == TexturePlane::Way::blocks && ((column_ + plane_.origin) & (block_columns - 1)) == 0) {
    begin_block(column_);
    if (curved_) return;
  }
  divide();
}

/// Begins the block at `column`. Its first end is the last block's second; this computes its second end and the
/// parabola between both.
void TextureBlocks::begin_block(std::int32_t column) {
  const Node first = last_;
  last_ = node_at(column + block_columns);
  const std::uint32_t fall = first.w - last_.w;
  curved_ = first.valid && last_.valid && gentle(fall, last_.w) &&
            chords_reach(first.share_u, last_.share_u, plane_.shift_u) &&
            chords_reach(first.share_v, last_.share_v, plane_.shift_v);
  if (!curved_) return;
  const int zeros = leading_zeros_32(last_.w);
  const std::int32_t bow = TextureReciprocal::of(last_.w << zeros).bow(signed_word(fall << zeros) >> 16);
  set_chords(first.u, last_.u, bow, at_.u, at_.du, at_.ddu);
  set_chords(first.v, last_.v, bow, at_.v, at_.dv, at_.ddv);
  rest_ = piece_columns;
}

}  // namespace spanline
