#pragma once

#include <cstdint>

/// Instruction counter: the core's `minstret` (RISC-V Privileged Architecture, 3.1.10). Exact under QEMU when it runs
/// with `-icount shift=0`.
namespace spanline::board {

inline std::uint32_t instructions_retired() {
  std::uint32_t count = 0;
  asm volatile(
      ".option push\n"
      ".option arch, +zicsr\n"
      "csrr %0, minstret\n"
      ".option pop"
      : "=r"(count)::"memory");
  return count;
}

inline std::uint32_t counter_origin = 0;

/// Starts counting at zero. Good for 4,200 million instructions.
inline void counter_start() { counter_origin = instructions_retired(); }

/// Instructions since `counter_start`. The two calls themselves are a few of them.
inline std::uint32_t counter_read() { return instructions_retired() - counter_origin; }

/// For the boards whose cycles are modelled.
inline void counter_report() {}

}  // namespace spanline::board
