#pragma once
#include <cstdint>

#include "spanline/hal/filler.hpp"

namespace spanline::board {

/// Fills memory by DMA channels 1 and 2, a word of four bytes a cycle (RP2040 data sheet, section 2.5). SpiBus owns the
/// DMA block: where that starts it anew, fills under way end there.
class BandFiller {
 public:
  void fill(std::uint16_t value, std::uint32_t count, std::uint16_t* words);
  bool filled();

 private:
  std::uint32_t values_[2] = {};  ///< what the channels read
  unsigned next_ = 0;             ///< channel of the next fill, counted from channel 1
};
static_assert(hal::Filler<BandFiller>);

}  // namespace spanline::board
