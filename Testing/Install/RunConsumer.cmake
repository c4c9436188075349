# SPDX-License-Identifier: BSD-3-Clause
cmake_minimum_required(VERSION 3.25)

# run(<command>...): ends the test if the command fails.
function (run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if (NOT result EQUAL 0)
    message(FATAL_ERROR "failed (${result}): ${ARGN}")
  endif ()
endfunction ()

# Files of an earlier run must not affect this one.
file(REMOVE_RECURSE "${WORK_DIR}")
file(MAKE_DIRECTORY "${WORK_DIR}")
run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${WORK_DIR}/first")

# The installation is moved, because it must not depend on the folder into which it was installed.
set(prefix "${WORK_DIR}/prefix")
file(RENAME "${WORK_DIR}/first" "${prefix}")
run("${CMAKE_COMMAND}" -S "${CONSUMER_DIR}" -B "${WORK_DIR}/build" -G "${GENERATOR}"
  "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}"
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
  "-DVTK_DIR=${VTK_DIR}"
  "-DCMAKE_PREFIX_PATH=${prefix}")

# The package must be that of this installation, not one of the system.
file(STRINGS "${WORK_DIR}/build/CMakeCache.txt" found REGEX "^Skyline_DIR")
if (NOT found STREQUAL "Skyline_DIR:PATH=${prefix}/${LIBRARY_DIR}/cmake/Skyline")
  message(FATAL_ERROR "found another package: ${found}")
endif ()

run("${CMAKE_COMMAND}" --build "${WORK_DIR}/build")
run("${WORK_DIR}/build/SkyView" "${DEM}" "${WORK_DIR}/sky-view.tif")
run("${prefix}/bin/skyline" sun "${DEM}" --time 2026-06-21T06:00Z)
if (DEFINED PYTHON)
  run("${CMAKE_COMMAND}" -E env "PYTHONPATH=${prefix}/${PYTHON_DIR}"
    "${PYTHON}" -c "import skyline; skyline.vtkHeightFieldHorizon()")
endif ()
