#pragma once
#include <cstdint>

#include "spanline/visibility/span/awake_polygon.hpp"

namespace spanline {

/// Occlusion over many rows: a polygon that is behind another by its bounds and lies within the other's columns stays
/// hidden for as long as the straight edges of both keep it inside. Meanwhile it can sleep, that is, leave the
/// active-edge table.
namespace polygon_sleep {

inline constexpr std::int32_t least_rows = 12;       ///< rows; shorter sleeps cost more than they save
inline constexpr std::int32_t rows_until_retry = 8;  ///< rows to wait after an attempt that failed

/// The first row on which `front` may no longer hide `hidden`, both set up on `row`; 0 if it is less than `least_rows`
/// away. Edges are straight up to their next turn, so columns that are included on two rows are included on all rows
/// between them. If the farthest row before a turn fails, the distance is halved repeatedly.
[[nodiscard]] std::int32_t hidden_until(const AwakePolygon& hidden, const AwakePolygon& front, std::int32_t row,
                                        std::int32_t width);

/// Puts `hidden` to sleep if `front` hides it for enough rows: its record is released on the next row, and its number
/// goes into the bucket of the row where it wakes again. Otherwise returns false and prevents further attempts for
/// `rows_until_retry` rows.
bool fall_asleep(AwakePolygon& hidden, const AwakePolygon& front, PolygonTable& table, std::int32_t row,
                 std::int32_t width);

}  // namespace polygon_sleep
}  // namespace spanline
