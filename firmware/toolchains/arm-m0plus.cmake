set(SPANLINE_PRESET arm-m0plus)
set(spanline_core_flags "-mcpu=cortex-m0plus -mfloat-abi=soft")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
