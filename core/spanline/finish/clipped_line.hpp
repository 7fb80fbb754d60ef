#pragma once
#include <cstdint>

namespace spanline {

/// The part of the picture that a line is clipped to: columns [left, right), rows [top, bottom), pixels.
struct ClipBox {
  std::int32_t left, top, right, bottom;
};

/// The pixels of a line from its first end to its second, clipped to a box: one pixel a step along the longer axis, on
/// the shorter axis the nearest pixel, halves towards greater coordinates.
///
/// Outcodes (Cohen and Sutherland; lecture 001) reject lines that lie outside one side of the box. For any other line a
/// range of steps is kept that holds every pixel inside the box and at most a few outside. A pixel's position depends
/// on the unclipped line alone, so a line drawn band by band equals the line drawn at once. |coordinate| ≤ 16,383.
class ClippedLine {
 public:
  ClippedLine(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1, const ClipBox& box);

  [[nodiscard]] bool at_end() const { return step_ > last_; }
  [[nodiscard]] std::int32_t x() const { return steep_ ? minor_ : major_; }
  [[nodiscard]] std::int32_t y() const { return steep_ ? major_ : minor_; }
  void next() {
    ++step_;
    major_ += direction_;
    remainder_ += slope_remainder_;
    minor_ += slope_;
    if (remainder_ >= divisor_) {
      remainder_ -= divisor_;
      ++minor_;
    }
  }

 private:
  std::int32_t step_ = 1, last_ = 0;
  bool steep_ = false;
  std::int32_t major_ = 0, minor_ = 0, direction_ = 1;
  std::int32_t slope_ = 0,
               slope_remainder_ = 0;  ///< shorter axis, a step: whole pixels, rest in 1/divisor_
  std::int32_t remainder_ = 0, divisor_ = 1;
};

}  // namespace spanline
