#include "spanline/shade/texture/texture_plane.hpp"

#include <algorithm>

#include "spanline/math/bits.hpp"

namespace spanline {
namespace {

constexpr int unit_bits = TextureUnits::fraction_bits;
constexpr int affine_bits = 28, perspective_bits = 26;
constexpr std::uint32_t quarter = 1u << 28;  // Q30

int bit_count(std::uint32_t value) { return value == 0 ? 0 : 32 - leading_zeros_32(value); }

std::uint32_t shifted(std::uint32_t value, int left) { return left >= 0 ? value << left : value >> -left; }

/// value · 2^shift modulo 2^32, rounded down.
std::uint32_t scaled(std::int32_t value, int shift) {
  if (shift >= 0) return shift > 31 ? 0 : word(value) << shift;
  return word(value >> std::min(31, -shift));
}

/// One axis of the corners' texture coordinates: the least of them, and by how much each exceeds it.
struct Axis {
  std::int32_t least;
  std::array<std::uint32_t, 3> above;
  std::uint32_t span;

  Axis(std::int32_t a, std::int32_t b, std::int32_t c) : least(std::min({a, b, c})), above{}, span(0) {
    above = {word(a) - word(least), word(b) - word(least), word(c) - word(least)};
    span = std::max({above[0], above[1], above[2]});
  }

  /// The span in 2^-20 texels, limited to 2^38 so that products of it fit 64 bits.
  [[nodiscard]] std::uint64_t texels(int log2_size) const {
    return std::min<std::uint64_t>(static_cast<std::uint64_t>(span) << log2_size, std::uint64_t{1} << 38);
  }

  /// Values of the coordinate itself, in its fixed-point format shifted right by the guard bits. Where the span has
  /// more bits than a fit takes, the values lack the lowest `lacking` bits as well. The error that this makes is below
  /// 2^-22 of the span anywhere in a picture.
  void affine(int log2_size, int fraction, std::array<std::int32_t, 3>& values, std::uint32_t& base,
              std::uint32_t& lacking) const {
    const int to_format = log2_size + fraction - unit_bits, to_values = to_format - (32 - affine_bits);
    const int surplus = std::max(0, bit_count(span) + to_values - affine_bits);
    for (unsigned i = 0; i < 3; ++i) values[i] = signed_word(shifted(above[i], to_values - surplus));
    base = scaled(least, to_format);
    lacking = word(surplus);
  }

  /// Values of the coordinate times w. The coordinate is first reduced by whole textures and scaled into [1/4, 3/4],
  /// which leaves a margin for block ends outside the polygon.
  void perspective(int log2_size, int fraction, const std::array<std::int32_t, 3>& w,
                   std::array<std::int32_t, 3>& values, std::uint32_t& base, std::uint32_t& shift) const {
    const int to_format = log2_size + fraction - unit_bits;
    const std::uint32_t first = word(least) & ((1u << unit_bits) - 1);
    // Spans of 1,024 textures and more lack the lowest bits, so that sums fit a word.
    const int dropped = span >= (1u << 30) - first ? 3 : 0;
    const auto from_whole = [&](std::uint32_t over) { return (over >> dropped) + (first >> dropped); };
    // 2^exponent holds twice that span.
    const int exponent = std::clamp(bit_count(from_whole(span)) + dropped + 1, unit_bits + 2, 34);
    for (unsigned i = 0; i < 3; ++i) {
      const std::uint32_t share = quarter + shifted(from_whole(above[i]), 30 - exponent + dropped);
      values[i] = signed_word((multiply_high(word(w[i]) << 8, share) + 32) >> 6);
    }
    shift = word(30 - exponent - to_format);
    const std::int32_t whole = least - signed_word(first);
    base = scaled(whole, to_format) - scaled(1, exponent - 2 + to_format);
  }
};

/// w at the corners, normalised so that the greatest fills 24 bits.
void set_w(const std::array<TextureVertex, 3>& corners, TexturePlaneValues& values) {
  const std::uint32_t greatest = std::max({corners[0].nearness, corners[1].nearness, corners[2].nearness});
  const int zeros = leading_zeros_32(greatest);
  for (unsigned i = 0; i < 3; ++i)
    values.w[i] = std::clamp<std::int32_t>(signed_word((corners[i].nearness << zeros) >> 8), 64, (1 << 24) - 1);
}
void set_perspective(const Axis& s, const Axis& t, const TexelScale& scale, TexturePlaneValues& values) {
  values.bits = perspective_bits;
  s.perspective(scale.log2_width, scale.fraction_u, values.w, values.u, values.base_u, values.shift_u);
  t.perspective(scale.log2_height, scale.fraction_v, values.w, values.v, values.base_v, values.shift_v);
}

}  // namespace

TexturePlaneValues texture_plane_values(const std::array<TextureVertex, 3>& corners, TextureMapping mapping,
                                        const TexelScale& scale) {
  TexturePlaneValues values{};
  const auto& [a, b, c] = corners;
  const Axis s(a.s, b.s, c.s), t(a.t, b.t, c.t);
  set_w(corners, values);
  const auto [low, high] = std::minmax({values.w[0], values.w[1], values.w[2]});
  // Affine mapping differs from perspective most near the middle of the polygon, by span · (high − low) / (2 (high +
  // low)). Up to 1/32 texel is accepted.
  const std::uint64_t texels = std::max(s.texels(scale.log2_width), t.texels(scale.log2_height));
  const bool level = texels * static_cast<std::uint32_t>(high - low) <=
                     (std::uint64_t{1} << 16) * static_cast<std::uint32_t>(high + low);
  if (mapping == TextureMapping::affine || level) {
    values.way = TexturePlane::Way::affine;
    values.bits = affine_bits;
    s.affine(scale.log2_width, scale.fraction_u, values.u, values.base_u, values.shift_u);
    t.affine(scale.log2_height, scale.fraction_v, values.v, values.base_v, values.shift_v);
    return values;
  }
  set_perspective(s, t, scale, values);
  values.way =
      signed_word(values.shift_u | values.shift_v) < 0 ? TexturePlane::Way::wide_blocks : TexturePlane::Way::blocks;
  return values;
}

TexturePlaneValues far_texture_plane_values(std::array<TextureVertex, 3> corners, TextureMapping mapping,
                                            const TexelScale& scale) {
  TexturePlaneValues values{};
  auto& [a, b, c] = corners;
  if (mapping == TextureMapping::affine) a.nearness = b.nearness = c.nearness;
  set_w(corners, values);
  set_perspective({a.s, b.s, c.s}, {a.t, b.t, c.t}, scale, values);
  values.way = TexturePlane::Way::exact_far;
  return values;
}

}  // namespace spanline
