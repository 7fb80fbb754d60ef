#include "render/obscured_sets.hpp"

#include <algorithm>
#include <cstddef>

#include "base/failure.hpp"
#include "render/refusal_text.hpp"
#include "spanline/frame/frame_pools.hpp"
#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/frame/submissions.hpp"
#include "spanline/memory/arena.hpp"
#include "spanline/raster/fan_diagonals.hpp"
#include "spanline/raster/outline_setup.hpp"
#include "spanline/raster/row_stepper.hpp"
#include "spanline/raster/triangle_setup.hpp"

namespace spanline::sim {
namespace {

/// Whether there is room for the frame's polygons; they are then in `submissions`, in the memory of the input.
template <class Traits>
Status submit(const PassInput& input, Submissions<Traits>& submissions) {
  Arena counting;
  FramePools<Traits> pools;
  pools.take(counting, input.capacity);
  const std::size_t bytes = counting.size() + Arena::alignment - 1;
  if (input.memory.size() < bytes) input.memory.resize(bytes);
  Arena arena = Arena::aligned(input.memory);
  submissions.take(arena, input.capacity);
  submissions.clear();
  submissions.begin(input.settings);
  for (std::size_t i = 0; i < input.meshes.size(); ++i)
    if (const Status status = submissions.add(input.meshes[i], Transform{}, input.materials[i]); !status.ok())
      return status;
  return {};
}

/// Calls use(triangle, first pixel, pixel count) for each run of pixels on a row that a wanted triangle covers, where
/// `wanted` is by the triangles' numbers. A triangle that was clipped or cut may come in several pieces.
template <class Depth, class Use>
void for_each_covered_run(const PolygonTable& table, Viewport viewport, const std::vector<bool>& wanted, Use use) {
  const auto line = static_cast<std::size_t>(viewport.width);
  Link group_number = 0;
  for (Link polygon = 0; polygon < table.polygon_count; ++polygon) {
    group_number = table.group_of(polygon, group_number);
    const PolygonGroup& group = table.groups[group_number];
    const PolygonEntry entry{table, group, polygon};
    const PolygonCorners corners = entry.corners();
    const std::uint32_t first_triangle = group.first_id + corners.triangle;
    ActiveTriangle active;
    FanDiagonals fan;
    if (entry.is_outline()) {
      if (!set_up_outline(entry.outline(), viewport, active)) continue;
      fan = FanDiagonals(entry.outline());
    } else {
      const auto [a, b, c] = corners.corner;
      if (!wanted[first_triangle] || !set_up<Depth>(a, b, c, group, viewport, active, [](const auto&) {})) continue;
    }
    while (active.rows_to_knee + active.rows_after_knee > 0) {
      const std::int32_t row = active.row - row_bias;
      RowColumns columns = step_row(active, [&] { return entry; });
      columns.first = std::max<std::int32_t>(active.origin + columns.first, 0);
      columns.end = std::min(active.origin + columns.end, viewport.width);
      fan.for_each_part(columns, row, [&](unsigned number, RowColumns part) {
        if (wanted[first_triangle + number])
          use(first_triangle + number, static_cast<std::size_t>(row) * line + static_cast<std::size_t>(part.first),
              static_cast<std::size_t>(part.end - part.first));
      });
    }
  }
}

/// What hides a triangle at the pixels seen so far.
struct Hiders {
  bool same = false, other = false;
};

template <class Depth>
std::vector<Hiders> find_hiders(const PassInput& input, const std::vector<std::uint32_t>& ids,
                                const std::vector<bool>& obscured, std::span<const std::uint32_t> objects) {
  using Traits = IdTraits<Depth>;
  Submissions<Traits> submissions;
  for (;;) {
    const Status status = submit<Traits>(input, submissions);
    if (status.ok()) break;
    if (status.fault != Fault::pool_full) throw Failure(refusal_text(status));
    grow(input.capacity, status);
  }
  std::vector<Hiders> hiders(obscured.size());
  const Viewport viewport{input.capacity.width, input.capacity.height};
  for_each_covered_run<Depth>(submissions.table(), viewport, obscured,
                              [&](std::uint32_t triangle, std::size_t first, std::size_t count) {
                                Hiders& of_triangle = hiders[triangle];
                                for (const std::uint32_t id : std::span(ids).subspan(first, count)) {
                                  if (id == 0)
                                    continue;  // the farthest depth may round to that of the background, which hides it
                                  const bool same = objects.empty() || objects[id - 1] == objects[triangle];
                                  (same ? of_triangle.same : of_triangle.other) = true;
                                }
                              });
  return hiders;
}

}  // namespace

ObscuredBy divide_obscured(const PassInput& input, const std::vector<std::uint32_t>& ids,
                           const std::vector<bool>& obscured, std::span<const std::uint32_t> objects) {
  const std::vector<Hiders> hiders = input.depth_bits == 16 ? find_hiders<Depth16<>>(input, ids, obscured, objects)
                                                            : find_hiders<Depth24<>>(input, ids, obscured, objects);
  ObscuredBy by;
  for (std::size_t triangle = 0; triangle < obscured.size(); ++triangle) {
    if (!obscured[triangle]) continue;
    const auto [same, other] = hiders[triangle];
    ++(same && other ? by.both : other ? by.other_object : by.same_object);
  }
  return by;
}

}  // namespace spanline::sim
