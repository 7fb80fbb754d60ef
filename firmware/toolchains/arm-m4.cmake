set(SPANLINE_PRESET arm-m4)
# Measured (docs/benchmarks.md): both passes cost the set-up and the rows of triangles more spilled registers than they
# gain.
set(spanline_core_flags "-mcpu=cortex-m4 -mfloat-abi=soft -fno-schedule-insns -fno-tree-coalesce-vars")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
