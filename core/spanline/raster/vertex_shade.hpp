#pragma once
#include <cstdint>

namespace spanline {

/// The data of a vertex for interpolated shading: one word with an intensity or a colour, with or without opacity.
///
/// Values stay away from the ends of their range, so that rounding of an interpolated plane cannot wrap.
namespace vertex_shade {

enum class Kind : std::uint8_t {
  intensity,                ///< in units of 1/65536 of full light, [64, 65471]
  colour,                   ///< a lit colour: 11 bits of red, 11 of green and 10 of blue, from the top
  colour_and_opacity,       ///< 8 bits each of red, green, blue and opacity, from the top
  highlight_and_intensity,  ///< 16 bits each from the top, both in the format of intensities
};

inline constexpr std::uint32_t lowest_intensity = 64, highest_intensity = 65471;

/// Packs channels of 11, 11 and 10 bits, at least 64/65536 from the ends: red and green in [2, 2045], blue in [1,
/// 1022].
[[nodiscard]] constexpr std::uint32_t pack(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
  return red << 21 | green << 10 | blue;
}
/// Channels as 16-bit values for interpolation.
[[nodiscard]] constexpr std::int32_t red_16(std::uint32_t shade) { return static_cast<std::int32_t>(shade >> 21) << 5; }
[[nodiscard]] constexpr std::int32_t green_16(std::uint32_t shade) {
  return static_cast<std::int32_t>((shade >> 10) & 2047) << 5;
}
[[nodiscard]] constexpr std::int32_t blue_16(std::uint32_t shade) {
  return static_cast<std::int32_t>(shade & 1023) << 6;
}

/// Packs bytes for Kind::colour_and_opacity.
[[nodiscard]] constexpr std::uint32_t pack(std::uint32_t red, std::uint32_t green, std::uint32_t blue,
                                           std::uint32_t opacity) {
  return red << 24 | green << 16 | blue << 8 | opacity;
}
/// Byte `place` of such a word, counted from the top, as a 16-bit value away from the ends of the range.
[[nodiscard]] constexpr std::int32_t byte_16(std::uint32_t shade, unsigned place) {
  const std::uint32_t value = ((shade >> (24 - 8 * place)) & 255) * 257;
  return static_cast<std::int32_t>(value < lowest_intensity    ? lowest_intensity
                                   : value > highest_intensity ? highest_intensity
                                                               : value);
}

/// Packs 16-bit values for Kind::highlight_and_intensity. The intensity has the same place as in Kind::intensity.
[[nodiscard]] constexpr std::uint32_t pack(std::uint32_t highlight, std::uint32_t intensity) {
  return highlight << 16 | intensity;
}
[[nodiscard]] constexpr std::int32_t intensity_16(std::uint32_t shade) {
  return static_cast<std::int32_t>(shade & 0xffff);
}
[[nodiscard]] constexpr std::int32_t highlight_16(std::uint32_t shade) {
  return static_cast<std::int32_t>(shade >> 16);
}

/// How many channels are interpolated, and the 16-bit value of one.
[[nodiscard]] constexpr unsigned channels(Kind kind) {
  constexpr unsigned counts[] = {1, 3, 4, 2};
  return counts[static_cast<unsigned>(kind)];
}
[[nodiscard]] constexpr std::int32_t channel_16(Kind kind, std::uint32_t shade, unsigned channel) {
  switch (kind) {
    case Kind::intensity:
      return static_cast<std::int32_t>(shade);
    case Kind::colour:
      return channel == 0 ? red_16(shade) : channel == 1 ? green_16(shade) : blue_16(shade);
    case Kind::colour_and_opacity:
      return byte_16(shade, channel);
    case Kind::highlight_and_intensity:
      return channel == 0 ? highlight_16(shade) : intensity_16(shade);
  }
  return 0;
}

/// from + (to − from)·t; t is Q31 in [0, 1].
[[nodiscard]] constexpr std::uint32_t mix_word(std::uint32_t from, std::uint32_t to, std::uint32_t t) {
  const std::int64_t difference = static_cast<std::int64_t>(to) - static_cast<std::int64_t>(from);
  return from + static_cast<std::uint32_t>(static_cast<std::uint64_t>((difference * t) >> 31));
}
/// Interpolates each channel of a shade; t is Q31 in [0, 1].
[[nodiscard]] constexpr std::uint32_t mix(Kind kind, std::uint32_t from, std::uint32_t to, std::uint32_t t) {
  if (kind == Kind::intensity) return mix_word(from, to, t);
  if (kind == Kind::colour_and_opacity) {
    const auto byte = [&](unsigned shift) { return mix_word((from >> shift) & 255, (to >> shift) & 255, t); };
    return pack(byte(24), byte(16), byte(8), byte(0));
  }
  if (kind == Kind::highlight_and_intensity)
    return pack(mix_word(from >> 16, to >> 16, t), mix_word(from & 0xffff, to & 0xffff, t));
  return pack(mix_word(from >> 21, to >> 21, t), mix_word((from >> 10) & 2047, (to >> 10) & 2047, t),
              mix_word(from & 1023, to & 1023, t));
}

}  // namespace vertex_shade
}  // namespace spanline
