set(SPANLINE_PRESET arm-m3)
# Measured (docs/benchmarks.md): scheduling before registers are allocated costs the set-up and the rows of triangles
# more spills than it gains.
set(spanline_core_flags "-mcpu=cortex-m3 -mfloat-abi=soft -fno-schedule-insns")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
