set(SPANLINE_PRESET arm-m3)
set(spanline_core_flags "-mcpu=cortex-m3 -mfloat-abi=soft")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
