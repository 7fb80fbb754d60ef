#pragma once
#include <array>
#include <cstdint>

#include "spanline/cpu/clamp_to_bits.hpp"
#include "spanline/math/bits.hpp"
#include "spanline/pixel/pixel_format.hpp"
#include "spanline/pixel/spread_565.hpp"
#include "spanline/raster/linear_function.hpp"
#include "spanline/raster/polygon_corners.hpp"
#include "spanline/shade/general/frame_effects.hpp"
#include "spanline/shade/shading_group.hpp"
#include "spanline/shade/texture/texture_shader.hpp"

namespace spanline {

/// Light on texels in a frame with fog. The light is full, constant over a polygon, or interpolated between the
/// vertices; the fog has a share of each pixel.
///
/// Both are computed where blocks of 16 screen columns end: the fog from its table over nearness, and the light
/// multiplied by the share that the fog leaves. Between block ends they are linear, and each piece of 4 columns uses
/// one level of both. A channel is (texel · light + fog colour · fog)/32, rounded to nearest. The two levels are 32nds,
/// rounded to nearest, and their sum is at most 32.
struct FoggedTexelLight {
  static constexpr bool interpolates = true, fogged = true;
  static constexpr std::uint32_t block_columns = 16, piece_columns = 4;

  /// Levels of light and fog, 32nds with 10 fraction bits.
  struct Levels {
    std::uint32_t light, fog;
  };

  struct Stepper {
    std::uint32_t light;         ///< level of the current piece, 32nds
    std::uint32_t fog;           ///< fog colour times its level, plus ½ in each channel; a spread word times 32
    std::uint32_t levels, step;  ///< light in bits 31…16 and fog in bits 15…0, and their step a piece; 10 fraction bits
    const FoggedTexelLight* surface;
    Levels end;  ///< levels at the end of the block
    std::int32_t end_column;

    [[nodiscard]] std::uint32_t apply(std::uint32_t rgb565) const {
      return spread_565::joined((spread_565::from(rgb565) * light + fog) >> 5 & spread_565::mask);
    }
    void forward() {}
    void back() {}
    /// Moves to the next piece of the block.
    void next_piece() {
      levels += step;
      set();
    }
    /// Moves to the first piece of the next block.
    void next_block() {
      const Levels start = end;
      end_column += static_cast<std::int32_t>(block_columns);
      end = surface->levels_at(end_column);
      const std::int32_t light_way = signed_word(end.light - start.light), fog_way = signed_word(end.fog - start.fog);
      // The levels at the middle of the first piece, plus ½ for rounding. One of the two halves is smaller by one unit,
      // so that levels whose sum is 32 are not both rounded up.
      const std::uint32_t first_light = start.light + word(light_way >> 3) + 511;
      const std::uint32_t first_fog = start.fog + word(fog_way >> 3) + 512;
      step = (word(light_way >> 2) << 16) + word(fog_way >> 2);
      levels = (first_light << 16) + first_fog;
      set();
    }
    void skip(std::uint32_t pieces) {
      levels += pieces * step;
      set();
    }

   private:
    void set() {
      constexpr std::uint32_t half = 16u << 21 | 16u << 11 | 16;
      light = levels >> 26;
      fog = surface->fog_colour * (levels >> 10 & 63) + half;
    }
  };

  LinearFunction light, nearness;  ///< Q28, signed, because a block may end outside the polygon
  const FogTable* fog;
  std::uint32_t fog_colour;
  std::int16_t origin;  ///< screen column of column 0

  void next_row() {
    light.next_row();
    nearness.next_row();
  }
  void skip_rows(std::int32_t rows) {
    light.skip_rows(rows);
    nearness.skip_rows(rows);
  }
  /// The levels at the start of the block that begins at `column`.
  [[nodiscard]] Levels levels_at(std::int32_t column) const {
    const std::uint32_t share = fog->at(in_28_bits(nearness.at(column)) << 4), share_256 = share + (share >> 7);
    return {(in_28_bits(light.at(column)) >> 13) * (256 - share_256) >> 8, share_256 << 7};
  }
  [[nodiscard]] Stepper at(std::int32_t column) const {
    const std::uint32_t into = word(column + origin) & (block_columns - 1);
    Stepper stepper;
    stepper.surface = this;
    stepper.end_column = column - signed_word(into);
    stepper.end = levels_at(stepper.end_column);
    stepper.next_block();
    stepper.skip(into / piece_columns);
    return stepper;
  }

  [[nodiscard]] static bool serves(const Material& material) {
    return NoTexelLight::serves(material) || texel_light::plain(material);
  }
  template <class Gradients>
  void make(const ShadingGroup& group, const PolygonCorners& polygon, const Gradients& gradients) {
    const FrameEffects& effects = *group.textured->effects;
    fog = &effects.fog;
    fog_colour = spread_565::from(Rgb565::from(effects.fog_colour));
    origin = static_cast<std::int16_t>(gradients.origin());
    const auto corners = gradients.corners();
    const auto near = [&](unsigned i) { return effects.fog.nearness(corners[i]->depth_word >> 8) >> 4; };
    fit({near(0), near(1), near(2)}, gradients, nearness);
    fit_light(group, polygon, gradients);
  }

 private:
  /// Clamps a signed value in Q28 to [0, 1).
  [[nodiscard]] static std::uint32_t in_28_bits(std::uint32_t value) { return clamp_to_bits<28>(signed_word(value)); }
  /// Fits a function to 20-bit values at the corners. If it is so steep that it could overflow at the end of a block,
  /// the polygon is only a column or two wide and gets a constant.
  template <class Gradients>
  static void fit(const std::array<std::int32_t, 3>& values, const Gradients& gradients, LinearFunction& function) {
    constexpr std::int32_t bias = 1 << 23;  // the fit takes numbers in [0, 2^24)
    gradients.fit_fine({bias + values[0], bias + values[1], bias + values[2]}, 24, function);
    if (magnitude(signed_word(function.dx)) >= 1u << 27) function = {word(bias + values[0]) << 8, 0, 0};
    function.at_origin -= word(bias) << 8;
  }
  template <class Gradients>
  void fit_light(const ShadingGroup& group, const PolygonCorners& polygon, const Gradients& gradients) {
    const auto corners = gradients.corners();
    const auto constant = [&](std::uint32_t intensity) { light = {intensity << 12 | 1u << 11, 0, 0}; };
    if (group.textured->texturing.function == TextureFunction::replace) {
      constant(65535);
    } else if (group.vertex_shades != nullptr) {
      const auto value = [&](unsigned i) { return signed_word(group.vertex_shades[gradients.index(corners[i])] << 4); };
      fit({value(0), value(1), value(2)}, gradients, light);
    } else {
      constant(group.polygon_intensity(polygon.polygon));
    }
  }
};

/// The variant of NearestTextureShader for frames with fog, lit or unlit.
template <class Format, TexelFormat Texels>
using FoggedTextureShader = TextureShader<Format, NearestTexels<Texels>, FoggedTexelLight>;

}  // namespace spanline
