#pragma once

#include <cstdint>

/// Addresses that sections.ld defines. Only the addresses mean anything.
extern "C" {
extern std::uint32_t ld_data_load[];
extern std::uint32_t ld_data_start[];
extern std::uint32_t ld_data_end[];
extern std::uint32_t ld_fast_code_load[];
extern std::uint32_t ld_fast_code_start[];
extern std::uint32_t ld_fast_code_end[];
extern std::uint32_t ld_bss_start[];
extern std::uint32_t ld_bss_end[];
extern std::uint32_t ld_stack_limit[];
extern std::uint32_t ld_stack_top[];
extern void (*ld_init_start[])();
extern void (*ld_init_end[])();
}
