#pragma once

#include <cstdint>

/// The few registers of the LM3S6965 that this board support uses, by the names of its data sheet.
namespace spanline::board {

/// Frequency of the core and of the peripherals once start-up has set the PLL, hertz.
inline constexpr std::uint32_t system_clock_hz = 50'000'000;

inline volatile std::uint32_t& io(std::uintptr_t address) {
  return *reinterpret_cast<volatile std::uint32_t*>(address);
}

/// Reads for the reading's own effect: a reference that is only dropped is not an access.
inline void touch(std::uintptr_t address) { [[maybe_unused]] const std::uint32_t value = io(address); }

inline void set_bits(volatile std::uint32_t& target, std::uint32_t bits) { target = target | bits; }
inline void clear_bits(volatile std::uint32_t& target, std::uint32_t bits) { target = target & ~bits; }

}  // namespace spanline::board
