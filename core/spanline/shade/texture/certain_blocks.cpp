#include "spanline/shade/texture/certain_blocks.hpp"

#include <cstddef>

#include "spanline/cpu/make_texture_blocks.hpp"
#include "spanline/shade/texture/texture_blocks.hpp"
#include "spanline/shade/texture/texture_range.hpp"

namespace spanline {

using namespace texture_range;

namespace {
constexpr std::int32_t block_columns = TextureBlocks::block_columns;
}

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
    make_texture_blocks(maker_);
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
  certain_ = plane.way == TexturePlane::Way::blocks;
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
  // u ≥ 0 at the last block's end together with u ≤ w at the start makes w positive at the start.
  certain_ = start_u <= start_w && start_v <= start_w &&
             in_range(last_w, u_ + du_ * blocks_behind, v_ + dv_ * blocks_behind) &&
             (signed_word(fall_) >= 0 ? fall_ <= last_w >> 2
                                      : 0u - fall_ <= w_ >> 2);  // curvature is checked at the end where w is smallest
  if (!certain_) return;
  maker_.shift_u = word(plane.shift_u);
  maker_.shift_v = word(plane.shift_v);
  int zeros = leading_zeros_32(start_w);
  const TextureReciprocal inverse = TextureReciprocal::of(start_w << zeros);
  maker_.from_u = inverse.share(start_u << zeros) >> maker_.shift_u;
  maker_.from_v = inverse.share(start_v << zeros) >> maker_.shift_v;
  maker_.seeds = detail::texture_reciprocal_seed.data();
  // |step| ≤ w/4, so overflow and underflow both clear bit 31.
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

}  // namespace spanline
