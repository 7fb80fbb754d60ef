#include "start.hpp"

#include <algorithm>

#include "board.hpp"
#include "linker.hpp"

int main();

extern "C" [[gnu::weak]] void board_set_up() {}

namespace {

constexpr std::uint32_t stack_pattern = 0xdeadbeef;

/// What the caller of `paint_stack` may have in use already.
constexpr std::uint32_t words_in_use = 32;

void paint_stack() {
  for (volatile std::uint32_t* word = ld_stack_limit; word + words_in_use < ld_stack_top; ++word) *word = stack_pattern;
}

/// Copies code into RAM, memcpy itself among it: volatile, so that no compiler makes a call of memcpy of it.
void load_fast_code() {
  const std::uint32_t* from = ld_fast_code_load;
  for (volatile std::uint32_t* to = ld_fast_code_start; to < ld_fast_code_end; ++to) *to = *from++;
}

}  // namespace

extern "C" void start_program() {
  paint_stack();
  load_fast_code();
  std::copy(ld_data_load, ld_data_load + (ld_data_end - ld_data_start), ld_data_start);
  std::fill(ld_bss_start, ld_bss_end, 0U);
  board_set_up();
  std::for_each(ld_init_start, ld_init_end, [](auto construct) { construct(); });
  spanline::board::exit(main());
}

namespace spanline::board {

std::uint32_t stack_size() { return static_cast<std::uint32_t>(ld_stack_top - ld_stack_limit) * sizeof(std::uint32_t); }

std::uint32_t stack_used() {
  const std::uint32_t* const deepest =
      std::find_if(ld_stack_limit, ld_stack_top, [](std::uint32_t word) { return word != stack_pattern; });
  return static_cast<std::uint32_t>(ld_stack_top - deepest) * sizeof(std::uint32_t);
}

}  // namespace spanline::board
