#pragma once
#include <cstdint>

#include "spanline/math/bits.hpp"
#include "spanline/model/material.hpp"
#include "spanline/pixel/premultiplied.hpp"
#include "spanline/shade/layer/stipple.hpp"
#include "spanline/shade/shading_group.hpp"

namespace spanline {

/// Whether anything may be seen through a material once its opacity is rounded. A surface whose opacity varies may be
/// seen through in any case.
[[nodiscard]] constexpr bool is_see_through(const Material& material) {
  if (material.transparency == Transparency::add) return true;
  if (material.opacity == 255) return false;
  if (material.transparency == Transparency::blend) return alpha_32(material.opacity) < opaque_alpha;
  return stipple::level_of(material.opacity) < stipple::levels;
}

[[nodiscard]] constexpr bool is(Layering layering, Transparency transparency) {
  return layering.transparency == static_cast<unsigned>(transparency);
}
/// Whether the group's colours are mixed with those behind; otherwise each pixel is either opaque or left out.
[[nodiscard]] constexpr bool mixes(Layering layering) {
  return is(layering, Transparency::blend) || is(layering, Transparency::add);
}
/// The layering of group `number` with a see-through material. `seed` in [0, 127] is used by stochastic transparency.
[[nodiscard]] constexpr Layering layering_of(const Material& material, std::uint32_t number, std::uint32_t seed) {
  Layering layering;
  layering.transparency = static_cast<std::uint16_t>(static_cast<unsigned>(material.transparency) & 3u);
  const std::uint32_t level = mixes(layering) ? alpha_32(material.opacity) : stipple::level_of(material.opacity);
  const std::uint32_t variant = is(layering, Transparency::stochastic) ? seed : number;
  layering.level = static_cast<std::uint16_t>(level & 127u);
  layering.variant = static_cast<std::uint16_t>(variant & 127u);
  return layering;
}

/// The group's level where the surface has `opacity`/255 of the material's opacity, rounded to nearest.
[[nodiscard]] constexpr std::uint32_t level_at(Layering layering, std::uint32_t opacity) {
  return word(in_255ths(signed_word(layering.level * opacity)));
}

/// A pixel of a layer whose colours mix: a colour that is not premultiplied, and its coverage.
template <class Format>
struct PixelLayer {
  typename Format::Pixel pixel;
  std::uint8_t alpha;  ///< coverage, 32nds, [0, 32]
  bool adds;           ///< whether it adds its colour (Transparency::add)

  /// Composes the layer over a pixel.
  void over(typename Format::Pixel& below) const {
    const std::uint32_t above = Format::from_rgb565(pixel),
                        under = Format::from_rgb565(below);  // from_rgb565 is its own inverse
    below = Format::from_rgb565(static_cast<std::uint16_t>(adds ? added_565(under, dimmed(above))
                                                                : Premultiplied565::from(above, alpha).over(under)));
  }
  /// The colour times α, rounded to RGB565.
  [[nodiscard]] std::uint32_t dimmed(std::uint32_t rgb565) const {
    return Premultiplied565::from(rgb565, alpha).over(0);
  }
};

}  // namespace spanline
