# The firmware by clang, whose objects gcc's linker joins. -DSPANLINE_PRESET=arm-m0plus or arm-m4 picks the core, and with
# it the boards, as the preset of that name does.
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES SPANLINE_PRESET)
set(cpu_of_arm-m0plus cortex-m0plus)
set(cpu_of_arm-m4 cortex-m4)
set(cpu "-mcpu=${cpu_of_${SPANLINE_PRESET}} -mthumb -mfloat-abi=soft")

set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_CXX_COMPILER clang++)
set(CMAKE_CXX_COMPILER_TARGET arm-none-eabi)
file(GLOB headers /usr/include/newlib/c++/*)
list(GET headers -1 headers)
set(CMAKE_CXX_FLAGS_INIT
    "${cpu} -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics -ffunction-sections -fdata-sections \
-isystem ${headers} -isystem ${headers}/arm-none-eabi -isystem /usr/include/newlib")
# What libgcc has was built with enumerations of another size, and without a word on whether its stack is executed.
set(CMAKE_CXX_LINK_EXECUTABLE
    "arm-none-eabi-g++ ${cpu} -nostdlib -Wl,--gc-sections,--no-enum-size-warning,--no-warn-execstack <LINK_FLAGS> <OBJECTS> \
-o <TARGET> <LINK_LIBRARIES>")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
