// A program of somebody else's: the cube of README.md, in a project that links spanline::core. Prints the CRC-32 of its
// picture, the same on every machine.
#include <cstddef>
#include <cstdint>
#include <spanline/hal/present.hpp>
#include <spanline/version.hpp>

#include "console.hpp"
#include "readme_example.hpp"

namespace {

/// CRC-32 as in PNG and zip, bit by bit.
std::uint32_t crc_with(std::uint32_t crc, std::uint8_t byte) {
  crc ^= byte;
  for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320u : 0);
  return crc;
}

void write_hexadecimal(std::uint32_t number) {
  char digits[9] = {};
  for (unsigned i = 0; i < 8; ++i) digits[i] = "0123456789abcdef"[(number >> (28 - 4 * i)) & 15];
  write(digits);
}

}  // namespace

int main() {
  std::uint32_t crc = 0xffffffff;
  Picture renderer(picture_size, picture_memory);
  const Status status = draw_cube(renderer, Angle::from_degrees(30), [&](const auto& band) {
    for (const auto pixel : band.pixels) {
      crc = crc_with(crc, static_cast<std::uint8_t>(pixel));  // the low byte first
      crc = crc_with(crc, static_cast<std::uint8_t>(pixel >> 8));
    }
    return true;
  });
  if (!status.ok()) return 1;
  write("spanline ");
  write(spanline::version);
  write(", the cube: ");
  write_hexadecimal(~crc);
  write("\n");
  return 0;
}
