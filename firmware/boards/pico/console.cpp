// The console: UART0 on GP0, 115,200 baud, 8 bits, no parity (RP2040 data sheet, section 4.2).
#include "board.hpp"
#include "registers.hpp"

namespace {

using namespace spanline::board;

constexpr std::uintptr_t uart_data = 0x40034000, uart_flags = 0x40034018, uart_baud_whole = 0x40034024,
                         uart_baud_64ths = 0x40034028, uart_line = 0x4003402c, uart_control = 0x40034030;
constexpr std::uint32_t flag_transmit_full = 1U << 5, flag_busy = 1U << 3;

/// A character takes 10,850 cycles, so hardware that works takes one within this.
constexpr int polls = 100'000;

void start_uart() {
  constexpr std::uint32_t baud = 115'200, eight_bits = 3U << 5, fifo = 1U << 4, enable = 1U << 0, transmit = 1U << 8;
  constexpr std::uint32_t divisor_64ths = (system_clock_hz * 4 + baud / 2) / baud;
  resets::release(resets::uart0);
  io(uart_baud_whole) = divisor_64ths / 64;
  io(uart_baud_64ths) = divisor_64ths % 64;
  io(uart_line) = eight_bits | fifo;
  io(uart_control) = enable | transmit;
  pins::select(0, pins::uart);
}

void wait_while(std::uint32_t flags) {
  for (int poll = 0; poll < polls && (io(uart_flags) & flags) != 0; ++poll) {
  }
}

}  // namespace

namespace spanline::board {

void write(const char* text) {
  static bool started = false;
  if (!started) start_uart();
  started = true;
  for (; *text != '\0'; ++text) {
    wait_while(flag_transmit_full);
    io(uart_data) = static_cast<unsigned char>(*text);
  }
}

void exit(int code) {
  write("exit ");
  write_unsigned(static_cast<std::uint32_t>(code));
  write("\n");
  wait_while(flag_busy);
  // A watchdog that runs starts the board again.
  for (;;) asm volatile("cpsid i\n wfi");
}

}  // namespace spanline::board
