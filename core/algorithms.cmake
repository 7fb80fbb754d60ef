# What the registry of visibility algorithms means for the build.
set(SPANLINE_ALGORITHM_REGISTRY ${CMAKE_CURRENT_LIST_DIR}/spanline/visibility/algorithms.def)

# spanline_sources_by_algorithm(variable template): a source an algorithm, made of `template` (a .cpp.in file), whose paths go
# into the variable. The template sees @ALGORITHM_ID@, @ALGORITHM_OPTION@, @ALGORITHM_BOARD_OPTION@ and @ALGORITHM_HEADER@.
# Lines with the same two options share the source of their first.
function(spanline_sources_by_algorithm variable template)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${SPANLINE_ALGORITHM_REGISTRY})
  file(STRINGS ${SPANLINE_ALGORITHM_REGISTRY} lines REGEX "^SPANLINE_ALGORITHM\\(")
  get_filename_component(stem ${template} NAME_WE)
  set(sources "")
  set(seen "")
  foreach(line IN LISTS lines)
    if(NOT line MATCHES "^SPANLINE_ALGORITHM\\(([a-z0-9_]+), \"([^\"]+)\", ([^,\"]+), ([^,\"]+), \"([^\"]+)\", ")
      message(FATAL_ERROR "algorithms.def: this line has not the columns that it should have: ${line}")
    endif()
    set(ALGORITHM_ID ${CMAKE_MATCH_1})
    set(ALGORITHM_OPTION ${CMAKE_MATCH_3})
    set(ALGORITHM_BOARD_OPTION ${CMAKE_MATCH_4})
    set(ALGORITHM_HEADER ${CMAKE_MATCH_5})
    if("${ALGORITHM_OPTION},${ALGORITHM_BOARD_OPTION}" IN_LIST seen)
      continue()
    endif()
    list(APPEND seen "${ALGORITHM_OPTION},${ALGORITHM_BOARD_OPTION}")
    configure_file(${template} ${CMAKE_CURRENT_BINARY_DIR}/${stem}_${ALGORITHM_ID}.cpp @ONLY)
    list(APPEND sources ${CMAKE_CURRENT_BINARY_DIR}/${stem}_${ALGORITHM_ID}.cpp)
  endforeach()
  set(${variable} ${sources} PARENT_SCOPE)
endfunction()
