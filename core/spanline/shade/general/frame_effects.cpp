#include "spanline/shade/general/frame_effects.hpp"

#include <algorithm>

#include "spanline/math/integer.hpp"

namespace spanline {
namespace {

/// 2^-(i/16), Q16, for i in [0, 16].
constexpr std::array<std::uint32_t, 17> halves{65536, 62757, 60097, 57549, 55109, 52772, 50535, 48393, 46341,
                                               44376, 42495, 40693, 38968, 37316, 35734, 34219, 32768};

/// 2^-(6·part), Q16, for part in [0, 1], Q16.
std::uint32_t left_over(std::uint32_t part) {
  const std::uint32_t exponent = 6 * part, sixteenths = (exponent >> 12) & 15, between = exponent & 4095;
  const std::uint32_t upper = halves[sixteenths], lower = halves[sixteenths + 1];
  return (upper - ((upper - lower) * between >> 12)) >> (exponent >> 16);
}

/// The fog's share of a pixel, 255ths, at `part` of the way from the fog's start to its end, Q16.
std::uint8_t share_of(FogCurve curve, std::uint32_t part) {
  const std::uint32_t share = curve == FogCurve::exponential ? (65536 - left_over(part)) * 64 / 63 : part;  // Q16
  return static_cast<std::uint8_t>(std::min<std::uint32_t>((share * 255 + 32768) >> 16, 255));
}

}  // namespace

void FogTable::fill(const Fog& fog, const Camera& camera) {
  const bool perspective = camera.projection == Projection::perspective;
  const std::int64_t near = camera.near_plane.raw(), far = camera.far_plane.raw(), range = far - near;
  slope_ = perspective ? static_cast<std::uint32_t>((range << 32) / far) : ~std::uint32_t{0};
  const std::int64_t start = fog.start.raw(), length = std::max<std::int64_t>(1, fog.end.raw() - start);
  for (unsigned zeros = 0; zeros < halvings; ++zeros)
    for (unsigned step = 0; step < steps; ++step) {
      // The middle of the entry's interval is (65 + 2·step)/128 of a power of two.
      const std::int64_t in_128ths = 2 * steps + 1 + 2 * step;
      const std::int64_t distance =
          perspective ? (near * 128 << zeros) / in_128ths : far - ((range * in_128ths) >> (7 + zeros));
      // No distance in the world exceeds 2^32; the cap keeps the product within 64 bits.
      const std::int64_t part = ((std::min(distance, std::int64_t{1} << 32) - start) * 65536) / length;
      shares_[zeros * steps + step] =
          share_of(fog.curve, static_cast<std::uint32_t>(std::clamp<std::int64_t>(part, 0, 65536)));
    }
}

std::int32_t FogTable::nearness(std::uint32_t depth) const {
  const std::uint32_t fallen = multiply_high(depth << 8, slope_) >> 8;
  return std::clamp<std::int32_t>(static_cast<std::int32_t>((1u << 24) - fallen), 64, (1 << 24) - 64);
}

}  // namespace spanline
