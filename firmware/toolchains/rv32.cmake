set(SPANLINE_PRESET rv32)
set(CMAKE_SYSTEM_PROCESSOR riscv32)
set(CMAKE_CXX_COMPILER riscv64-unknown-elf-g++)

# Debian packs no C++ library for RISC-V. The freestanding headers of the Arm one hold nothing that is Arm's own.
file(GLOB spanline_newlib_cxx /usr/include/newlib/c++/*)
if(NOT spanline_newlib_cxx)
  message(FATAL_ERROR "the C++ headers are missing: install libstdc++-arm-none-eabi-dev and libnewlib-dev")
endif()
list(GET spanline_newlib_cxx -1 spanline_newlib_cxx)
# Not rv32imc_zicsr: that name picks a 64-bit libgcc.
set(spanline_core_flags
    "-march=rv32imc -mabi=ilp32 -mcmodel=medany -isystem ${spanline_newlib_cxx} \
-isystem ${spanline_newlib_cxx}/arm-none-eabi -isystem /usr/include/newlib")
include(${CMAKE_CURRENT_LIST_DIR}/freestanding.cmake)
