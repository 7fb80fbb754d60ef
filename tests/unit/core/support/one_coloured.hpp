#pragma once
#include <array>
#include <cstdint>

#include "spanline/model/volume.hpp"

namespace spanline::test {

/// A solid of one colour.
class OneColouredSolid {
 public:
  explicit OneColouredSolid(std::uint16_t rgb565) { palette_[0] = rgb565; }
  OneColouredSolid(const OneColouredSolid&) = delete;
  OneColouredSolid& operator=(const OneColouredSolid&) = delete;
  [[nodiscard]] std::uint16_t colour() const { return palette_[0]; }
  [[nodiscard]] Volume volume() const { return {.source = SolidSource::table, .texture = &texture_}; }

 private:
  std::array<std::uint8_t, 1> cells_{};
  std::array<std::uint16_t, 256> palette_{};
  VolumeTexture texture_{0, cells_, palette_};
};

}  // namespace spanline::test
