set(SPANLINE_PRESET arm-m7)
set(spanline_core_flags "-mcpu=cortex-m7 -mfloat-abi=soft")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
