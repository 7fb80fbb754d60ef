set(SPANLINE_PRESET arm-m0plus)
# Measured (docs/benchmarks.md): with eight registers for arithmetic, Chow's allocation by priority spills less than the
# default by graph colouring; and names that are kept apart help it.
set(spanline_core_flags "-mcpu=cortex-m0plus -mfloat-abi=soft -fira-algorithm=priority -fno-tree-coalesce-vars")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
