#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/math/trigonometry.hpp"
#include "spanline/raster/screen_vertex.hpp"

namespace spanline::scenes {

/// An instrument panel: two dials with ticks, needles, numbers and names, as flat triangles given on screen. Made anew
/// for each frame, in the caller's memory.
class Gauges {
 public:
  static constexpr std::size_t most_triangles = 640;
  static constexpr std::uint32_t frames_a_sweep = 60;  ///< from rest to the end of the scale and back

  /// Frame `number` on a picture of `width` × `height` pixels, at least 160 × 120.
  void make(std::uint32_t number, std::int32_t width, std::int32_t height) {
    count_ = 0;
    const std::int32_t radius = std::min(width / 4, height / 2) - 6;
    dial({width / 4, height / 2, radius}, "RPM", sweep(number, 0), 70);
    dial({3 * width / 4, height / 2, radius}, "KMH", sweep(number, frames_a_sweep / 3), 240);
  }

  [[nodiscard]] std::span<const ScreenVertex> vertices() const { return std::span(vertices_).first(3 * count_); }
  [[nodiscard]] std::span<const std::uint16_t> colours() const { return std::span(colours_).first(count_); }
  /// Whether a triangle found no room.
  [[nodiscard]] bool full() const { return count_ == most_triangles; }

 private:
  /// Sixteenths of a pixel.
  struct Point {
    std::int32_t x, y;
  };
  /// Pixels.
  struct Dial {
    std::int32_t x, y, radius;
  };

  static constexpr std::uint16_t white = 0xffff, red = 0xf920, grey = 0x8410, amber = 0xfd20;
  static constexpr std::uint32_t z_needle = 10'000, z_text = 20'000, z_scale = 30'000;

  /// Thousandths of the scale.
  static constexpr std::int32_t sweep(std::uint32_t number, std::uint32_t ahead) {
    const std::uint32_t phase = (number + ahead) % frames_a_sweep, half = frames_a_sweep / 2;
    return static_cast<std::int32_t>((phase < half ? phase : frames_a_sweep - phase) * 1000 / half);
  }

  /// Scales go from half past seven to half past four, clockwise.
  static constexpr Angle at(std::int32_t thousandths) {
    return Angle::from_turns(-1500 + 3 * std::int64_t{thousandths}, 4000);
  }

  /// `distance` and `aside` in sixteenths of a pixel, along the hand and to its right.
  static Point polar(const Dial& dial, Angle angle, std::int32_t distance, std::int32_t aside) {
    const std::int64_t s = sine(angle).raw(), c = cosine(angle).raw();
    const auto round = [](std::int64_t value) { return static_cast<std::int32_t>((value + (1 << 29)) >> 30); };
    return {dial.x * 16 + round(s * distance + c * aside), dial.y * 16 - round(c * distance - s * aside)};
  }

  void triangle(Point a, Point b, Point c, std::uint16_t colour, std::uint32_t z) {
    if (full()) return;
    const std::array corners{a, b, c};
    for (std::size_t i = 0; i < 3; ++i)
      vertices_[3 * count_ + i] = ScreenVertex::make(corners[i].x, corners[i].y, z, 16);
    colours_[count_++] = colour;
  }
  void quad(Point a, Point b, Point c, Point d, std::uint16_t colour, std::uint32_t z) {
    triangle(a, b, c, colour, z);
    triangle(a, c, d, colour, z);
  }

