# Runs a short mission and plots it with examples/plot_run.py; docs/results.md must show the script.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

function(call)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE result
                  OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN} ends with ${result}:\n${output}")
  endif()
endfunction()

call("${PROGRAM}" run "${SOURCE_DIR}/missions/hexagon-gravity.toml" --out run --quiet
     --set "phase[0].until=\"time >= 0.2\"")
call("${CMAKE_COMMAND}" -E env MPLBACKEND=Agg MPLCONFIGDIR=${FOLDER} "${PYTHON}"
     "${SOURCE_DIR}/examples/plot_run.py" run/run.h5 plot.png)
file(READ "${FOLDER}/plot.png" begin LIMIT 8 HEX)
file(SIZE "${FOLDER}/plot.png" size)
if(NOT begin STREQUAL "89504e470d0a1a0a" OR size LESS 8000)
  message(FATAL_ERROR "plot.png is no picture: ${size} bytes, beginning with ${begin}")
endif()

file(READ "${SOURCE_DIR}/examples/plot_run.py" script)
string(REGEX REPLACE "^\"\"\"[^\n]*\n" "" script "${script}")
file(READ "${SOURCE_DIR}/docs/results.md" page)
string(FIND "${page}" "${script}" place)
if(place EQUAL -1)
  message(FATAL_ERROR "docs/results.md does not show examples/plot_run.py as it is")
endif()
