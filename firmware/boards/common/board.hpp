#pragma once

#include <cstdint>

/// What every board offers a program. A board with more (a counter, a clock, a display) has headers of its own in
/// its folder, which is on the include path of the programs built for it.
namespace spanline::board {

/// Writes a text to the board's console as it is: semihosting on emulated boards, a UART on those that people flash.
void write(const char* text);

/// Writes a number in decimal digits.
void write_unsigned(std::uint32_t value);

/// Writes eight lower-case hexadecimal digits, without a prefix.
void write_hex(std::uint32_t value);

/// Ends the program; `code` is what the emulator exits with (0..255). `main` returning does the same. A board without
/// emulator writes "exit <code>" and stops.
[[noreturn]] void exit(int code);

/// Bytes of stack that the linker script set aside.
std::uint32_t stack_size();

/// The most stack in use at any time so far, bytes: start-up fills the stack with a pattern, and this looks how much
/// of it is still there.
std::uint32_t stack_used();

}  // namespace spanline::board