  void dial(const Dial& dial, const char* name, std::int32_t thousandths, std::int32_t full_scale) {
    for (std::int32_t tick = 0; tick <= 10; ++tick) {
      const Angle angle = at(tick * 100);
      const std::int32_t outer = dial.radius * 16, inner = outer - (tick % 5 == 0 ? 12 : 7) * 16,
                         half = tick % 5 == 0 ? 20 : 12;
      quad(polar(dial, angle, inner, -half), polar(dial, angle, outer, -half), polar(dial, angle, outer, half),
           polar(dial, angle, inner, half), tick >= 8 ? red : white, z_scale);
    }
    const Angle angle = at(thousandths);
    const std::int32_t length = (dial.radius - 10) * 16;
    triangle(polar(dial, angle, 0, -44), polar(dial, angle, length, 0), polar(dial, angle, 0, 44), red, z_needle);
    triangle(polar(dial, angle, 0, -44), polar(dial, angle, 0, 44), polar(dial, angle, -length / 5, 0), red, z_needle);
    text({dial.x - 15, dial.y + dial.radius / 3}, name, 2, grey);
    std::array<char, 4> digits{};
    const std::int32_t value = thousandths * full_scale / 1000;
    digits[0] = static_cast<char>('0' + value / 100);
    digits[1] = static_cast<char>('0' + value / 10 % 10);
    digits[2] = static_cast<char>('0' + value % 10);
    text({dial.x - 23, dial.y + dial.radius / 3 + 18}, digits.data(), 3, amber);
  }

  /// Rows of five pixels, the left one highest, of the letters that there are.
  struct Glyph {
    char letter;
    std::array<std::uint8_t, 7> rows;
  };
  static constexpr Glyph glyphs[] = {
      {'0', {0x0e, 0x11, 0x13, 0x15, 0x19, 0x11, 0x0e}}, {'1', {0x04, 0x0c, 0x04, 0x04, 0x04, 0x04, 0x0e}},
      {'2', {0x0e, 0x11, 0x01, 0x02, 0x04, 0x08, 0x1f}}, {'3', {0x1f, 0x02, 0x04, 0x02, 0x01, 0x11, 0x0e}},
      {'4', {0x02, 0x06, 0x0a, 0x12, 0x1f, 0x02, 0x02}}, {'5', {0x1f, 0x10, 0x1e, 0x01, 0x01, 0x11, 0x0e}},
      {'6', {0x06, 0x08, 0x10, 0x1e, 0x11, 0x11, 0x0e}}, {'7', {0x1f, 0x01, 0x02, 0x04, 0x08, 0x08, 0x08}},
      {'8', {0x0e, 0x11, 0x11, 0x0e, 0x11, 0x11, 0x0e}}, {'9', {0x0e, 0x11, 0x11, 0x0f, 0x01, 0x02, 0x0c}},
      {'H', {0x11, 0x11, 0x11, 0x1f, 0x11, 0x11, 0x11}}, {'K', {0x11, 0x12, 0x14, 0x18, 0x14, 0x12, 0x11}},
      {'M', {0x11, 0x1b, 0x15, 0x15, 0x11, 0x11, 0x11}}, {'P', {0x1e, 0x11, 0x11, 0x1e, 0x10, 0x10, 0x10}},
      {'R', {0x1e, 0x11, 0x11, 0x1e, 0x14, 0x12, 0x11}},
  };

  /// `from` is the top left in pixels; each of a glyph's pixels is a square of `scale` pixels, runs of them one quad.
  void text(Point from, const char* letters, std::int32_t scale, std::uint16_t colour) {
    for (; *letters != '\0'; ++letters, from.x += 6 * scale - scale / 3) {
      const auto* glyph =
          std::find_if(std::begin(glyphs), std::end(glyphs), [&](const Glyph& g) { return g.letter == *letters; });
      if (glyph == std::end(glyphs)) continue;
      for (std::int32_t row = 0; row < 7; ++row)
        this->row(from, glyph->rows[static_cast<std::size_t>(row)], row, scale, colour);
    }
  }
  void row(Point from, std::uint32_t bits, std::int32_t number, std::int32_t scale, std::uint16_t colour) {
    for (std::int32_t left = 0; left < 5; ++left) {
      std::int32_t right = left;
      while (right < 5 && (bits >> (4 - right) & 1) != 0) ++right;
      if (right == left) continue;
      const std::int32_t x0 = (from.x + left * scale) * 16, x1 = (from.x + right * scale) * 16;
      const std::int32_t y0 = (from.y + number * scale) * 16, y1 = y0 + scale * 16;
      quad({x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}, colour, z_text);
      left = right;
    }
  }

  std::array<ScreenVertex, 3 * most_triangles> vertices_{};
  std::array<std::uint16_t, most_triangles> colours_{};
  std::size_t count_ = 0;
};

}  // namespace spanline::scenes
