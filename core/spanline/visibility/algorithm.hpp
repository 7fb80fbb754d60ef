#pragma once
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "spanline/memory/arena.hpp"
#include "spanline/memory/capacity.hpp"
#include "spanline/memory/pool.hpp"
#include "spanline/memory/pool_peaks.hpp"
#include "spanline/raster/gradients.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/visibility/band_target.hpp"
#include "spanline/visibility/frame_input.hpp"

/// What a renderer asks of a visibility algorithm: the concept VisibilityAlgorithm, and its parts, each of which says
/// in its comment what the functions do. `docs/visibility.md` has the recipe, with a whole algorithm as its example.
namespace spanline {

/// What an algorithm works on.
enum class AlgorithmNeeds : std::uint8_t {
  screen_polygons,  ///< the polygon table alone, whether its polygons come from meshes or were given on screen
  world,            ///< also FrameInput::world, so polygons that were given on screen cannot be drawn
};

/// Facts that hold for all frames.
template <class A>
concept StatesItsFacts = requires {
  { A::needs } -> std::convertible_to<AlgorithmNeeds>;
  /// Bands have a depth buffer.
  { A::keeps_depth } -> std::convertible_to<bool>;
  /// The algorithm reads the depth buffer; otherwise it is written for others to look at, where the traits count.
  { A::tests_depth } -> std::convertible_to<bool>;
  /// Drawing changes the table's buckets and references, so that no two may draw from one table.
  { A::takes_table_apart } -> std::convertible_to<bool>;
  /// A band may be cleared while the one above it is being drawn.
  { A::clears_ahead } -> std::convertible_to<bool>;
  /// Names of its own counters, VisibilityCounters::own, in that order.
  {std::span<const std::string_view>(A::counter_names)};
};

/// The algorithm's part of the caller's memory, cut off an arena. `takes` tells whether the algorithm can number and
/// address pools of that size; `bucket_lines` how many rows share a bucket of the polygon table (`capacity.height` for
/// who does not use buckets).
template <class A>
concept TakesMemory = requires(typename A::Memory memory, Arena& arena, const Capacity& capacity) {
  { A::takes(capacity) } -> std::same_as<bool>;
  { A::bucket_lines(capacity) } -> std::convertible_to<std::uint32_t>;
  memory.take(arena, capacity);
  A();
  A(memory);
};

/// `begin_frame(input)` comes once a frame, before any band: the place to sort polygons or to walk a tree.
template <class A>
concept BeginsFrames = requires(A algorithm, const FrameInput& input) {
  { algorithm.begin_frame(input) } -> std::same_as<void>;
};

/// `clear(target, fill)` makes a band ready for drawing by `fill(value, count, words)`.
template <class A>
concept ClearsBands = requires(A algorithm, const typename A::Target& target) {
  algorithm.clear(target, [](auto /*value*/, std::uint32_t /*count*/, auto* /*words*/) {});
};

/// Takes the id of each polygon that covers a pixel centre, once at least, where the algorithm counts.
struct CoveredListener {
  void operator()(std::uint32_t id) const;
};

/// `draw_band(table, shading, band, viewport, target, covered)` draws the rows of `target`, bands from top to bottom.
/// It hands runs of pixels to the shaders of its list: `Shaders::with(group.shader, …)` names the shader of a polygon's
/// group, `make_surface` fills its surface, `Shaders::fill` writes a run that is certain to be visible.
template <class A, class Group>
concept DrawsBands = requires(A algorithm, PolygonTable& table, std::span<const Group> shading, std::int32_t band,
                              Viewport viewport, const typename A::Target& target, const CoveredListener& covered) {
  { algorithm.draw_band(table, shading, band, viewport, target, covered) } -> std::same_as<void>;
};

/// `skip_band(table, shading, band, viewport, target)` steps over a band that another core draws; of its target, rows
/// and width count. It leaves the algorithm as drawing the band would have.
template <class A, class Group>
concept SkipsBands = requires(A algorithm, PolygonTable& table, std::span<const Group> shading, std::int32_t band,
                              Viewport viewport, const typename A::Target& target) {
  { algorithm.skip_band(table, shading, band, viewport, target) } -> std::same_as<void>;
};

/// Behind the last band: `shortage(input)` names the pool that was too small for the frame and the size it would have
/// taken; `note_peaks(peaks)` adds the bytes that its pools had in use at most.
template <class A>
concept ReportsPools = requires(const A& algorithm, const FrameInput& input, PoolPeaks& peaks) {
  { algorithm.shortage(input) } -> std::same_as<PoolShortage>;
  algorithm.note_peaks(peaks);
};

/// A visibility algorithm for renderers whose groups are described by `Group` (shade/shading_group.hpp).
template <class A, class Group>
concept VisibilityAlgorithm = StatesItsFacts<A> && TakesMemory<A> && BeginsFrames<A> && ClearsBands<A> &&
    DrawsBands<A, Group> && SkipsBands<A, Group> && ReportsPools<A>;

}  // namespace spanline
