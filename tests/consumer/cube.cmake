# What is the same whichever way the libraries came: where the cube of README.md lies, and for a microcontroller the code
# that starts it.
target_include_directories(cube PRIVATE ${CUBE_FOLDER})
if(CMAKE_CROSSCOMPILING)
  target_sources(cube PRIVATE ${CMAKE_CURRENT_LIST_DIR}/cortex_m4/start.cpp)
  target_include_directories(cube PRIVATE ${CMAKE_CURRENT_LIST_DIR})
  target_link_options(cube PRIVATE -nostdlib -Wl,--gc-sections -T${CMAKE_CURRENT_LIST_DIR}/cortex_m4/memory.ld)
  target_link_libraries(cube PRIVATE gcc)
else()
  target_sources(cube PRIVATE ${CMAKE_CURRENT_LIST_DIR}/host.cpp)
endif()
