#include "panels/ili9341_model.hpp"

namespace spanline::sim {
namespace {

// The write commands of section 8.1. B6h has an optional fourth argument. Commands that read are not here: this model
// answers to one of them.
constexpr MipiFacts::Command commands[] = {
    {0x00, 0, 0},     {0x01, 0, 0}, {0x10, 0, 0},   {0x11, 0, 0},   {0x12, 0, 0}, {0x13, 0, 0}, {0x20, 0, 0},
    {0x21, 0, 0},     {0x26, 1, 1}, {0x28, 0, 0},   {0x29, 0, 0},   {0x2A, 4, 4}, {0x2B, 4, 4}, {0x2C, 0, 0},
    {0x2D, 128, 128}, {0x30, 4, 4}, {0x33, 6, 6},   {0x34, 0, 0},   {0x35, 1, 1}, {0x36, 1, 1}, {0x37, 2, 2},
    {0x38, 0, 0},     {0x39, 0, 0}, {0x3A, 1, 1},   {0x3C, 0, 0},   {0x44, 2, 2}, {0x51, 1, 1}, {0x53, 1, 1},
    {0x55, 1, 1},     {0x5E, 1, 1}, {0xB0, 1, 1},   {0xB1, 2, 2},   {0xB2, 2, 2}, {0xB3, 2, 2}, {0xB4, 1, 1},
    {0xB5, 4, 4},     {0xB6, 3, 4}, {0xB7, 1, 1},   {0xC0, 1, 1},   {0xC1, 1, 1}, {0xC5, 2, 2}, {0xC7, 1, 1},
    {0xCB, 5, 5},     {0xCF, 3, 3}, {0xE0, 15, 15}, {0xE1, 15, 15}, {0xE8, 3, 3}, {0xEA, 2, 2}, {0xED, 4, 4},
    {0xF2, 1, 1},     {0xF6, 3, 3}, {0xF7, 1, 1},
};

constexpr std::uint8_t pixel_formats[] = {5, 6};  // section 8.2.33
constexpr std::uint8_t identity[] = {0x00, 0x00, 0x93, 0x41};

constexpr MipiFacts facts{.commands = commands,
                          .clock = {.rated_hz = 10'000'000, .tolerated_hz = 40'000'000},
                          .columns = 240,
                          .rows = 320,
                          .glass_column = 0,
                          .glass_row = 0,
                          .glass_width = 240,
                          .glass_height = 320,
                          .wired_mirrored = true,
                          .filters_blue_first = true,
                          .shows_complement = false,
                          .pixel_formats = pixel_formats,
                          .identity_command = 0xD3,
                          .identity = identity};

}  // namespace

Ili9341Model::Ili9341Model(hal::Orientation held) : MipiModel(facts, held) {}

}  // namespace spanline::sim
