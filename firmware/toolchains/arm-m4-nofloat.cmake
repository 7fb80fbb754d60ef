# For the hard-float ABI, with floating-point registers forbidden in the project's own code (nofloat.hpp): any float at
# run time is a compile error. Nothing is run, and nothing optimised away.
set(SPANLINE_PRESET arm-m4-nofloat)
set(spanline_core_flags
    "-mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16 -include ${CMAKE_CURRENT_LIST_DIR}/nofloat.hpp")
set(CMAKE_CXX_FLAGS_RELEASE "-O0 -fomit-frame-pointer" CACHE STRING "Flags of the build that only compiles")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
