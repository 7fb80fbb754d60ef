#pragma once
#include "verdict.hpp"

namespace spanline::contract {

// Colours by a renderer that has every shader, at 24 bits, smaller is nearer. It takes long to compile, and fuzzers do
// without.

[[nodiscard]] Drawing draw_surfaces(const AlgorithmEntry& algorithm, const Scene& scene, const Manner& manner);
[[nodiscard]] Drawing reference_of_surfaces(const Scene& scene, Manner manner);

inline constexpr Drawer surface_drawer{draw_surfaces, reference_of_surfaces};

}  // namespace spanline::contract
