#include "spanline/shade/texture_blocks.hpp"

#include <cstddef>

#include "spanline/shade/block_maker_armv6m.hpp"
#include "spanline/shade/block_maker_thumb2.hpp"

namespace spanline {
namespace {

constexpr std::int32_t block_columns = TextureBlocks::block_columns;

/// Whether u/w and v/w are in [0, 1].
[[nodiscard]] bool in_range(std::uint32_t w, std::uint32_t u, std::uint32_t v) {
  return signed_word(w) > 0 && u <= w && v <= w;
}

/// Whether a parabola follows the hyperbola over a block in which w falls by `fall` to `w` at its end.
[[nodiscard]] bool gentle(std::uint32_t fall, std::uint32_t w) { return magnitude(signed_word(fall)) <= w >> 2; }

/// Chords of the parabola through both ends whose middle lies `bow`/2^16 of their distance back from the straight line:
/// their steps grow by an eighth of that from one to the next. The chords are moved by 3/64 of it, which more than
/// halves the mean error of the columns.
[[gnu::always_inline]] inline void set_chords(std::uint32_t from, std::uint32_t to, std::int32_t bow, std::uint32_t& at,
                                              std::uint32_t& step, std::uint32_t& bend) {
  const std::int32_t distance = signed_word(to - from);
  const std::int32_t back = signed_word(word(distance >> 12) * word(bow)) >> 4;
  const std::int32_t three = back + 2 * back;
  at = from - word(back >> 5);
  step = word((distance - three) >> 4);
  bend = word(back >> 3);
}

}  // namespace

#if !defined(__ARM_ARCH_6M__) && !defined(__thumb2__)
inline void BlockMaker::make() {
  BlockMaker at = *this;  // in registers: for all that the compiler knows, a block may lie over this object
  do {
    const TextureReciprocal inverse = TextureReciprocal::of(at.w);
    const std::uint32_t to_u = inverse.share(at.u) >> at.shift_u, to_v = inverse.share(at.v) >> at.shift_v;
    const std::int32_t bow = inverse.bow(at.upper_fall);
    set_chords(at.from_u, to_u, bow, at.out->u, at.out->du, at.out->ddu);
    set_chords(at.from_v, to_v, bow, at.out->v, at.out->dv, at.out->ddv);
    ++at.out;
    at.from_u = to_u;
    at.from_v = to_v;
    at.w -= at.fall;
    at.u += at.du;
    at.v += at.dv;
  } while (at.out != at.end && signed_word(at.w) < 0);
  from_u = at.from_u;
  from_v = at.from_v;
  out = at.out;
}
#endif

[[gnu::always_inline]] inline void CertainBlocks::normalise(int zeros, std::uint32_t w, std::uint32_t u,
                                                            std::uint32_t v) {
  maker_.w = w << zeros;
  maker_.u = u << zeros;
  maker_.v = v << zeros;
  maker_.du = du_ << zeros;
  maker_.dv = dv_ << zeros;
  maker_.fall = fall_ << zeros;
  maker_.upper_fall = signed_word(maker_.fall) >> 16;
}

[[gnu::noinline]] void CertainBlocks::normalise_behind(std::uint32_t blocks) {
  const std::uint32_t w = w_ - blocks * fall_;
  normalise(leading_zeros_32(w), w, u_ + blocks * du_, v_ + blocks * dv_);
}

[[gnu::always_inline]] inline void CertainBlocks::take() {
  maker_.out = blocks_;
  maker_.end = blocks_ + count_;
  for (;;) {
    maker_.make();
    if (maker_.out == maker_.end) return;
    normalise_behind(made_ + static_cast<std::uint32_t>(maker_.out - blocks_));
  }
}

[[gnu::always_inline]] inline void CertainBlocks::take_affine() {
  TextureBlock* block = blocks_;
  for (std::uint32_t left = count_; left != 0; --left) {
    *block++ = {.du = du_, .ddu = 0, .dv = dv_, .ddv = 0, .u = u_, .v = v_};
    u_ += du_ * word(block_columns);
    v_ += dv_ * word(block_columns);
  }
}

CertainBlocks::CertainBlocks(const TexturePlane& plane, std::int32_t column, std::uint32_t count)
    : certain_(true),
      affine_(plane.way == TexturePlane::Way::affine),
      into_block_(word(column + plane.origin) & word(block_columns - 1)) {
  const std::uint32_t start = word(column) - into_block_, blocks_behind = (into_block_ + count - 1) / block_columns;
  count_ = blocks_behind < most ? blocks_behind + 1 : most;
  left_ = blocks_behind + 1 - count_;
  du_ = plane.u.dx;
  dv_ = plane.v.dx;
  if (affine_) {
    u_ = plane.u.at_origin + du_ * start;
    v_ = plane.v.at_origin + dv_ * start;
    take_affine();
    return;
  }
  certain_ = plane.way == TexturePlane::Way::blocks && (plane.shift_u | plane.shift_v) >= 0;
  if (!certain_) return;
  const std::uint32_t start_w = plane.w.at_origin + plane.w.dx * start, start_u = plane.u.at_origin + du_ * start,
                      start_v = plane.v.at_origin + dv_ * start;
  fall_ = 0u - plane.w.dx * word(block_columns);
  du_ *= word(block_columns);
  dv_ *= word(block_columns);
  w_ = start_w - fall_;
  u_ = start_u + du_;
  v_ = start_v + dv_;
  const std::uint32_t last_w = w_ - fall_ * blocks_behind;
  // With this, w at the start is positive.
  certain_ = start_u <= start_w && start_v <= start_w &&
             in_range(last_w, u_ + du_ * blocks_behind, v_ + dv_ * blocks_behind) &&
             (signed_word(fall_) >= 0 ? fall_ <= last_w >> 2 : 0u - fall_ <= w_ >> 2);  // gentle, where w is smallest
  if (!certain_) return;
  maker_.shift_u = word(plane.shift_u);
  maker_.shift_v = word(plane.shift_v);
  int zeros = leading_zeros_32(start_w);
  const TextureReciprocal inverse = TextureReciprocal::of(start_w << zeros);
  maker_.from_u = inverse.share(start_u << zeros) >> maker_.shift_u;
  maker_.from_v = inverse.share(start_v << zeros) >> maker_.shift_v;
  maker_.seeds = detail::texture_reciprocal_seed.data();
  // No step is longer than a quarter of w, so that a carry clears the top bit as well as a borrow does.
  if (signed_word(w_ << zeros) >= 0) zeros = leading_zeros_32(w_);
  normalise(zeros, w_, u_, v_);
  take();
}

bool CertainBlocks::take_next() {
  made_ += count_;
  count_ = left_ < most ? left_ : most;
  left_ -= count_;
  if (affine_) {
    take_affine();
  } else {
    normalise_behind(made_);
    take();
  }
  return true;
}

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

/// A pixel by a division of its own. Inside the polygon all is in range but for rounding.
void TextureBlocks::divide() {
  const auto within = [](std::uint32_t value, std::uint32_t most) {
    return signed_word(value) < 0 ? 0 : value < most ? value : most;
  };
  Node node{plane_.w.at(column_), 0, 0, true};
  if (signed_word(node.w) <= 0) node.w = 1;
  divide(node, within(plane_.u.at(column_), node.w), within(plane_.v.at(column_), node.w));
  at_ = {{.du = 0, .ddu = 0, .dv = 0, .ddv = 0, .u = node.u, .v = node.v}};
  rest_ = 1;
}

/// The step to a new block, or to the next pixel where each divides.
void TextureBlocks::next_division() {
  if (plane_.way == TexturePlane::Way::blocks && ((column_ + plane_.origin) & (block_columns - 1)) == 0) {
    begin_block(column_);
    if (curved_) return;
  }
  divide();
}

/// The block that begins at `column`, whose first node is known: the second, and the parabola between them.
void TextureBlocks::begin_block(std::int32_t column) {
  const Node first = last_;
  last_ = node_at(column + block_columns);
  const std::uint32_t fall = first.w - last_.w;
  curved_ = first.valid && last_.valid && gentle(fall, last_.w);
  if (!curved_) return;
  const int zeros = leading_zeros_32(last_.w);
  const std::int32_t bow = TextureReciprocal::of(last_.w << zeros).bow(signed_word(fall << zeros) >> 16);
  set_chords(first.u, last_.u, bow, at_.u, at_.du, at_.ddu);
  set_chords(first.v, last_.v, bow, at_.v, at_.dv, at_.ddv);
  rest_ = piece_columns;
}

}  // namespace spanline
