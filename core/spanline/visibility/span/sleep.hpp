#pragma once
#include <cstdint>

#include "spanline/visibility/span/awake_polygon.hpp"

namespace spanline {

/// Occlusion from row to row: a polygon that lies behind another by bounds and within its columns stays hidden as long
/// as the straight edges of both keep it there, and can sleep meanwhile.
namespace polygon_sleep {

inline constexpr std::int32_t least_rows = 12;  ///< shorter sleeps cost more than they save
inline constexpr std::int32_t rows_until_retry = 8;

/// The row up to which `front` is certain to hide `hidden`, both standing on `row`; 0 if that is not far enough. Edges
/// are straight until their next turn: what is included strictly on two rows is included on all rows between. The
/// distance is halved a few times where the farthest row will not do.
[[nodiscard]] std::int32_t hidden_until(const AwakePolygon& hidden, const AwakePolygon& front, std::int32_t row,
                                        std::int32_t width);

/// Sends `hidden` to sleep if `front` hides it for long enough: its record ends on the next row, and its number goes
/// into the bucket of the row where it must be looked at again. False, and no attempt for some rows, if not.
bool fall_asleep(AwakePolygon& hidden, const AwakePolygon& front, PolygonTable& table, std::int32_t row,
                 std::int32_t width);

}  // namespace polygon_sleep
}  // namespace spanline
