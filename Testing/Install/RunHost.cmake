# SPDX-License-Identifier: BSD-3-Clause
# Configures the host with all modules; builds PROGRAM with the modules that it needs, and runs it.
cmake_minimum_required(VERSION 3.25)

function (run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if (NOT result EQUAL 0)
    message(FATAL_ERROR "failed (${result}): ${ARGN}")
  endif ()
endfunction ()

set(build "${HOST_DIR}/build")
# Not optimised and for one instruction set: what counts is that it builds and links.
run("${CMAKE_COMMAND}" --fresh -S "${HOST_DIR}" -B "${build}" -G "${GENERATOR}"
  "-DCMAKE_BUILD_TYPE=Debug"
  "-DCMAKE_CXX_FLAGS_DEBUG=-O0 -DHWY_COMPILE_ONLY_STATIC"
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}"
  "-DVTK_DIR=${VTK_DIR}")
run("${CMAKE_COMMAND}" --build "${build}" --parallel 2 --target "${PROGRAM}")
run("${build}/${PROGRAM}")
