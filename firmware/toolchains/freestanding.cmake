# What every cross build shares. The toolchain file that includes this one sets SPANLINE_PRESET (its own name,
# by which boards.json finds its boards) and spanline_core_flags first.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(CMAKE_CXX_FLAGS_INIT
    "${spanline_core_flags} -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-unwind-tables \
-fno-asynchronous-unwind-tables -ffunction-sections -fdata-sections -fstack-usage -fcallgraph-info=su,da")
# Debug information costs nothing in the image, and lets addr2line read what the fault handler prints.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -g -DNDEBUG" CACHE STRING "Flags of the optimised build")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostdlib -Wl,--gc-sections")

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
