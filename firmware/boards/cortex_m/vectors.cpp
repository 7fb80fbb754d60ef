#include <array>
#include <cstdint>

#include "linker.hpp"
#include "start.hpp"

namespace {

/// Registers of the system control block (Armv7-M Architecture Reference Manual, B3.2).
volatile std::uint32_t& system_control(std::uint32_t offset) {
  constexpr std::uintptr_t system_control_block = 0xe000ed00;
  return *reinterpret_cast<volatile std::uint32_t*>(system_control_block + offset);
}

/// Makes the core complain where it would carry on: at an integer division by zero, and in code built for a
/// Cortex-M0+ at an unaligned access, which that core cannot do. Faults get handlers of their own instead of all
/// being a HardFault, so that the report can name them. Armv6-M cores have no such registers and fault anyway.
void enable_fault_checks() {
  constexpr std::uint32_t cpu_id = 0x0, architecture = 0xf0000, armv7m = 0xf0000;
  if ((system_control(cpu_id) & architecture) != armv7m) return;
  constexpr std::uint32_t configuration_and_control = 0x14, handler_control = 0x24;
#if defined(__ARM_FEATURE_UNALIGNED)
  constexpr std::uint32_t traps = 1U << 4;  // DIV_0_TRP
#else
  constexpr std::uint32_t traps = 1U << 4 | 1U << 3;  // and UNALIGN_TRP
#endif
  constexpr std::uint32_t enable_memory_bus_usage = 7U << 16;
  system_control(configuration_and_control) = system_control(configuration_and_control) | traps;
  system_control(handler_control) = system_control(handler_control) | enable_memory_bus_usage;
}

using Handler = void (*)();

/// What the core reads at address 0 (Armv7-M Architecture Reference Manual, B1.5.3).
struct VectorTable {
  std::uint32_t* stack;
  Handler reset;
  std::array<Handler, 13> exceptions;
  Handler systick;
  std::array<Handler, 48> interrupts;
};

template <std::size_t size>
constexpr std::array<Handler, size> all(Handler handler) {
  std::array<Handler, size> handlers{};
  handlers.fill(handler);
  return handlers;
}

}  // namespace

extern "C" {

/// In fault.cpp.
void fault_entry();

[[noreturn]] void reset_handler() {
  enable_fault_checks();
  start_program();
}

/// A board that uses the SysTick timer or a chip's interrupts defines these (IPSR says which interrupt it is).
/// Without, sections.ld makes them fault_entry, which reports the interrupt as it does a fault.
void systick_handler();
void interrupt_handler();

}  // extern "C"

[[gnu::section(".vectors"), gnu::used]] constinit const VectorTable vectors{
    .stack = ld_stack_top,
    .reset = reset_handler,
    .exceptions = all<13>(fault_entry),
    .systick = systick_handler,
    .interrupts = all<48>(interrupt_handler),
};
