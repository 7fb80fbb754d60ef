#pragma once
#include "panels/mipi_model.hpp"

namespace spanline::sim {

/// An ILI9341 with its 240 × 320 glass (ILI9341 datasheet, chapter 8).
class Ili9341Model : public MipiModel {
 public:
  /// `held`: how the viewer holds the panel; picture() is turned to match.
  explicit Ili9341Model(hal::Orientation held);
};

}  // namespace spanline::sim
