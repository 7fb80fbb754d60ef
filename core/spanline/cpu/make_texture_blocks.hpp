#pragma once
#include "spanline/cpu/armv6m/texture_blocks.hpp"
#include "spanline/cpu/form.hpp"
#include "spanline/cpu/texture_block_maker.hpp"
#include "spanline/cpu/texture_chords.hpp"
#include "spanline/cpu/texture_reciprocal.hpp"
#include "spanline/cpu/thumb2/texture_blocks.hpp"

namespace spanline {

namespace portable {

[[gnu::always_inline]] inline void make_texture_blocks(TextureBlockMaker& maker) {
  TextureBlockMaker at = maker;  // a copy in registers: the compiler must assume that a block may alias `maker`
  do {
    const TextureReciprocal inverse = TextureReciprocal::of(at.w);
    const std::uint32_t to_u = inverse.share<Form::portable>(at.u) >> at.shift_u,
                        to_v = inverse.share<Form::portable>(at.v) >> at.shift_v;
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
  maker.from_u = at.from_u;
  maker.from_v = at.from_v;
  maker.out = at.out;
}

}  // namespace portable

/// Makes blocks of a texture in perspective, at least one, until the last is made or w is no longer normalised. Output:
/// the blocks, and in `maker` the place and the start coordinates of the next one. w, u and v are unspecified on
/// return.
///
/// It has forms in assembly because the loop steps more words than compilers keep in registers.
template <Form form = Form::fastest>
[[gnu::always_inline]] inline void make_texture_blocks(TextureBlockMaker& maker) {
#if defined(__ARM_ARCH_6M__)
  if constexpr (form == Form::fastest) return armv6m::make_texture_blocks(maker);
#elif defined(__thumb2__)
  if constexpr (form == Form::fastest) return thumb2::make_texture_blocks(maker);
#endif
  portable::make_texture_blocks(maker);
}

}  // namespace spanline
