# Hard-float ABI with the FPU registers forbidden: any float at run time is a compile error.
set(SPANLINE_PRESET arm-m4-nofloat)
set(spanline_core_flags "-mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16 -mgeneral-regs-only")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
