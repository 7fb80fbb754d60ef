#pragma once
#include <spanline/visibility/registry.hpp>

#include "drawing.hpp"

namespace spanline::contract {

// One visibility algorithm at work, each in translation units of its own, which the build makes of drawer_by.cpp.in and
// surface_drawer_by.cpp.in.

struct AlgorithmDrawer {
  Drawing (*draw)(const Scene&, const Manner&);
  Drawing (*draw_16_bits)(const Scene&, const Manner&);  ///< ids alone
};
template <AlgorithmId Unit>
[[nodiscard]] AlgorithmDrawer algorithm_drawer();
#define SPANLINE_ALGORITHM(id, ...) \
  template <>                       \
  AlgorithmDrawer algorithm_drawer<AlgorithmId::id>();
#include "spanline/visibility/algorithms.def"

/// Colours by a renderer that has every shader. It takes long to compile, and fuzzers do without.
using SurfaceDrawer = Drawing (*)(const Scene&, const Manner&);
template <AlgorithmId Unit>
[[nodiscard]] SurfaceDrawer algorithm_surface_drawer();
#define SPANLINE_ALGORITHM(id, ...) \
  template <>                       \
  SurfaceDrawer algorithm_surface_drawer<AlgorithmId::id>();
#include "spanline/visibility/algorithms.def"

}  // namespace spanline::contract
