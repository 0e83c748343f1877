# Writes HEADER with the git description of SOURCE_DIR, empty where that is no git checkout of its
# own; touches the file only when it changes.
cmake_minimum_required(VERSION 3.25)
set(revision "")
find_program(git git)
if(git)
  execute_process(COMMAND "${git}" rev-parse --show-toplevel
                  WORKING_DIRECTORY "${SOURCE_DIR}" OUTPUT_VARIABLE top
                  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  file(REAL_PATH "${SOURCE_DIR}" source)
  # A source tree unpacked inside another repository must not report that one's revision.
  if(top STREQUAL source)
    execute_process(COMMAND "${git}" describe --always --dirty --tags
                    WORKING_DIRECTORY "${SOURCE_DIR}" OUTPUT_VARIABLE revision
                    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  endif()
endif()
file(CONFIGURE OUTPUT "${HEADER}" @ONLY
     CONTENT "#pragma once\ninline constexpr char kRetiariusRevision[] = \"@revision@\";\n")
