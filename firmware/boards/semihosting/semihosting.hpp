#pragma once

#include <cstdint>

/// Calls to the debugger or emulator (Arm's "Semihosting for AArch32 and AArch64"; RISC-V took it over).
namespace spanline::board::semihosting {

enum class Operation : std::uint32_t { write_text = 0x04, exit_extended = 0x20 };

#if defined(__riscv)
/// The three instructions that mark a call must lie in one page, uncompressed: a function of its own sees to that.
extern "C" std::uintptr_t semihosting_trap(std::uint32_t operation, const void* argument);

inline std::uintptr_t call(Operation operation, const void* argument) {
  return semihosting_trap(static_cast<std::uint32_t>(operation), argument);
}
#else
inline std::uintptr_t call(Operation operation, const void* argument) {
  register std::uintptr_t r0 asm("r0") = static_cast<std::uint32_t>(operation);
  register const void* r1 asm("r1") = argument;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}
#endif

}  // namespace spanline::board::semihosting
