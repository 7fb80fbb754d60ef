#include "spanline/visibility/span/sleep.hpp"

namespace spanline::polygon_sleep {
namespace {

bool same(const Edge& a, const Edge& b) {
  return a.x == b.x && a.step == b.step && a.error == b.error && a.remainder == b.remainder && a.height == b.height;
}

bool same_left(const AwakePolygon& a, const AwakePolygon& b) {
  if (a.fraction_bits != b.fraction_bits || a.origin != b.origin) return false;
  return a.fraction_bits != 0 ? a.fixed.left == b.fixed.left && a.fixed.left_step == b.fixed.left_step
                              : same(a.large.left, b.large.left);
}
bool same_right(const AwakePolygon& a, const AwakePolygon& b) {
  if (a.fraction_bits != b.fraction_bits || a.origin != b.origin) return false;
  return a.fraction_bits != 0 ? a.fixed.right == b.fixed.right && a.fixed.right_step == b.fixed.right_step
                              : same(a.large.right, b.large.right);
}

}  // namespace

std::int32_t hidden_until(const AwakePolygon& hidden, const AwakePolygon& front, std::int32_t row, std::int32_t width) {
  const AwakePolygon::Columns hidden_now = hidden.columns_below(0), front_now = front.columns_below(0);
  const bool left_alike = same_left(hidden, front), right_alike = same_right(hidden, front);
  // Where the front polygon reaches the edge of the picture, nothing beside it can be seen.
  const bool left_open = front_now.left <= 0, right_open = front_now.right >= width;
  const bool left_inside = hidden_now.left > front_now.left, right_inside = hidden_now.right < front_now.right;
  if (!(left_alike || left_open || left_inside) || !(right_alike || right_open || right_inside)) return 0;
  const std::int32_t turn = hidden.turn_row < front.turn_row ? hidden.turn_row : front.turn_row;
  for (std::int32_t rows = turn - 1 - row; rows >= least_rows; rows >>= 1) {
    const AwakePolygon::Columns below_hidden = hidden.columns_below(rows), below_front = front.columns_below(rows);
    const bool left_stays =
        left_alike || (left_open && below_front.left <= 0) || (left_inside && below_hidden.left > below_front.left);
    const bool right_stays = right_alike || (right_open && below_front.right >= width) ||
                             (right_inside && below_hidden.right < below_front.right);
    if (left_stays && right_stays) return row + rows + 1;
  }
  return 0;
}

bool fall_asleep(AwakePolygon& hidden, const AwakePolygon& front, PolygonTable& table, std::int32_t row,
                 std::int32_t width) {
  const std::int32_t until = hidden_until(hidden, front, row, width);
  if (until == 0) {
    hidden.retry_row = static_cast<std::uint16_t>(row + rows_until_retry);
    return false;
  }
  if (until < hidden.end_row) table.defer(until, hidden.number);
  hidden.end_row = hidden.turn_row = static_cast<std::uint16_t>(row + 1);
  return true;
}

}  // namespace spanline::polygon_sleep
