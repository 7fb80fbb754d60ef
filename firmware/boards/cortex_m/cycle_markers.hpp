#pragma once

/// Instructions that do nothing and that no compiler writes, for the cycle counters of tests/qemu/cycles and
/// tests/rp2040, which know them by their encoding and do not count them. They keep their order among volatile accesses
/// and other markers; the compiler may move other code across them.
namespace spanline::board {

/// Starts an interval of counting.
inline void cycles_start() { asm volatile("mov r9, r9"); }

/// Ends the interval.
inline void cycles_stop() { asm volatile("mov r10, r10"); }

/// Reports what the intervals since the last report add up to, and begins at zero.
inline void cycles_report() { asm volatile("mov r11, r11"); }

}  // namespace spanline::board
