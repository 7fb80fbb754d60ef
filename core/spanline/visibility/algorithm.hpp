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
#include "spanline/visibility/algorithm_needs.hpp"
#include "spanline/visibility/band_target.hpp"
#include "spanline/visibility/frame_input.hpp"

/// The interface of a visibility algorithm: the concept VisibilityAlgorithm and its parts. The comment of each part
/// describes the functions that it requires. `docs/visibility.md` shows how to add an algorithm, with the code that
/// draws a polygon on a row.
namespace spanline {

/// Properties of an algorithm that hold for all frames.
template <class A>
concept StatesItsFacts = requires {
  { A::needs } -> std::convertible_to<AlgorithmNeeds>;
  /// Bands have a depth buffer.
  { A::keeps_depth } -> std::convertible_to<bool>;
  /// The algorithm reads the depth buffer. An algorithm that does not read it may still write it for inspection when
  /// counting is on. It gets cut-out textures in see-through groups, or not at all if its shaders have none for those.
  { A::tests_depth } -> std::convertible_to<bool>;
  /// Drawing changes the table's buckets and references, so two cores cannot draw from one table.
  { A::takes_table_apart } -> std::convertible_to<bool>;
  /// A band may be cleared while the band above it is being drawn.
  { A::clears_ahead } -> std::convertible_to<bool>;
  /// The names of the algorithm's own counters, in the order of VisibilityCounters::own.
  {std::span<const std::string_view>(A::counter_names)};
};

/// The algorithm's part of the caller's memory, cut off an arena. `takes` tells whether the algorithm can number and
/// address pools of that size. `bucket_lines` is the number of rows that share a bucket of the polygon table; an
/// algorithm that does not use buckets returns `capacity.height`.
template <class A>
concept TakesMemory = requires(typename A::Memory memory, Arena& arena, const Capacity& capacity) {
  { A::takes(capacity) } -> std::same_as<bool>;
  { A::bucket_lines(capacity) } -> std::convertible_to<std::uint32_t>;
  memory.take(arena, capacity);
  A();
  A(memory);
};

/// `begin_frame(input)` is called once a frame, before any band. An algorithm can sort polygons or walk a tree there.
template <class A>
concept BeginsFrames = requires(A algorithm, const FrameInput& input) {
  { algorithm.begin_frame(input) } -> std::same_as<void>;
};

/// `clear(target, fill)` prepares a band for drawing. It fills memory by calls of `fill(value, count, words)`.
template <class A>
concept ClearsBands = requires(A algorithm, const typename A::Target& target) {
  algorithm.clear(target, [](auto /*value*/, std::uint32_t /*count*/, auto* /*words*/) {});
};

/// Is called with the id of each polygon that covers a pixel centre, at least once, if the algorithm counts.
struct CoveredListener {
  void operator()(std::uint32_t id) const;
};

/// `draw_band(table, shading, band, viewport, target, covered)` draws the rows of `target`; bands come from top to
/// bottom. It passes runs of pixels to the shaders of its list: `Shaders::with(group.shader, …)` gives the shader of a
/// polygon's group, `make_surface` fills the shader's surface, and `Shaders::fill` writes a run that is certain to be
/// visible.
template <class A, class Group>
concept DrawsBands = requires(A algorithm, PolygonTable& table, std::span<const Group> shading, std::int32_t band,
                              Viewport viewport, const typename A::Target& target, const CoveredListener& covered) {
  { algorithm.draw_band(table, shading, band, viewport, target, covered) } -> std::same_as<void>;
};

/// `skip_band(table, shading, band, viewport, target)` steps over a band that another core draws. Only the rows and the
/// width of `target` are used. Afterwards the algorithm is in the same state as if it had drawn the band.
template <class A, class Group>
concept SkipsBands = requires(A algorithm, PolygonTable& table, std::span<const Group> shading, std::int32_t band,
                              Viewport viewport, const typename A::Target& target) {
  { algorithm.skip_band(table, shading, band, viewport, target) } -> std::same_as<void>;
};

/// These are called after the last band. `shortage(input)` names the pool that was too small for the frame and the size
/// that the frame needs. `note_peaks(peaks)` enters the most bytes that the algorithm's pools had in use.
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
