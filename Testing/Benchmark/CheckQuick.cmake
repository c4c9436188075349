# SPDX-License-Identifier: BSD-3-Clause
# Runs the program PROGRAM with --quick, which must succeed and print its table. A
# PASS_REGULAR_EXPRESSION of the test would not check the exit code.
execute_process(
  COMMAND "${PROGRAM}" --quick --csv "${CSV}"
  OUTPUT_VARIABLE output
  RESULT_VARIABLE result)
message("${output}")
if (NOT result EQUAL 0)
  message(FATAL_ERROR "SkylineBenchmark ended with ${result}")
endif ()
foreach (line IN ITEMS
    "hills +exact " "walls +exact " "helens +exact " "hills +exact, 0.05 deg " "hills +fast "
    "hills +sweep " "hills +pyramid " "hills +pyramid, max alone " "hills +every crossing " "hills +Embree 0.01 deg " "hills +GRASS r.horizon "
    "hills +exact \\+ sky view " "exact over every crossing")
  if (NOT output MATCHES "${line}")
    message(FATAL_ERROR "no line '${line}'")
  endif ()
endforeach ()
file(STRINGS "${CSV}" exact REGEX "^\"hills\",exact,[-0-9.e]+,")
if (NOT exact)
  message(FATAL_ERROR "no row of the exact method in ${CSV}")
endif ()
