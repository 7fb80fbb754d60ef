#pragma once
#include <cstdint>
#include <type_traits>

#include "spanline/cpu/make_texture_blocks.hpp"
#include "twin_case.hpp"

/// The maker of a texture's blocks: one block, many, to the end and until w is no longer normalised, falling and
/// rising.
namespace twins {

using namespace spanline;

inline bool texture_blocks_alike(Random& random) {
  constexpr std::uint32_t most = 24;
  static TextureBlock fast_blocks[most], portable_blocks[most];
  const std::uint32_t steps = 4 + random.below(20), count = 1 + random.below(most);
  const auto share_of = [&](std::uint32_t whole) { return random.below(8) == 0 ? whole : random.below(whole) + 1; };
  // Words at the run's ends, u and v at most w there, and so between them. Behind the far end w is below 2^31, or in
  // some runs as far above it, where an addition clears bit 31.
  const std::uint32_t w = random() | 0x80000000u;
  const std::uint32_t far_w = (random() >> 2) + (random.below(4) == 0 ? 0xc0000000u : 0x40000000u);
  const std::uint32_t u = share_of(w), v = share_of(w), far_u = share_of(far_w), far_v = share_of(far_w);
  const auto step = [steps](std::uint32_t from, std::uint32_t to) {
    return static_cast<std::uint32_t>((static_cast<std::int64_t>(to) - from) / static_cast<std::int64_t>(steps));
  };
  TextureBlockMaker maker{};
  maker.w = w;
  maker.u = u;
  maker.v = v;
  maker.shift_u = random.below(16);
  maker.shift_v = random.below(16);
  maker.from_u = random() >> 2 >> maker.shift_u;
  maker.from_v = random() >> 2 >> maker.shift_v;
  maker.du = step(u, far_u);
  maker.dv = step(v, far_v);
  maker.fall = 0u - step(w, far_w);
  maker.upper_fall = signed_word(maker.fall) >> 16;
  maker.seeds = detail::texture_reciprocal_seed.data();
  const std::uint32_t wanted = count < steps ? count : steps;
  const auto make = [&](auto form, TextureBlock* blocks) {
    for (std::uint32_t i = 0; i < most; ++i) blocks[i] = {};
    TextureBlockMaker own = maker;
    own.out = blocks;
    own.end = blocks + wanted;
    make_texture_blocks<decltype(form)::value>(own);
    return own;
  };
  const TextureBlockMaker fast = make(std::integral_constant<Form, Form::fastest>{}, fast_blocks);
  const TextureBlockMaker portable = make(std::integral_constant<Form, Form::portable>{}, portable_blocks);
  using Words = const std::uint32_t[sizeof fast_blocks / 4];
  return fast.out - fast_blocks == portable.out - portable_blocks && fast.from_u == portable.from_u &&
         fast.from_v == portable.from_v &&
         same(reinterpret_cast<Words&>(fast_blocks), reinterpret_cast<Words&>(portable_blocks), most * 6);
}

}  // namespace twins
