#include <array>

#include "board.hpp"

namespace spanline::board {

void write_unsigned(std::uint32_t value) {
  std::array<char, 11> text{};
  char* first = text.data() + text.size() - 1;
  do {
    *--first = static_cast<char>('0' + value % 10);
    value /= 10;
  } while (value != 0);
  write(first);
}

void write_hex(std::uint32_t value) {
  std::array<char, 9> text{};
  for (unsigned digit = 0; digit < 8; ++digit) text[digit] = "0123456789abcdef"[(value >> (28 - 4 * digit)) & 15U];
  write(text.data());
}

}  // namespace spanline::board
