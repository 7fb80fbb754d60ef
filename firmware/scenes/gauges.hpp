#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "spanline/finish/canvas.hpp"
#include "spanline/finish/utf8_reader.hpp"
#include "spanline/math/trigonometry.hpp"
#include "spanline/raster/screen_vertex.hpp"

namespace spanline::scenes {

/// An instrument panel: two dials. Ticks and needles are flat triangles given on screen, made anew for each frame in
/// the caller's memory; names and numbers are text on top of the finished bands.
class Gauges {
 public:
  static constexpr std::size_t most_triangles = 48;
  static constexpr std::uint32_t frames_a_sweep = 60;  ///< from rest to the end of the scale and back
  static constexpr Rgb888 background{0, 0, 32};

  /// Frame `number` on a picture of `width` × `height` pixels, at least 160 × 120.
  void make(std::uint32_t number, std::int32_t width, std::int32_t height) {
    count_ = 0;
    const std::int32_t radius = std::min(width / 4, height / 2) - 6;
    dials_ = {{{width / 4, height / 2, radius, "rpm × 100", 70, sweep(number, 0)},
               {3 * width / 4, height / 2, radius, "km/h", 240, sweep(number, frames_a_sweep / 3)}}};
    for (const Dial& dial : dials_) draw(dial);
  }

  [[nodiscard]] std::span<const ScreenVertex> vertices() const { return std::span(vertices_).first(3 * count_); }
  [[nodiscard]] std::span<const std::uint16_t> colours() const { return std::span(colours_).first(count_); }

  /// Puts the text of a band on its canvas.
  template <class Format>
  void write(Canvas<Format>& canvas, const Font& font) const {
    for (const Dial& dial : dials_) {
      for (std::int32_t tick = 0; tick <= ticks; tick += major) {
        const Point at = polar(dial, angle_at(tick * 1000 / ticks), (dial.radius - 22) * 16, 0);
        centred(canvas, font, at.x >> 4, (at.y >> 4) + font.ascent / 2 - 2,
                Number(tick * dial.full_scale / ticks).text(), {255, 255, 255});
      }
      const std::int32_t below = dial.y + dial.radius * 3 / 10;
      centred(canvas, font, dial.x, below, dial.name, {128, 128, 128});
      centred(canvas, font, dial.x, below + font.line_height, Number(dial.thousandths * dial.full_scale / 1000).text(),
              {255, 165, 0});
    }
  }

 private:
  /// Sixteenths of a pixel.
  struct Point {
    std::int32_t x, y;
  };
  struct Dial {
    std::int32_t x, y, radius;  ///< pixels
    std::string_view name;
    std::int32_t full_scale;
    std::int32_t thousandths;  ///< of the scale, where the needle stands
  };

  static constexpr std::int32_t ticks = 10, major = 5, red_from = 8;
  static constexpr std::uint16_t white = 0xffff, red = 0xf920;
  static constexpr std::uint32_t z_needle = 10'000, z_scale = 30'000;

  /// Up to three digits.
  class Number {
   public:
    explicit Number(std::int32_t value) {
      do {
        digits_[--first_] = static_cast<char>('0' + value % 10);
        value /= 10;
      } while (value != 0 && first_ != 0);
    }
    [[nodiscard]] std::string_view text() const { return {digits_.data() + first_, digits_.size() - first_}; }

   private:
    std::array<char, 3> digits_{};
    std::size_t first_ = digits_.size();
  };

  template <class Format>
  static void centred(Canvas<Format>& canvas, const Font& font, std::int32_t x, std::int32_t baseline,
                      std::string_view text, Rgb888 colour) {
    canvas.text(x - text_width(font, text) / 2, baseline, text, font, colour);
  }

  /// Thousandths of the scale.
  static constexpr std::int32_t sweep(std::uint32_t number, std::uint32_t ahead) {
    const std::uint32_t phase = (number + ahead) % frames_a_sweep, half = frames_a_sweep / 2;
    return static_cast<std::int32_t>((phase < half ? phase : frames_a_sweep - phase) * 1000 / half);
  }

  /// Scales go from half past seven to half past four, clockwise.
  static constexpr Angle angle_at(std::int32_t thousandths) {
    return Angle::from_turns(-1500 + 3 * std::int64_t{thousandths}, 4000);
  }

  /// `distance` and `aside` in sixteenths of a pixel, along the hand and to its right.
  static Point polar(const Dial& dial, Angle angle, std::int32_t distance, std::int32_t aside) {
    const std::int64_t s = sine(angle).raw(), c = cosine(angle).raw();
    const auto round = [](std::int64_t value) { return static_cast<std::int32_t>((value + (1 << 29)) >> 30); };
    return {dial.x * 16 + round(s * distance + c * aside), dial.y * 16 - round(c * distance - s * aside)};
  }

  void triangle(Point a, Point b, Point c, std::uint16_t colour, std::uint32_t z) {
    const std::array corners{a, b, c};
    for (std::size_t i = 0; i < 3; ++i)
      vertices_[3 * count_ + i] = ScreenVertex::make(corners[i].x, corners[i].y, z, 16);
    colours_[count_++] = colour;
  }

  void draw(const Dial& dial) {
    for (std::int32_t tick = 0; tick <= ticks; ++tick) {
      const Angle angle = angle_at(tick * 1000 / ticks);
      const bool is_major = tick % major == 0;
      const std::int32_t outer = dial.radius * 16, inner = outer - (is_major ? 12 : 7) * 16, half = is_major ? 20 : 12;
      const std::uint16_t colour = tick >= red_from ? red : white;
      const Point a = polar(dial, angle, inner, -half), c = polar(dial, angle, outer, half);
      triangle(a, polar(dial, angle, outer, -half), c, colour, z_scale);
      triangle(a, c, polar(dial, angle, inner, half), colour, z_scale);
    }
    const Angle angle = angle_at(dial.thousandths);
    const std::int32_t length = (dial.radius - 10) * 16;
    triangle(polar(dial, angle, 0, -44), polar(dial, angle, length, 0), polar(dial, angle, 0, 44), red, z_needle);
    triangle(polar(dial, angle, 0, -44), polar(dial, angle, 0, 44), polar(dial, angle, -length / 5, 0), red, z_needle);
  }

  std::array<ScreenVertex, 3 * most_triangles> vertices_{};
  std::array<std::uint16_t, most_triangles> colours_{};
  std::array<Dial, 2> dials_{};
  std::size_t count_ = 0;
  static_assert(most_triangles == 2 * (2 * (ticks + 1) + 2));
};

}  // namespace spanline::scenes
