# SPDX-License-Identifier: BSD-3-Clause
cmake_minimum_required(VERSION 3.25)

# run(<command>...): runs a command, and fails the test if the command fails.
function (run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if (NOT result EQUAL 0)
    message(FATAL_ERROR "failed (${result}): ${ARGN}")
  endif ()
endfunction ()

# Files of an earlier run must not influence this one.
file(REMOVE_RECURSE "${WORK_DIR}")
file(MAKE_DIRECTORY "${WORK_DIR}")
run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${WORK_DIR}/first")

# The prefix is moved after the installation: nothing may depend on the place of installation.
set(prefix "${WORK_DIR}/prefix")
file(RENAME "${WORK_DIR}/first" "${prefix}")
# One folder of headers: those of VTK classes, and of the export macros.
file(GLOB_RECURSE headers LIST_DIRECTORIES true RELATIVE "${prefix}/include" "${prefix}/include/*")
set(includes)
foreach (header IN LISTS headers)
  if (header MATCHES "^skyline/(vtk[A-Za-z]+|Skyline[A-Za-z]+Module)\\.h$")
    get_filename_component(name "${header}" NAME)
    string(APPEND includes "#include \"${name}\"\n")
  elseif (NOT header STREQUAL "skyline")
    message(FATAL_ERROR "installed, but no public header: include/${header}")
  endif ()
endforeach ()
if (NOT includes MATCHES "vtkHeightFieldHorizon.h")
  message(FATAL_ERROR "no headers were installed in ${prefix}/include/skyline")
endif ()

# They need no header that is not installed.
file(WRITE "${WORK_DIR}/headers/headers.cxx" "${includes}")
file(WRITE "${WORK_DIR}/headers/CMakeLists.txt" "
cmake_minimum_required(VERSION 3.25)
project(SkylineHeaders LANGUAGES C CXX)
find_package(Skyline REQUIRED)
add_library(headers OBJECT headers.cxx)
target_link_libraries(headers PRIVATE
  Skyline::SkylineFilters Skyline::SkylineIO Skyline::SkylineRendering)
")
run("${CMAKE_COMMAND}" -S "${WORK_DIR}/headers" -B "${WORK_DIR}/headers/build" -G "${GENERATOR}"
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
  "-DVTK_DIR=${VTK_DIR}"
  "-DCMAKE_PREFIX_PATH=${prefix}")
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/headers/build")

run("${CMAKE_COMMAND}" -S "${CONSUMER_DIR}" -B "${WORK_DIR}/build" -G "${GENERATOR}"
  "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}"
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
  "-DVTK_DIR=${VTK_DIR}"
  "-DCMAKE_PREFIX_PATH=${prefix}")

# The package of this prefix must be found, not one of the system.
file(STRINGS "${WORK_DIR}/build/CMakeCache.txt" found REGEX "^Skyline_DIR")
if (NOT found STREQUAL "Skyline_DIR:PATH=${prefix}/${LIBRARY_DIR}/cmake/Skyline")
  message(FATAL_ERROR "found another package: ${found}")
endif ()

run("${CMAKE_COMMAND}" --build "${WORK_DIR}/build")
run("${WORK_DIR}/build/SkyView" "${DEM}" "${WORK_DIR}/sky-view.tif")
run("${prefix}/bin/skyline" sun "${DEM}" --time 2026-06-21T06:00Z)
if (DEFINED PYTHON)
  # Leaves compiled files beside the installed ones.
  run("${CMAKE_COMMAND}" -E env "PYTHONPATH=${prefix}/${PYTHON_DIR}"
    "${PYTHON}" -c "import skyline; skyline.vtkHeightFieldHorizon()")
endif ()

# A project need not wait for an installation: the build folder has a package too.
file(WRITE "${WORK_DIR}/build-tree/CMakeLists.txt" "
cmake_minimum_required(VERSION 3.25)
project(BuildTree LANGUAGES C CXX)
find_package(Skyline ${VERSION} EXACT REQUIRED)
add_executable(SkyView \"${CONSUMER_DIR}/SkyView.cxx\")
target_link_libraries(SkyView PRIVATE Skyline::SkylineFilters Skyline::SkylineIO)
")
run("${CMAKE_COMMAND}" -S "${WORK_DIR}/build-tree" -B "${WORK_DIR}/build-tree/build" -G "${GENERATOR}"
  "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}"
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
  "-DVTK_DIR=${VTK_DIR}"
  "-DSkyline_DIR=${BUILD_DIR}/${LIBRARY_DIR}/cmake/Skyline")
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/build-tree/build")
run("${WORK_DIR}/build-tree/build/SkyView" "${DEM}" "${WORK_DIR}/build-tree.tif")
file(SHA256 "${WORK_DIR}/sky-view.tif" installed)
file(SHA256 "${WORK_DIR}/build-tree.tif" built)
if (NOT installed STREQUAL built)
  message(FATAL_ERROR "the installed library and the one in the build folder compute different files")
endif ()

# Removes what was installed and nothing else, though the prefix has moved.
file(WRITE "${prefix}/share/of-somebody-else" "")
run("${CMAKE_COMMAND}" -P "${prefix}/${LIBRARY_DIR}/cmake/Skyline/SkylineUninstall.cmake")
file(GLOB_RECURSE left LIST_DIRECTORIES TRUE RELATIVE "${prefix}" "${prefix}/*")
if (NOT left STREQUAL "bin;include;lib;share;share/of-somebody-else")
  message(FATAL_ERROR "after uninstalling: ${left}")
endif ()
