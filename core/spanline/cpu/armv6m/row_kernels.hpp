#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>

#include "spanline/cpu/armv6m/flat_rows.hpp"
#include "spanline/cpu/armv6m/ramp_rows.hpp"
#include "spanline/raster/active_triangle.hpp"
#include "spanline/raster/span.hpp"

#if defined(__ARM_ARCH_6M__)
namespace spanline::armv6m {

/// A surface that has one pixel value.
template <class Surface>
inline constexpr bool flat_surface = [] {
  if constexpr (requires(const Surface& surface) { surface.source(0); })
    return decltype(std::declval<Surface>().source(0))::constant;
  return false;
}();

template <class Target>
[[nodiscard]] const BandTargetWords* words(const Target& target) {
  using Plain = typename Target::Plain;
  static_assert(offsetof(Plain, depth) == 0 && offsetof(Plain, pixels) == 4 && offsetof(Plain, width) == 8 &&
                offsetof(Plain, first_row) == 12);
  return reinterpret_cast<const BandTargetWords*>(static_cast<const Plain*>(&target));
}

/// Draws the rows of a small or medium triangle in one pixel value.
template <class Surface, class Target>
void draw_flat_rows(const ActiveTriangle& triangle, const Surface& surface, const Target& target, std::int32_t rows,
                    std::int32_t rows_after) {
  const std::uint32_t pixel = surface.source(0).get();
  if (triangle.flags.size() == ActiveTriangle::Size::small)
    flat_rows_short(&triangle, pixel, words(target), rows, rows_after);
  else
    flat_rows_long(&triangle, pixel, words(target), rows, rows_after);
}

/// Draws the rows of a small triangle whose pixels come from a ramp.
template <RampSurface Surface, class Target>
void draw_ramp_rows(const ActiveTriangle& triangle, const Surface& surface, const Target& target, std::int32_t rows,
                    std::int32_t rows_after) {
  static_assert(offsetof(Surface, intensity) == 0 && offsetof(Surface, ramp) == 12);
  ramp_rows(&triangle, reinterpret_cast<const RampSurfaceWords*>(&surface), words(target), rows, rows_after);
}

}  // namespace spanline::armv6m
#endif
