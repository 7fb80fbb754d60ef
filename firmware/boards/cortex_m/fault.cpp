#include <array>
#include <cstdint>

#include "board.hpp"
#include "linker.hpp"

namespace spanline::board {
namespace {

/// Exit code of a program that ended in a fault ("internal software error" of sysexits.h).
constexpr int fault_exit_code = 70;

/// What the core pushes on taking an exception (Armv7-M Architecture Reference Manual, B1.5.6).
struct StackedRegisters {
  std::uint32_t r0, r1, r2, r3, r12, lr, pc, xpsr;
};

std::uint32_t active_exception() {
  std::uint32_t number = 0;
  asm volatile("mrs %0, ipsr" : "=r"(number));
  return number & 0x1ffU;
}

void write_exception_name(std::uint32_t number) {
  constexpr std::uint32_t first_interrupt = 16;
  constexpr std::array<const char*, first_interrupt> names{
      "no exception", "reset",      "NMI",         "HardFault", "MemManage", "BusFault",    "UsageFault", "reserved 7",
      "reserved 8",   "reserved 9", "reserved 10", "SVCall",    "DebugMon",  "reserved 13", "PendSV",     "SysTick"};
  if (number < first_interrupt) {
    write(names[number]);
    return;
  }
  write("interrupt ");
  write_unsigned(number - first_interrupt);
}

void write_register(const char* name, std::uint32_t value) {
  write(name);
  write(" 0x");
  write_hex(value);
}

/// The fault status registers, which Armv6-M lacks (Armv7-M Architecture Reference Manual, B3.2.15).
void write_fault_status() {
#if __ARM_ARCH >= 7
  const auto* const status = reinterpret_cast<const volatile std::uint32_t*>(0xe000ed28);
  const auto* const memory_address = reinterpret_cast<const volatile std::uint32_t*>(0xe000ed34);
  const auto* const bus_address = reinterpret_cast<const volatile std::uint32_t*>(0xe000ed38);
  constexpr std::uint32_t memory_address_valid = 1U << 7, bus_address_valid = 1U << 15;
  const std::uint32_t flags = *status;
  write_register(", cfsr", flags);
  if ((flags & memory_address_valid) != 0) write_register(", address", *memory_address);
  if ((flags & bus_address_valid) != 0) write_register(", address", *bus_address);
#endif
}

}  // namespace
}  // namespace spanline::board

/// Says what happened and where, one line on the console, and exits.
extern "C" [[noreturn, gnu::used]] void fault_report(const spanline::board::StackedRegisters* stacked) {
  using namespace spanline::board;
  write("fault: ");
  write_exception_name(active_exception());
  const auto sp = reinterpret_cast<std::uintptr_t>(stacked);
  if (sp < reinterpret_cast<std::uintptr_t>(ld_stack_limit)) {
    // The core could not push its registers, so nobody knows where it was.
    write_register(", stack overflow: sp", sp);
  } else {
    write_register(" at pc", stacked->pc);
    write_register(", lr", stacked->lr);
    write_register(", sp", sp + sizeof(StackedRegisters));
  }
  write_fault_status();
  write("\n");
  exit(fault_exit_code);
}

/// Every fault comes here. Reports on the stack as it is, or on a fresh one where little of it is left.
extern "C" [[gnu::naked]] void fault_entry() {
  asm volatile(
      "mrs r0, msp\n"
      "ldr r1, =ld_stack_limit + 256\n"
      "cmp r0, r1\n"
      "bhs 1f\n"
      "ldr r1, =ld_stack_top\n"
      "msr msp, r1\n"
      "1: ldr r1, =fault_report\n"
      "bx r1\n"
      ".ltorg\n");
}
