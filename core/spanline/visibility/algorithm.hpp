#pragma once
#include <concepts>
#include <cstddef>
#include <cstdint>

#include "spanline/raster/gradients.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/visibility/band_target.hpp"

namespace spanline {

/// What a renderer asks of a visibility algorithm, beside
///
///     draw_band(table, shading, band, viewport, target, covered)
///
/// which draws the rows of `target` from the polygon table (buckets of `bucket_lines` lines) and hands runs of pixels
/// to the shaders of its list: `Shaders::with(group.shader, …)` names the shader of a polygon's group, `Shader::make`
/// fills its surface, `Shaders::fill` writes a run that is certain to be visible. Bands come from top to bottom.
/// `covered(id)` is told of every polygon that covers a pixel centre where the algorithm counts.
///
/// `skip_band(table, shading, band, viewport, target)` steps over a band that another core draws. An algorithm that
/// `takes_table_apart` changes the table's buckets and references as it goes: no two may draw from one.
///
/// `clear(target, fill)` makes a band ready for drawing, by `fill(value, count, words)`; where it `clears_ahead`, the
/// band above may still be in drawing.
/// `keeps_depth`: bands have a depth buffer; `tests_depth`: the algorithm needs it, and it is not there for show alone.
/// `Memory` is the algorithm's own part of the caller's bytes. `wanted` says how large its pool would have had to be
/// after `overflowed`. `layers_overflowed` and `layers_wanted` say the same of the pool for see-through polygons, which
/// there is where the list has shaders for them: groups that are `see_through` then.
template <class A, class Arena, class Capacity>
concept VisibilityAlgorithm = requires(A algorithm, const A& view, typename A::Memory memory, Arena arena,
                                       const Capacity capacity, const typename A::Target& target,
                                       const PolygonTable& table, Viewport viewport) {
  { A::keeps_depth } -> std::convertible_to<bool>;
  { A::tests_depth } -> std::convertible_to<bool>;
  { A::takes_table_apart } -> std::convertible_to<bool>;
  { A::clears_ahead } -> std::convertible_to<bool>;
  { A::takes(capacity) } -> std::same_as<bool>;
  { A::bucket_lines(capacity) } -> std::convertible_to<std::uint32_t>;
  memory.take(arena, capacity);
  { A::Memory::bytes(std::size_t{1}) } -> std::same_as<std::size_t>;
  { A::Memory::layer_bytes(std::size_t{1}) } -> std::same_as<std::size_t>;
  A();
  A(memory);
  algorithm.begin_frame();
  algorithm.clear(target, [](auto /*value*/, std::uint32_t /*count*/, auto* /*words*/) {});
  { view.overflowed() } -> std::same_as<bool>;
  { view.peak() } -> std::convertible_to<std::uint32_t>;
  { A::wanted(table, viewport, std::int32_t{1}) } -> std::same_as<std::uint32_t>;
  { view.layers_wanted() } -> std::same_as<std::uint32_t>;
  { view.layers_overflowed() } -> std::same_as<bool>;
};

}  // namespace spanline
