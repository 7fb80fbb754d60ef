#pragma once

/// Prepares memory (stack pattern, initialised data, zeroed data), runs constructors and `main`, and exits with what
/// it returned. The core's own start-up jumps here with the stack pointer at `ld_stack_top`.
extern "C" [[noreturn]] void start_program();

/// A board's own set-up (clocks), called before constructors. Boards that need none leave it out.
extern "C" void board_set_up();
