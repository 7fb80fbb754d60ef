#include "panels/st7789_model.hpp"

namespace spanline::sim {
namespace {

// The write commands of sections 9.1 and 9.2.
constexpr MipiFacts::Command commands[] = {
    {0x00, 0, 0}, {0x01, 0, 0}, {0x10, 0, 0}, {0x11, 0, 0},   {0x12, 0, 0},   {0x13, 0, 0},   {0x20, 0, 0},
    {0x21, 0, 0}, {0x26, 1, 1}, {0x28, 0, 0}, {0x29, 0, 0},   {0x2A, 4, 4},   {0x2B, 4, 4},   {0x2C, 0, 0},
    {0x30, 4, 4}, {0x33, 6, 6}, {0x34, 0, 0}, {0x35, 1, 1},   {0x36, 1, 1},   {0x37, 2, 2},   {0x38, 0, 0},
    {0x39, 0, 0}, {0x3A, 1, 1}, {0x3C, 0, 0}, {0x44, 2, 2},   {0x51, 1, 1},   {0x53, 1, 1},   {0x55, 1, 1},
    {0x5E, 1, 1}, {0xB0, 2, 2}, {0xB1, 3, 3}, {0xB2, 5, 5},   {0xB3, 3, 3},   {0xB5, 1, 1},   {0xB7, 1, 1},
    {0xB8, 4, 4}, {0xBA, 1, 1}, {0xBB, 1, 1}, {0xBC, 1, 1},   {0xBD, 1, 1},   {0xC0, 1, 1},   {0xC1, 3, 3},
    {0xC2, 2, 2}, {0xC3, 1, 1}, {0xC4, 1, 1}, {0xC5, 1, 1},   {0xC6, 1, 1},   {0xC7, 1, 1},   {0xCC, 1, 1},
    {0xD0, 2, 2}, {0xD2, 1, 1}, {0xDF, 4, 4}, {0xE0, 14, 14}, {0xE1, 14, 14}, {0xE2, 64, 64}, {0xE3, 64, 64},
    {0xE4, 3, 3}, {0xE7, 1, 1}, {0xE8, 1, 1}, {0xE9, 3, 3},   {0xEC, 1, 1},   {0xFA, 4, 4},   {0xFC, 2, 2},
    {0xFE, 2, 2},
};

constexpr std::uint8_t pixel_formats[] = {3, 5, 6};  // section 9.1.32
constexpr std::uint8_t identity[] = {0x00, 0x85, 0x85, 0x52};

constexpr MipiFacts facts_of(int column, int row, int width, int height) {
  return {.commands = commands,
          .clock = {.rated_hz = 62'500'000, .tolerated_hz = 80'000'000},
          .columns = 240,
          .rows = 320,
          .glass_column = column,
          .glass_row = row,
          .glass_width = width,
          .glass_height = height,
          .wired_mirrored = false,
          .filters_blue_first = false,
          .shows_complement = true,
          .pixel_formats = pixel_formats,
          .identity_command = 0x04,
          .identity = identity};
}

// In the order of St7789Glass. How the makers of the modules wire them: the square glass at the memory's start, the
// narrow one in its middle.
constexpr MipiFacts facts[] = {facts_of(0, 0, 240, 320), facts_of(0, 0, 240, 240), facts_of(52, 40, 135, 240)};

}  // namespace

St7789Model::St7789Model(St7789Glass glass, hal::Orientation held)
    : MipiModel(facts[static_cast<unsigned>(glass)], held) {}

}  // namespace spanline::sim
