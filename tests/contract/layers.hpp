#pragma once
#include <cstddef>
#include <cstdint>

#include "spanline/model/material.hpp"

namespace spanline::contract {

/// Triangles on screen come in batches of so many, each of a material of its own.
inline constexpr std::size_t batch_length = 3;

/// Materials of batches and instances: one in five is opaque, others mix colours or have patterns, by all opacities.
[[nodiscard]] constexpr Material material_of(std::size_t batch) {
  constexpr Transparency kinds[] = {Transparency::blend, Transparency::screen_door, Transparency::blend,
                                    Transparency::add, Transparency::stochastic};
  Material material;
  material.opacity = static_cast<std::uint8_t>(batch * 89 + 40);
  material.transparency = kinds[batch % 5];
  if (batch % 5 == 2) material.opacity = 255;
  return material;
}

}  // namespace spanline::contract
