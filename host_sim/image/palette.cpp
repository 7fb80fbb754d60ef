#include "image/palette.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

namespace spanline::sim {
namespace {

struct Counted {
  std::array<std::uint8_t, 3> channels;
  std::size_t pixels;
};

/// Colours [first, end) of a table.
struct Box {
  std::size_t first, end;
  std::size_t channel = 0;   ///< the widest
  std::uint64_t weight = 0;  ///< its width times the pixels; 0 where nothing can be cut

  Box(const std::vector<Counted>& table, std::size_t begin_at, std::size_t end_at) : first(begin_at), end(end_at) {
    std::uint64_t pixels = 0, widest = 0;
    for (std::size_t i = first; i < end; ++i) pixels += table[i].pixels;
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint8_t low = 255, high = 0;
      for (std::size_t i = first; i < end; ++i) {
        low = std::min(low, table[i].channels[c]);
        high = std::max(high, table[i].channels[c]);
      }
      if (high >= low && static_cast<std::uint64_t>(high - low) > widest) {
        widest = static_cast<std::uint64_t>(high - low);
        channel = c;
      }
    }
    weight = widest * pixels;
  }
};

Box cut(std::vector<Counted>& table, Box& box) {
  const auto begin = table.begin() + static_cast<std::ptrdiff_t>(box.first),
             end = table.begin() + static_cast<std::ptrdiff_t>(box.end);
  std::stable_sort(begin, end, [&](const Counted& a, const Counted& b) {
    return a.channels[box.channel] < b.channels[box.channel];
  });
  std::size_t pixels = 0, before = 0, middle = box.first;
  for (auto i = begin; i != end; ++i) pixels += i->pixels;
  while (middle + 1 < box.end && (middle == box.first || before + table[middle].pixels <= pixels / 2))
    before += table[middle++].pixels;
  const Box upper(table, middle, box.end);
  box = Box(table, box.first, middle);
  return upper;
}

Rgb888 mean(const std::vector<Counted>& table, const Box& box) {
  std::array<std::size_t, 3> sum{};
  std::size_t pixels = 0;
  for (std::size_t i = box.first; i < box.end; ++i) {
    pixels += table[i].pixels;
    for (std::size_t c = 0; c < 3; ++c) sum[c] += table[i].channels[c] * table[i].pixels;
  }
  const auto channel = [&](std::size_t c) { return static_cast<std::uint8_t>((sum[c] + pixels / 2) / pixels); };
  return {channel(0), channel(1), channel(2)};
}

}  // namespace

Palette Palette::of(const ImageRgba& image, std::size_t count) {
  std::map<std::array<std::uint8_t, 3>, std::size_t> counts;
  for (const Rgba8888& pixel : image.pixels) ++counts[{pixel.colour.red, pixel.colour.green, pixel.colour.blue}];
  std::vector<Counted> table;
  for (const auto& [channels, pixels] : counts) table.push_back({channels, pixels});
  std::vector<Box> boxes{Box(table, 0, table.size())};
  while (boxes.size() < count) {
    const auto widest =
        std::max_element(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.weight < b.weight; });
    if (widest->weight == 0) break;
    boxes.push_back(cut(table, *widest));
  }
  Palette palette;
  for (const Box& box : boxes) palette.colours_.push_back(mean(table, box));
  palette.colours_.resize(count, {0, 0, 0});
  return palette;
}

std::size_t Palette::nearest(Rgb888 colour) const {
  std::size_t best = 0;
  int least = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < colours_.size(); ++i) {
    const auto square = [](int a, int b) { return (a - b) * (a - b); };
    const int distance = square(colour.red, colours_[i].red) + square(colour.green, colours_[i].green) +
                         square(colour.blue, colours_[i].blue);
    if (distance < least) {
      least = distance;
      best = i;
    }
  }
  return best;
}

}  // namespace spanline::sim
