# SPDX-License-Identifier: Apache-2.0
# cmake -D verify=PROGRAM -D cases=FOLDER -P replay.cmake: every pixel case below FOLDER, in one run.
file(GLOB_RECURSE files "${cases}/*.jsonl")
list(FILTER files EXCLUDE REGEX "/known_failures/")
if(NOT files)
  message(FATAL_ERROR "${cases}: no pixel case there")
endif()
list(SORT files)
execute_process(COMMAND "${verify}" areas ${files} RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "keikan-verify areas: exit code ${code}")
endif()
