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
  if (plane.way < TexturePlane::Way::exact) {
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
  node.u = plane_.base_u + shifted(inverse.share(u << zeros), plane_.shift_u);
  node.v = plane_.base_v + shifted(inverse.share(v << zeros), plane_.shift_v);
}

TextureBlocks::Node TextureBlocks::node_at(std::int32_t column) const {
  Node node{plane_.w.at(column), 0, 0, false};
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
  Node node{plane_.w.at(column_), 0, 0, true};
  if (signed_word(node.w) <= 0) node.w = 1;
  divide(node, within(plane_.u.at(column_), node.w), within(plane_.v.at(column_), node.w));
  at_ = {{.du = 0, .ddu = 0, .dv = 0, .ddv = 0, .u = node.u, .v = node.v}};
  rest_ = 1;
  if (plane_.way != TexturePlane::Way::exact_far) return;
  if (plane_.far.u) at_.u = FarAxes::near(at_.u);
  if (plane_.far.v) at_.v = FarAxes::near(at_.v);
}

/// Moves to a new block, or to the next pixel where each pixel divides.
void TextureBlocks::next_division() {
  if (plane_.way < TexturePlane::Way::exact && ((column_ + plane_.origin) & (block_columns - 1)) == 0) {
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
  curved_ = first.valid && last_.valid && gentle(fall, last_.w);
  if (!curved_) return;
  const int zeros = leading_zeros_32(last_.w);
  const std::int32_t bow = TextureReciprocal::of(last_.w << zeros).bow(signed_word(fall << zeros) >> 16);
  if (plane_.way == TexturePlane::Way::wide_blocks && !chords_fit(column, bow)) {
    curved_ = false;
    return;
  }
  set_chords(first.u, last_.u, bow, at_.u, at_.du, at_.ddu);
  set_chords(first.v, last_.v, bow, at_.v, at_.dv, at_.ddv);
  rest_ = piece_columns;
}

/// Whether chords of a gentle block are the same modulo 2^32 as without limit. Where they are not, a pixel is some
/// hundred texels wide, and every pixel divides.
[[gnu::noinline]] bool TextureBlocks::chords_fit(std::int32_t column, std::int32_t bow) const {
  return chords_fit(column, bow, plane_.u, plane_.shift_u) && chords_fit(column, bow, plane_.v, plane_.shift_v);
}

bool TextureBlocks::chords_fit(std::int32_t column, std::int32_t bow, const LinearFunction& function, int shift) const {
  if (shift >= 0) return true;
  const std::uint32_t from_w = plane_.w.at(column), to_w = plane_.w.at(column + block_columns);
  // u/w moves by at most (|step of u| + |step of w|) / w, since it is in [0, 1]; a distance of 2^30 always fits.
  const std::uint32_t step = magnitude(signed_word(function.dx * word(block_columns)));
  if (step + magnitude(signed_word(to_w - from_w)) <= to_w >> -shift) return true;
  const auto share = [&](std::uint32_t w, std::int32_t at) {
    const int zeros = leading_zeros_32(w);
    return signed_word(TextureReciprocal::of(w << zeros).share(function.at(at) << zeros));
  };
  const std::int64_t distance =
      std::int64_t{share(to_w, column + block_columns) - share(from_w, column)} * (std::int64_t{1} << -shift);
  const auto fits = [](std::int64_t value) { return value == static_cast<std::int32_t>(value); };
  const std::int64_t back = (distance >> 12) * bow;
  return fits(distance) && fits(back) && fits(distance - 3 * (back >> 4));
}

}  // namespace spanline
