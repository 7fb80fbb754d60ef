#include "spanline/shade/pixelwise/pixelwise_surface.hpp"

#include <algorithm>

#include "spanline/shade/general/colour_888.hpp"
#include "spanline/shade/light/local_light.hpp"

namespace spanline {

std::uint16_t PixelwiseSurface::finished(const LitTexel& texel, std::int32_t column) const {
  constexpr std::int32_t half = 1 << 15;
  const auto amount = [](std::uint32_t share) {
    return signed_word(share + (share >> 15));
  };  // makes 65535, full light, 65536
  const Colour888 own = Colour888::from(widened(texel.rgb565));
  Colour888 colour =
      Colour888::of([&, shade = amount(texel.light)](auto channel) { return (own.*channel * shade + half) >> 16; });
  if (shines) {
    const Colour888 specular = Colour888::from(group->local->specular());
    colour = Colour888::of([&, shine = amount(highlight.at(column) >> 16)](auto channel) {
      return std::min<std::int32_t>(colour.*channel + ((specular.*channel * shine + half) >> 16), 255);
    });
  }
  return finished_rgb565(*group->effects, colour, nearness.at(column), word(column + plane.origin), row);
}

}  // namespace spanline
