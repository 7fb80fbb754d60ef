#pragma once
/// @file
/// How fast a panel may be written to.
///
/// ```cpp
/// constexpr hal::ClockRating ili9341{.rated_hz = 10'000'000, .tolerated_hz = 40'000'000};
/// static_assert(ili9341.verdict(31'250'000) == hal::ClockVerdict::above_rating);
/// ```
#include <cstdint>

namespace spanline::hal {

/// How a bus clock compares with a panel's rating.
enum class ClockVerdict : std::uint8_t {
  rated,         ///< within the datasheet's limit
  above_rating,  ///< above the datasheet's limit, but known to work on common modules
  too_high,      ///< refused
};

/// The highest serial write clocks of a panel, in hertz; rated_hz <= tolerated_hz. A board that knows its clock at
/// compile time can check it there: `static_assert(Panel::clock_rating.verdict(hz) != ClockVerdict::too_high)`.
struct ClockRating {
  std::uint32_t rated_hz;      ///< the datasheet's highest write clock
  std::uint32_t tolerated_hz;  ///< the highest clock that a driver accepts

  /// How a bus clock of `clock_hz` hertz stands to the rating.
  [[nodiscard]] constexpr ClockVerdict verdict(std::uint32_t clock_hz) const {
    if (clock_hz <= rated_hz) return ClockVerdict::rated;
    return clock_hz <= tolerated_hz ? ClockVerdict::above_rating : ClockVerdict::too_high;
  }
};

}  // namespace spanline::hal
