#pragma once
#include <cstdint>

#include "spanline/cpu/clamp_to_bits.hpp"
#include "spanline/cpu/depth_run.hpp"
#include "spanline/cpu/fill_constant.hpp"
#include "spanline/cpu/packed_depths.hpp"
#include "spanline/cpu/texture_reciprocal.hpp"
#include "spanline/cpu/triangle_area.hpp"
#include "spanline/pixel/pixel_format.hpp"
#include "spanline/raster/depth_format.hpp"
#include "spanline/shade/light/flat.hpp"
#include "twin_case.hpp"

/// Kernels of few words, and runs of one pixel value.
namespace twins {

using namespace spanline;

/// Runs of 1 to 100 pixels of one value from any address, against a plane that may lie flat.
inline bool paired_depths_alike(Random& random) {
  static Buffers<128> buffers;
  const std::uint32_t start = 8 + random.below(4), count = 1 + random.below(100), z = random(),
                      dz = random_step(random);
  const FlatShader<Rgb565>::Source source{static_cast<std::uint16_t>(random())};
  buffers.fill(random, 128, z);
  DepthRun<Depth16<>, std::uint16_t>::long_run(buffers.fast.depth + start, buffers.fast.pixels + start, count, z, dz,
                                               source);
  DepthRun<Depth16<>, std::uint16_t, Form::portable>::long_run(buffers.portable.depth + start,
                                                               buffers.portable.pixels + start, count, z, dz, source);
  return buffers.alike(128);
}

inline bool packed_depths_alike(Random& random) {
  const std::uint32_t left = random(), right = random();
  return packed_depths(left, right) == packed_depths<Form::portable>(left, right);
}

/// Runs of 1 to 300 pixels from any address.
inline bool fills_alike(Random& random) {
  static Buffers<320> buffers;
  const std::uint32_t start = 8 + random.below(4), count = 1 + random.below(300);
  const auto value = static_cast<std::uint16_t>(random());
  buffers.fill(random, 320, value);
  fill_constant(value, count, buffers.fast.pixels + start);
  fill_constant<Form::portable>(value, count, buffers.portable.pixels + start);
  return buffers.alike(320);
}

/// Shares of 0, of all and between, of any w.
inline bool reciprocal_shares_alike(Random& random) {
  const std::uint32_t w = random() | 0x80000000u, kind = random.below(8);
  const std::uint32_t part = kind == 0 ? 0 : kind == 1 ? w : random.below(w);
  const TextureReciprocal inverse = TextureReciprocal::of(w);
  return inverse.share(part) == inverse.share<Form::portable>(part);
}

inline bool areas_alike(Random& random) {
  const auto vertex = [&] {
    const auto coordinate = [&] {
      const std::uint32_t kind = random.below(6);
      return static_cast<std::uint16_t>(ScreenVertex::bias + (kind == 0   ? 0
                                                              : kind == 1 ? 32752
                                                                          : between(random, 0, 32752)));
    };
    const std::uint16_t x = coordinate(), y = coordinate();
    return ScreenVertex{x, y, random()};
  };
  const ScreenVertex a = vertex(), b = vertex(), c = vertex();
  return narrow_area(a, b, c) == narrow_area<Form::portable>(a, b, c) && biased_y(a) == biased_y<Form::portable>(a);
}

inline bool clamps_alike(Random& random) {
  const std::uint32_t word = random(), kind = random.below(8);
  const std::int32_t value =
      kind < 4 ? static_cast<std::int32_t>(word) : (kind < 6 ? 0 : 1 << 28) + static_cast<std::int32_t>(word % 5) - 2;
  return clamp_to_bits<28>(value) == clamp_to_bits<28, Form::portable>(value);
}

}  // namespace twins
