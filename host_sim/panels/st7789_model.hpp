#pragma once
#include "panels/mipi_model.hpp"

namespace spanline::sim {

/// The glasses that come with an ST7789, by their size in portrait.
enum class St7789Glass : std::uint8_t { size_240x320, size_240x240, size_135x240 };

/// An ST7789 with one of its IPS glasses (ST7789V datasheet, chapter 9).
class St7789Model : public MipiModel {
 public:
  /// `held`: how the viewer holds the panel; picture() is turned to match.
  St7789Model(St7789Glass glass, hal::Orientation held);
};

}  // namespace spanline::sim
