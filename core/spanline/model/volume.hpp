#pragma once
/// @file
/// Surfaces cut from a solid, for renderers with `VolumeShader`.
///
/// ```cpp
/// #include <spanline/model/material.hpp>
///
/// static std::uint8_t rings[32 * 32 * 32];  // filled at start, or a table in flash
/// static std::uint16_t browns[256];
/// static const VolumeTexture wood{.log2_size = 5, .cells = rings, .palette = browns};
/// const Material carved{.volume = {.source = SolidSource::table, .texture = &wood, .scale = 0.5_q16}};
/// ```
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/math/vector.hpp"

namespace spanline {

/// A solid as a table: a cube of 2^log2_size cells a side, x fastest, then y, then z, repeated along all three axes.
struct VolumeTexture {
  static constexpr unsigned max_log2_size = 7;  ///< of a side
  std::uint8_t log2_size = 0;                ///< of a side in cells, 0 … max_log2_size; 0 by default, a single cell
  std::span<const std::uint8_t> cells{};     ///< indices into the palette
  std::span<const std::uint16_t> palette{};  ///< 256 RGB565 colours

  /// Whether the side is in its range and the tables are long enough.
  [[nodiscard]] constexpr bool valid() const {
    return log2_size <= max_log2_size && cells.size() >= std::size_t{1} << (3 * log2_size) && palette.size() == 256;
  }
};

/// What gives the colour at a point of a solid.
enum class SolidSource : std::uint8_t {
  none,      ///< no solid: colours and textures of the surface
  table,     ///< `Volume::texture`
  function,  ///< a function that one of the renderer's shaders has (shade/pixelwise/volume.hpp)
};

/// A surface cut from a solid (volumetric texture, lecture 004): each point has the colour of the solid at its position
/// in the mesh's own space, however the instance turns. The texture coordinates s, t, r of a point are origin + scale ·
/// 2^exponent · (x, y, z) with (x, y, z) in world units before the instance's transform. 1 is the whole cube; |s|, |t|
/// and |r| are below 2,048.
struct Volume {
  SolidSource source = SolidSource::none;  ///< none by default
  const VolumeTexture* texture = nullptr;  ///< for SolidSource::table; must stay valid until the frame is drawn
  Q16_16 scale = Q16_16::from_int(1);      ///< cubes a world unit before 2^exponent is applied: Q16.16; 1 by default
  std::int8_t exponent = 0;                ///< power of two that multiplies the scale, [−30, 30]; 0 by default
  Position origin{};                       ///< s, t and r of the mesh's origin, cubes, Q16.16; 0 by default
};

}  // namespace spanline
