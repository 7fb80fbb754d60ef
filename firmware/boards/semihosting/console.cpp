// The console of boards that only run under an emulator or a debugger.
#include <array>

#include "board.hpp"
#include "semihosting.hpp"

namespace spanline::board {

void write(const char* text) { semihosting::call(semihosting::Operation::write_text, text); }

void exit(int code) {
  constexpr std::uint32_t application_exit = 0x20026;
  const std::array<std::uint32_t, 2> reason{application_exit, static_cast<std::uint32_t>(code)};
  semihosting::call(semihosting::Operation::exit_extended, reason.data());
  for (;;) {
  }
}

}  // namespace spanline::board
