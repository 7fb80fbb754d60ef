# CMAKE_PROJECT_spanline_INCLUDE of the tests: read by Spanline's own project(), after the compiler was found. From there on it must
# get along with the compiler alone, so that looking for anything is an error.
foreach(command find_package find_program find_library find_path find_file execute_process)
  cmake_language(EVAL CODE "
    macro(${command})
      message(FATAL_ERROR \"Spanline calls ${command}: \${ARGN}\")
    endmacro()")
endforeach()
