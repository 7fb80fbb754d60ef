#pragma once
#include <cstddef>
#include <vector>

#include "spanline/model/colour.hpp"

namespace spanline::sim {

/// A picture of 8-bit RGB pixels, row-major, top row first.
struct Picture {
  int width = 0, height = 0;
  std::vector<Rgb888> pixels;

  Picture() = default;
  Picture(int w, int h, Rgb888 fill = {0, 0, 0})
      : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill) {}
  [[nodiscard]] Rgb888& at(int x, int y) { return pixels[index(x, y)]; }
  [[nodiscard]] const Rgb888& at(int x, int y) const { return pixels[index(x, y)]; }
  friend bool operator==(const Picture&, const Picture&) = default;

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

/// A 24-bit number as a pixel, R<<16 | G<<8 | B: depth and id pictures.
[[nodiscard]] constexpr Rgb888 number_pixel(std::uint32_t value) {
  return {static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 8),
          static_cast<std::uint8_t>(value)};
}

}  // namespace spanline::sim
