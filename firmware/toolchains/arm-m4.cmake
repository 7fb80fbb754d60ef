set(SPANLINE_PRESET arm-m4)
set(spanline_core_flags "-mcpu=cortex-m4 -mfloat-abi=soft")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
