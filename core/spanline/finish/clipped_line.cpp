#include "spanline/finish/clipped_line.hpp"

#include <algorithm>
#include <utility>

namespace spanline {
namespace {

/// The outcode of a point (Cohen and Sutherland): a bit for each side of the box that the point lies beyond.
unsigned outcode(std::int32_t x, std::int32_t y, const ClipBox& box) {
  return (x < box.left ? 1u : 0u) | (x >= box.right ? 2u : 0u) | (y < box.top ? 4u : 0u) | (y >= box.bottom ? 8u : 0u);
}

std::int32_t floor_quotient(std::int32_t dividend, std::int32_t divisor) {
  const std::int32_t quotient = dividend / divisor;
  return dividend % divisor < 0 ? quotient - 1 : quotient;
}

}  // namespace

ClippedLine::ClippedLine(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1, const ClipBox& box) {
  if ((outcode(x0, y0, box) & outcode(x1, y1, box)) != 0) return;
  std::int32_t along = x1 - x0, across = y1 - y0;
  std::int32_t major_low = box.left, major_high = box.right, minor_low = box.top, minor_high = box.bottom;
  major_ = x0;
  minor_ = y0;
  steep_ = (across < 0 ? -across : across) > (along < 0 ? -along : along);
  if (steep_) {
    std::swap(along, across);
    std::swap(major_, minor_);
    std::swap(major_low, minor_low);
    std::swap(major_high, minor_high);
  }
  direction_ = along < 0 ? -1 : 1;
  const std::int32_t length = along * direction_;
  // The range of steps whose pixels lie inside the box: exact on the longer axis, with one step to spare on the
  // shorter.
  std::int32_t first = direction_ > 0 ? major_low - major_ : major_ - (major_high - 1);
  std::int32_t last = direction_ > 0 ? major_high - 1 - major_ : major_ - major_low;
  if (across != 0) {
    const std::int32_t sign = across < 0 ? -1 : 1, size = across * sign;
    const std::int32_t near = sign > 0 ? minor_low - minor_ : minor_ - (minor_high - 1);
    const std::int32_t far = sign > 0 ? minor_high - 1 - minor_ : minor_ - minor_low;
    // |near|, |far| ≤ 2^15 and length < 2^15: the products fit.
    first = std::max(first, floor_quotient((near - 1) * length, size));
    last = std::min(last, floor_quotient((far + 1) * length, size) + 1);
  }
  step_ = std::max<std::int32_t>(first, 0);
  last_ = std::min(last, length);
  if (at_end() || length == 0) {
    divisor_ = 1;
    last_ = length == 0 ? 0 : last_;
    return;
  }
  // Position on the shorter axis at step i: start + floor((2·i·across + length) / (2·length)).
  divisor_ = 2 * length;
  slope_ = floor_quotient(2 * across, divisor_);
  slope_remainder_ = 2 * across - slope_ * divisor_;
  const std::int64_t offset = std::int64_t{2} * step_ * across + length;
  std::int64_t whole = offset / divisor_;
  if (offset % divisor_ < 0) --whole;
  minor_ += static_cast<std::int32_t>(whole);
  remainder_ = static_cast<std::int32_t>(offset - whole * divisor_);
  major_ += direction_ * step_;
}

}  // namespace spanline
