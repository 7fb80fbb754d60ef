#pragma once
#include <cstddef>
#include <cstdint>

#include "spanline/pixel/spread_565.hpp"

namespace spanline {

/// Several samples a pixel, averaged: a band that is drawn twice or four times as wide and high becomes 4 or 16 samples
/// a pixel. Materials of Transparency::stochastic then come near to blending without any order (Enderton, Sintorn,
/// Shirley, Luebke 2010, "Stochastic Transparency"), and edges of all polygons are smoothed.
///
/// Sums of samples are spread words (spread_565): each channel has room for 16.

/// The sum of the factor × factor samples of pixel `column` of a line; `samples` is the first of the line's sample
/// lines, which lie `stride` samples apart.
template <class Format>
[[nodiscard]] inline std::uint32_t sample_sum(const typename Format::Pixel* samples, std::size_t stride,
                                              std::size_t column, unsigned factor) {
  std::uint32_t sum = 0;
  for (unsigned y = 0; y < factor; ++y)
    for (unsigned x = 0; x < factor; ++x)
      sum += spread_565::from(Format::from_rgb565(samples[y * stride + column * factor + x]));  // its own inverse
  return sum;
}

/// The mean of 4, 8 or 16 samples (as a power of two), channels rounded to nearest, halves up; RGB565.
[[nodiscard]] constexpr std::uint16_t sample_mean(std::uint32_t sum, unsigned log2_samples) {
  const std::uint32_t half = 0x00200801u << (log2_samples - 1);
  return static_cast<std::uint16_t>(spread_565::joined(((sum + half) >> log2_samples) & spread_565::mask));
}

/// Averages a finished band in place: `width` × `lines` pixels at its beginning, of factor² samples each; factor is 2
/// or 4. The band's samples are factor · width wide and factor · lines high.
template <class Format>
void average_samples(typename Format::Pixel* band, std::size_t width, std::size_t lines, unsigned factor) {
  const unsigned log2_samples = factor == 2 ? 2 : 4;
  const std::size_t stride = width * factor;
  typename Format::Pixel* out = band;
  // A line of pixels ends before the samples of the next begin.
  for (std::size_t line = 0; line < lines; ++line) {
    const typename Format::Pixel* samples = band + line * factor * stride;
    for (std::size_t column = 0; column < width; ++column)
      *out++ = Format::from_rgb565(sample_mean(sample_sum<Format>(samples, stride, column, factor), log2_samples));
  }
}

}  // namespace spanline
