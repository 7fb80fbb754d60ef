#include <array>
#include <cstdint>

#include "board.hpp"
#include "linker.hpp"
#include "start.hpp"

// The machine-mode registers used here are of the RISC-V Privileged Architecture, chapter 3.

namespace spanline::board {
namespace {

/// Exit code of a program that ended in a fault ("internal software error" of sysexits.h).
constexpr int fault_exit_code = 70;

void write_register(const char* name, std::uint32_t value) {
  write(name);
  write(" 0x");
  write_hex(value);
}

void write_cause(std::uint32_t cause) {
  constexpr std::array<const char*, 8> names{
      "instruction address misaligned", "instruction access fault", "illegal instruction",      "breakpoint",
      "load address misaligned",        "load access fault",        "store address misaligned", "store access fault"};
  if (cause < names.size()) {
    write(names[cause]);
  } else {
    write_register("cause", cause);
  }
}

}  // namespace
}  // namespace spanline::board

extern "C" {

/// Says what happened and where, one line on the console, and exits.
[[noreturn, gnu::used]] void trap_report(std::uint32_t cause, std::uint32_t pc, std::uint32_t address, std::uint32_t ra,
                                         std::uint32_t sp) {
  using namespace spanline::board;
  write("fault: ");
  write_cause(cause);
  write_register(" at pc", pc);
  write_register(", ra", ra);
  write_register(", sp", sp);
  write_register(", address", address);
  if (sp < reinterpret_cast<std::uintptr_t>(ld_stack_limit) + 16) write(", stack overflow");
  write("\n");
  exit(fault_exit_code);
}

/// Every trap comes here; none returns. Reports on the stack as it is, or on a fresh one where little of it is left.
[[gnu::naked, gnu::aligned(4)]] void trap_entry() {
  asm volatile(
      ".option push\n"
      ".option arch, +zicsr\n"
      "csrr a0, mcause\n"
      "csrr a1, mepc\n"
      "csrr a2, mtval\n"
      ".option pop\n"
      "mv a3, ra\n"
      "mv a4, sp\n"
      "la t0, ld_stack_limit + 256\n"
      "bgeu sp, t0, 1f\n"
      "la sp, ld_stack_top\n"
      "1: tail trap_report\n");
}

/// First instruction of the image. The 4 KB below the stack are made a region of no access, locked so that machine
/// mode is held to it: RAM has no end there that would stop an overflow.
[[gnu::naked, gnu::section(".vectors"), gnu::used]] void reset_handler() {
  asm volatile(
      ".option push\n"
      ".option norelax\n"
      "la gp, __global_pointer$\n"
      ".option pop\n"
      "la sp, ld_stack_top\n"
      ".option push\n"
      ".option arch, +zicsr\n"
      "la t0, trap_entry\n"
      "csrw mtvec, t0\n"
      "la t0, ld_stack_limit - 4096\n"
      "srli t0, t0, 2\n"
      "ori t0, t0, 4096 / 8 - 1\n"  // NAPOT, 4 KB
      "csrw pmpaddr0, t0\n"
      "li t0, 0x98\n"  // locked, NAPOT, neither read, write nor execute
      "csrw pmpcfg0, t0\n"
      ".option pop\n"
      "tail start_program\n");
}

/// The RISC-V form of a semihosting call (riscv-software-src/riscv-semihosting, 2.1).
[[gnu::naked, gnu::aligned(16)]] std::uintptr_t semihosting_trap(std::uint32_t, const void*) {
  asm volatile(
      ".option push\n"
      ".option norvc\n"
      "slli zero, zero, 0x1f\n"
      "ebreak\n"
      "srai zero, zero, 7\n"
      "ret\n"
      ".option pop\n");
}

}  // extern "C"
