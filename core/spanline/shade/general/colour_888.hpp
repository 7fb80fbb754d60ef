#pragma once
#include <cstdint>

#include "spanline/math/bits.hpp"
#include "spanline/model/colour.hpp"
#include "spanline/shade/general/frame_effects.hpp"

namespace spanline {

/// A colour of three 8-bit channels, held as integers for arithmetic.
struct Colour888 {
  std::int32_t red, green, blue;

  [[nodiscard]] static Colour888 from(Rgb888 c) { return {c.red, c.green, c.blue}; }
  /// Applies f to each channel; f receives a pointer to the channel's member.
  template <class F>
  [[nodiscard]] static Colour888 of(F channel) {
    return {channel(&Colour888::red), channel(&Colour888::green), channel(&Colour888::blue)};
  }
};

[[nodiscard]] inline std::int32_t mixed(std::int32_t from, std::int32_t to, std::int32_t share_in_255ths) {
  return in_255ths(from * (255 - share_in_255ths) + to * share_in_255ths);
}
[[nodiscard]] inline Colour888 mixed(const Colour888& from, const Colour888& to, std::int32_t share_in_255ths) {
  return Colour888::of([&](auto c) { return mixed(from.*c, to.*c, share_in_255ths); });
}

/// Applies the frame's last effects to a colour: fog by nearness, then either rounding to RGB565 or ordered dither by
/// screen position.
[[nodiscard]] inline std::uint16_t finished_rgb565(const FrameEffects& effects, Colour888 colour,
                                                   std::uint32_t nearness, std::uint32_t column, std::uint32_t row) {
  if (effects.fogged)
    colour = mixed(colour, Colour888::from(effects.fog_colour), signed_word(effects.fog.at(nearness)));
  const std::int32_t threshold = effects.dither ? dither_thresholds[(column & 3) + (row & 3) * 4] : 127;
  const auto rounded = [threshold](std::int32_t value, std::int32_t greatest) {
    return word(((value * greatest + threshold) * 0x8081) >> 23);
  };
  return static_cast<std::uint16_t>(rounded(colour.red, 31) << 11 | rounded(colour.green, 63) << 5 |
                                    rounded(colour.blue, 31));
}

}  // namespace spanline
