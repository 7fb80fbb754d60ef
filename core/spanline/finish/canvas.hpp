#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <string_view>

#include "spanline/finish/clipped_line.hpp"
#include "spanline/finish/utf8_reader.hpp"
#include "spanline/model/font.hpp"
#include "spanline/model/texel_reader.hpp"
#include "spanline/model/texture.hpp"
#include "spanline/pixel/pixel_format.hpp"
#include "spanline/pixel/spread_565.hpp"

namespace spanline {

/// Draws in two dimensions on top of a finished band: rectangles, lines, sprites and text. Coordinates are pixels of
/// the whole picture, |coordinate| ≤ 16,383. Everything is clipped to the band, so the same calls made for every band
/// draw the same picture, whatever the height of a band.
template <class Format>
class Canvas {
 public:
  using Pixel = typename Format::Pixel;

  /// A band of lines [y0, y1) of a picture `width` pixels wide.
  Canvas(std::span<Pixel> pixels, std::int32_t width, std::int32_t y0, std::int32_t y1)
      : pixels_(pixels.data()), width_(width), y0_(y0), y1_(y1) {}

  void fill(std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height, Rgb888 colour) {
    const Pixel pixel = Format::from(colour);
    const std::int32_t left = std::max<std::int32_t>(x, 0), right = std::min(x + width, width_);
    if (left >= right) return;
    const std::int32_t bottom = std::min(y + height, y1_);
    for (std::int32_t row = std::max(y, y0_); row < bottom; ++row) std::fill(at(left, row), at(right, row), pixel);
  }
  /// Draws the border of a rectangle, one pixel wide.
  void frame(std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height, Rgb888 colour) {
    fill(x, y, width, 1, colour);
    fill(x, y + height - 1, width, 1, colour);
    fill(x, y + 1, 1, height - 2, colour);
    fill(x + width - 1, y + 1, 1, height - 2, colour);
  }

  /// Draws a line from one pixel to another, both included: one pixel a step along the longer axis, the nearest pixel
  /// on the shorter.
  void line(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1, Rgb888 colour) {
    const Pixel pixel = Format::from(colour);
    ClippedLine steps(x0, y0, x1, y1, {0, y0_, width_, y1_});
    for (; !steps.at_end(); steps.next())
      if (inside(steps.x(), steps.y())) *at(steps.x(), steps.y()) = pixel;
  }

  /// Draws level 0 of a texture unscaled, its top left texel at (x, y). Each texel is blended by its alpha over the
  /// pixel below.
  void sprite(std::int32_t x, std::int32_t y, const Texture& texture) {
    const std::int32_t width = 1 << texture.log2_width, height = 1 << texture.log2_height;
    const std::int32_t left = std::max<std::int32_t>(x, 0), right = std::min(x + width, width_);
    const std::int32_t bottom = std::min(y + height, y1_);
    for (std::int32_t row = std::max(y, y0_); row < bottom; ++row)
      for (std::int32_t column = left; column < right; ++column) {
        const Texel texel =
            read_texel(texture, static_cast<std::uint32_t>(column - x), static_cast<std::uint32_t>(row - y));
        cover(*at(column, row), texel.rgb565, texel.alpha);
      }
  }

  /// Draws a line of UTF-8 text whose pen starts at (x, baseline). Returns the x at which the pen ends.
  std::int32_t text(std::int32_t x, std::int32_t baseline, std::string_view text, const Font& font, Rgb888 colour) {
    const std::uint16_t ink = Rgb565::from(colour);
    const bool touches = baseline - font.ascent < y1_ && baseline + font.descent >= y0_;
    for (Utf8Reader reader(text); !reader.at_end();) {
      const Glyph& glyph = font.glyph(reader.next());
      if (touches) draw(glyph, x + glyph.left, baseline - glyph.top, font, ink);
      x += glyph.advance;
    }
    return x;
  }

 private:
  [[nodiscard]] Pixel* at(std::int32_t x, std::int32_t y) { return pixels_ + (y - y0_) * width_ + x; }
  [[nodiscard]] bool inside(std::int32_t x, std::int32_t y) const {
    return x >= 0 && x < width_ && y >= y0_ && y < y1_;
  }

  /// Blends a colour over a pixel with opacity `alpha`/15.
  static void cover(Pixel& pixel, std::uint16_t rgb565, unsigned alpha) {
    if (alpha == 0) return;
    if (alpha == 15) {
      pixel = Format::from_rgb565(rgb565);
      return;
    }
    const std::uint32_t level = (alpha * 35) >> 4;                             // fifteenths to 32nds, rounded
    const std::uint32_t below = spread_565::from(Format::from_rgb565(pixel));  // from_rgb565 is its own inverse
    pixel = Format::from_rgb565(
        static_cast<std::uint16_t>(spread_565::joined(spread_565::mixed(below, spread_565::from(rgb565), level))));
  }

  void draw(const Glyph& glyph, std::int32_t x, std::int32_t y, const Font& font, std::uint16_t ink) {
    const std::int32_t bottom = std::min(y + glyph.height, y1_);
    for (std::int32_t row = std::max(y, y0_); row < bottom; ++row)
      for (std::int32_t column = 0; column < glyph.width; ++column) {
        if (x + column < 0 || x + column >= width_) continue;
        const auto index = static_cast<std::uint32_t>(glyph.first + (row - y) * glyph.width + column);
        cover(*at(x + column, row), ink, font.coverage_at(index));
      }
  }

  Pixel* pixels_;
  std::int32_t width_, y0_, y1_;
};

}  // namespace spanline
