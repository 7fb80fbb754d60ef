#include "image/solid_image.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "base/failure.hpp"
#include "spanline/pixel/pixel_format.hpp"

namespace spanline::sim {
namespace {

constexpr int log2_size = 7, size = 1 << log2_size;
constexpr double full_turn = 2 * std::numbers::pi;

/// 256 colours from one to the other.
std::vector<std::uint16_t> blend(Rgb888 from, Rgb888 to) {
  std::vector<std::uint16_t> palette;
  for (int i = 0; i < 256; ++i) {
    const auto mix = [i](int a, int b) { return static_cast<std::uint8_t>(a + (b - a) * i / 255); };
    palette.push_back(Rgb565::from({mix(from.red, to.red), mix(from.green, to.green), mix(from.blue, to.blue)}));
  }
  return palette;
}

/// A smooth function of the point that repeats with the cube.
double ripple(double x, double y, double z) {
  return std::sin(full_turn * (x + 0.3 * std::sin(full_turn * y))) + 0.5 * std::sin(full_turn * (2 * y + z)) +
         0.25 * std::sin(full_turn * (3 * z + 2 * x));
}

double wood(double x, double y, double z) {
  const double from_axis = std::hypot(x - 0.5, z - 0.5) + 0.012 * ripple(x, y, z);
  const double ring = from_axis * 14;
  return std::pow(ring - std::floor(ring), 2);
}

double marble(double x, double y, double z) {
  return std::pow(std::abs(std::sin(full_turn * (y + x) + 1.3 * ripple(x, y, z))), 0.5);
}

double checks(double x, double y, double z) {
  const auto field = [](double c) { return static_cast<int>(c * 8); };
  return (field(x) + field(y) + field(z)) % 2;
}

struct Recipe {
  const char* name;
  double (*value)(double x, double y, double z);
  Rgb888 low, high;
};
constexpr std::array<Recipe, 3> recipes{{{"wood", wood, {214, 160, 96}, {120, 68, 28}},
                                         {"marble", marble, {70, 80, 100}, {245, 242, 235}},
                                         {"checks", checks, {200, 40, 40}, {245, 240, 230}}}};

}  // namespace

VolumeTexture SolidImage::view() const {
  VolumeTexture texture;
  texture.log2_size = static_cast<std::uint8_t>(log2_size);
  texture.cells = cells;
  texture.palette = palette;
  return texture;
}

SolidImage make_solid(const std::string& name) {
  std::string names;
  for (const Recipe& recipe : recipes) {
    names += (names.empty() ? "" : ", ") + std::string(recipe.name);
    if (name != recipe.name) continue;
    SolidImage solid{log2_size, {}, blend(recipe.low, recipe.high)};
    const auto middle = [](int cell) { return (cell + 0.5) / size; };
    for (int z = 0; z < size; ++z)
      for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
          solid.cells.push_back(
              static_cast<std::uint8_t>(std::lround(255 * recipe.value(middle(x), middle(y), middle(z)))));
    return solid;
  }
  throw UsageError("--solid: '" + name + "' is none of " + names);
}

}  // namespace spanline::sim
