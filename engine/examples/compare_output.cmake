# SPDX-License-Identifier: MIT
# cmake -DPROGRAM=... -DEXPECTED=... [-DOPTIONS=...] [-DRUNNER=...] -P compare_output.cmake
# Runs a program and fails unless it succeeds and prints exactly the text of a file.
execute_process(COMMAND ${RUNNER} ${PROGRAM} ${OPTIONS}
                OUTPUT_VARIABLE output ERROR_VARIABLE errors RESULT_VARIABLE result)
file(READ ${EXPECTED} expected)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "exit code ${result}\n${output}${errors}")
endif()
if(NOT output STREQUAL expected)
    message(FATAL_ERROR "the output differs from ${EXPECTED}:\n${output}")
endif()
