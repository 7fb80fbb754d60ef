# GNU toolchain for 32-bit Arm, without an operating system.
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
string(PREPEND spanline_core_flags "-mthumb ")
include(${CMAKE_CURRENT_LIST_DIR}/freestanding.cmake)
