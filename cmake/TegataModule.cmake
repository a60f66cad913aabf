# SPDX-FileCopyrightText: 2026 The tegata authors
# SPDX-License-Identifier: Apache-2.0

# One shared list of flags for everything that is compiled here.
add_library(tegata_flags INTERFACE)
target_compile_options(tegata_flags INTERFACE
  -Wall -Wextra -Wconversion $<$<BOOL:${TEGATA_WERROR}>:-Werror>
  -ffp-contract=off  # the same bits on every machine, whatever instructions it has
  -fno-math-errno -fno-trapping-math)  # nobody asks; loops with square roots are vectorised
if(TEGATA_SANITIZE)
  target_compile_options(tegata_flags INTERFACE
    -fsanitize=${TEGATA_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(tegata_flags INTERFACE -fsanitize=${TEGATA_SANITIZE})
endif()

# What most files include, compiled once for the rooms and once for the tests, which are programs
# and so compiled with other flags. To save time only: every header includes what it uses itself.
function(tegata_precompiled target header)
  target_link_libraries(${target} PRIVATE tegata_flags Eigen3::Eigen ${ARGN})
  target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/${header})
endfunction()

# Tests are compiled for the compiler's speed, what they test for its own.
add_library(tegata_test_flags INTERFACE)
target_compile_options(tegata_test_flags INTERFACE $<$<CONFIG:Release>:-O1>)

# tegata_module(NAME <room> FLOOR <n> UNITS <unit>... [ALONE <unit>...] [FULL]
#               [DEPENDS <room>...] [LIBRARIES <public target>...] [PRIVATE_LIBRARIES <target>...])
#
# Declares a room of the library: the static library tegata_<room>, its headers and its tests.
# A unit is a triple in the room's folder: <unit>.h, <unit>.cpp and <unit>_test.cpp; the source or
# the test may be absent. DEPENDS names rooms on lower floors only; a room of the same or a higher
# floor is a configure error. ALONE names units that are never compiled together with others, as
# they name for themselves what others do. FULL marks rooms outside the embeddable core library.
function(tegata_module)
  cmake_parse_arguments(ARG "FULL" "NAME;FLOOR" "UNITS;ALONE;DEPENDS;LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  set(target tegata_${ARG_NAME})
  set_property(GLOBAL PROPERTY tegata_floor_${ARG_NAME} ${ARG_FLOOR})
  set(sources "")
  set(headers "")
  set(tests "")
  foreach(unit IN LISTS ARG_UNITS)
    foreach(kind IN ITEMS ".h:headers" ".cpp:sources" "_test.cpp:tests")
      string(REPLACE ":" ";" kind ${kind})
      list(GET kind 0 ending)
      list(GET kind 1 list)
      if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${unit}${ending})
        list(APPEND ${list} ${CMAKE_CURRENT_SOURCE_DIR}/${unit}${ending})
        if(unit IN_LIST ARG_ALONE)
          set_source_files_properties(${CMAKE_CURRENT_SOURCE_DIR}/${unit}${ending}
                                      PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
        endif()
      endif()
    endforeach()
  endforeach()

  if(sources)
    set(scope PUBLIC)
    add_library(${target} STATIC ${sources})
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:tegata_flags> ${ARG_PRIVATE_LIBRARIES})
    if(ARG_FLOOR GREATER 0)  # floor 0 does not have Eigen, which is what costs the time
      if(NOT TARGET tegata_precompiled)
        add_library(tegata_precompiled OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
        tegata_precompiled(tegata_precompiled precompiled.h)
      endif()
      target_precompile_headers(${target} REUSE_FROM tegata_precompiled)
    endif()
  else()
    set(scope INTERFACE)
    add_library(${target} INTERFACE)
  endif()
  add_library(tegata::${ARG_NAME} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${ARG_NAME})
  target_sources(${target} ${scope} FILE_SET HEADERS
                 BASE_DIRS ${PROJECT_SOURCE_DIR}/src FILES ${headers})
  target_compile_features(${target} ${scope} cxx_std_20)
  target_link_libraries(${target} ${scope} ${ARG_LIBRARIES})
  foreach(room IN LISTS ARG_DEPENDS)
    get_property(floor GLOBAL PROPERTY tegata_floor_${room})
    if("${floor}" STREQUAL "" OR floor GREATER_EQUAL ARG_FLOOR)
      message(FATAL_ERROR "room ${ARG_NAME} (floor ${ARG_FLOOR}) depends on ${room} (floor ${floor}): "
                          "only rooms on lower floors will do")
    endif()
    target_link_libraries(${target} ${scope} tegata_${room})
  endforeach()
  if(ARG_FULL)
    set_property(GLOBAL APPEND PROPERTY tegata_full_rooms ${target})
  else()
    set_property(GLOBAL APPEND PROPERTY tegata_core_rooms ${target})
  endif()

  if(TEGATA_TESTS AND tests)
    tegata_test(NAME ${target}_test LABEL unit SOURCES ${tests} LIBRARIES ${target})
    add_dependencies(unit_tests ${target}_test)
  endif()
endfunction()

# tegata_test(NAME <target> LABEL <label> SOURCES <file>... LIBRARIES <target>...)
#
# A GoogleTest program whose cases ctest runs one by one. TEGATA_DATA_DIR is where recordings from
# elsewhere lie, if anywhere: such tests skip with a message where the folder is absent. The label
# tells the rooms' tests (unit) from those of the whole program (end_to_end).
function(tegata_test)
  cmake_parse_arguments(ARG "" "NAME;LABEL" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${ARG_NAME} ${ARG_SOURCES})
  if(NOT TARGET tegata_precompiled_test)
    add_executable(tegata_precompiled_test ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
    tegata_precompiled(tegata_precompiled_test precompiled_test.h
                       tegata_test_flags GTest::gtest_main)
  endif()
  target_link_libraries(${ARG_NAME} PRIVATE
    tegata_flags tegata_test_flags ${ARG_LIBRARIES} Eigen3::Eigen GTest::gtest_main)
  target_precompile_headers(${ARG_NAME} REUSE_FROM tegata_precompiled_test)
  target_compile_definitions(${ARG_NAME} PRIVATE
    TEGATA_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    TEGATA_DATA_DIR="${PROJECT_SOURCE_DIR}/../shared/data")
  include(GoogleTest)
  gtest_discover_tests(${ARG_NAME} DISCOVERY_MODE PRE_TEST
                       PROPERTIES TIMEOUT 600 LABELS ${ARG_LABEL})
endfunction()
