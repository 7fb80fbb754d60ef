# Spanline as a part of another project: what it must not do there. The project calls expect_manners() before it takes
# Spanline in, and check_manners(folder of its build) afterwards.

macro(expect_manners)
  get_cmake_property(variables_before VARIABLES)
  foreach(variable IN LISTS variables_before)
    set(before_${variable} "${${variable}}")
  endforeach()
endmacro()

# Fails unless a property of a target is empty.
function(check_empty target)
  foreach(property IN LISTS ARGN)
    get_target_property(value ${target} ${property})
    if(value)
      message(FATAL_ERROR "${target} has ${property} ${value}")
    endif()
  endforeach()
endfunction()

macro(check_manners folder)
  # No variable of the project, in its cache or not, has changed, and new ones bear Spanline's name.
  get_cmake_property(variables_after VARIABLES)
  foreach(variable IN LISTS variables_after)
    if(variable MATCHES "^(before_|variables?(_before|_after)?$|FETCHCONTENT_|CMAKE_MATCH_|__|ARG[CNV])" OR variable MATCHES "^[Ss][Pp][Aa][Nn][Ll][Ii][Nn][Ee]_")
      continue()
    endif()
    if(NOT variable IN_LIST variables_before)
      message(FATAL_ERROR "Spanline sets ${variable} to ${${variable}}")
    endif()
    if(NOT "${${variable}}" STREQUAL "${before_${variable}}")
      message(FATAL_ERROR "Spanline changes ${variable} from ${before_${variable}} to ${${variable}}")
    endif()
  endforeach()

  # Two libraries, in the folders core and hal, and nothing that ctest would run.
  get_property(folders DIRECTORY ${SPANLINE_FOLDER} PROPERTY SUBDIRECTORIES)
  set(targets "")
  foreach(subfolder IN LISTS SPANLINE_FOLDER folders)
    get_property(more DIRECTORY ${subfolder} PROPERTY BUILDSYSTEM_TARGETS)
    get_property(tests DIRECTORY ${subfolder} PROPERTY TESTS)
    get_property(options DIRECTORY ${subfolder} PROPERTY COMPILE_OPTIONS)
    if(tests OR options)
      message(FATAL_ERROR "${subfolder} has tests or options: ${tests} ${options}")
    endif()
    list(APPEND targets ${more})
  endforeach()
  list(SORT targets)
  if(NOT "${folders}" STREQUAL "${SPANLINE_FOLDER}/core;${SPANLINE_FOLDER}/hal" OR NOT "${targets}" STREQUAL "spanline_core;spanline_hal")
    message(FATAL_ERROR "Spanline brings the folders ${folders} and the targets ${targets}")
  endif()

  # The libraries ask for C++20 where their headers are read, and for no flag, macro or library.
  foreach(target spanline::core spanline::hal)
    check_empty(${target} COMPILE_OPTIONS INTERFACE_COMPILE_OPTIONS COMPILE_DEFINITIONS INTERFACE_COMPILE_DEFINITIONS LINK_LIBRARIES
                INTERFACE_LINK_LIBRARIES LINK_OPTIONS INTERFACE_LINK_OPTIONS)
    get_target_property(features ${target} INTERFACE_COMPILE_FEATURES)
    if(NOT features STREQUAL "cxx_std_20")
      message(FATAL_ERROR "${target} asks for ${features}")
    endif()
  endforeach()
endmacro()
