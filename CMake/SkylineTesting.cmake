# SPDX-License-Identifier: BSD-3-Clause
# Functions that add tests. Each test has its folder as a label: `ctest --preset default -L Sun`.
include(GoogleTest)
include("${CMAKE_CURRENT_LIST_DIR}/SkylineTargets.cmake")

# skyline_add_gtest(<Name> <source>... [LIBRARIES <target>...] [LABELS <label>...] [SERIAL])
#   Builds a GoogleTest program (with GoogleTest's main) and adds each of its tests to ctest.
#   In Testing/Module/Sun:  skyline_add_gtest(TestSunPosition TestSunPosition.cxx)
#   Links SkylineReference and the core; LIBRARIES adds more. SERIAL: it runs alone (for timings).
#   Defines the strings SKYLINE_TEST_DATA (Testing/Data) and SKYLINE_TEST_OUTPUT (an output folder).
function (skyline_add_gtest name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "SERIAL" "" "LIBRARIES;LABELS")
  get_filename_component(folder "${CMAKE_CURRENT_SOURCE_DIR}" NAME)
  set(output "${CMAKE_CURRENT_BINARY_DIR}/${name}-output")
  file(MAKE_DIRECTORY "${output}")

  add_executable(${name} ${arg_UNPARSED_ARGUMENTS})
  skyline_compile_options(${name})
  target_link_libraries(${name} PRIVATE SkylineReference ${arg_LIBRARIES} GTest::gtest_main)
  target_precompile_headers(${name} REUSE_FROM SkylineTestHeaders)
  target_compile_definitions(${name} PRIVATE
    "SKYLINE_TEST_DATA=\"${PROJECT_SOURCE_DIR}/Testing/Data\""
    "SKYLINE_TEST_OUTPUT=\"${output}\"")
  set_target_properties(${name} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin/Testing")
  set(properties LABELS "${folder};${arg_LABELS}" TIMEOUT 600)
  if (arg_SERIAL)
    list(APPEND properties RUN_SERIAL TRUE)
  endif ()
  gtest_discover_tests(${name}
    TEST_PREFIX "${folder}."
    NO_PRETTY_VALUES # show the names that the test gives its parameters
    DISCOVERY_MODE PRE_TEST
    DISCOVERY_TIMEOUT 120
    WORKING_DIRECTORY "${output}"
    PROPERTIES ${properties})
endfunction ()

# skyline_add_python_test(<Name> <script> [<argument>...])
#   Runs a Python script (a path relative to this folder) that can `import skyline` from the build
#   tree.
function (skyline_add_python_test name script)
  get_filename_component(folder "${CMAKE_CURRENT_SOURCE_DIR}" NAME)
  get_filename_component(script "${script}" ABSOLUTE)
  add_test(NAME ${folder}.${name}
    COMMAND "${Python3_EXECUTABLE}" "${script}" ${ARGN})
  set_tests_properties(${folder}.${name} PROPERTIES
    ENVIRONMENT_MODIFICATION "PYTHONPATH=path_list_prepend:${CMAKE_BINARY_DIR}/python"
    LABELS "${folder}" TIMEOUT 600)
endfunction ()

# skyline_add_program_tests(<Name>...)
#   Runs the Python script <Name>.py with the built program and the folder of test data. Exit code
#   77 means that the test is skipped, because GDAL's Python module is not installed.
function (skyline_add_program_tests)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  get_filename_component(folder "${CMAKE_CURRENT_SOURCE_DIR}" NAME)
  foreach (name IN LISTS ARGN)
    add_test(NAME ${folder}.${name}
      COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/${name}.py"
        "$<TARGET_FILE:skyline>" "${PROJECT_SOURCE_DIR}/Testing/Data")
    set_tests_properties(${folder}.${name} PROPERTIES LABELS "${folder}" TIMEOUT 900 SKIP_RETURN_CODE 77)
  endforeach ()
endfunction ()
