# Writes a small tree with one violation of each kind into WORK_DIR and checks that check.cmake
# (CHECK) names every one of them, and that it accepts the tree once they are gone.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${WORK_DIR}")
file(WRITE "${WORK_DIR}/retiarius/CMakeLists.txt" "foreach(room base net solve)\nendforeach()\n")
file(WRITE "${WORK_DIR}/retiarius/net/good.hpp" "#include \"retiarius/base/vec.hpp\"\n
namespace retiarius {\nstruct Piece {\n};\nclass Knot;\n}\n")
file(WRITE "${WORK_DIR}/retiarius/solve/other.hpp"
     "namespace retiarius {\nclass Knot : public Thing {\n};\n}\n")
file(WRITE "${WORK_DIR}/program/own.hpp" "namespace retiarius::program {\nstruct Piece {\n};\n}\n")

function(run_check)
  execute_process(COMMAND ${CMAKE_COMMAND} -D "SOURCE_DIR=${WORK_DIR}" -P "${CHECK}"
                  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  set(result "${result}" PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()

run_check()
if(NOT result EQUAL 0)
  message(FATAL_ERROR "a tree in order was refused:\n${output}")
endif()

file(WRITE "${WORK_DIR}/retiarius/base/up.hpp" "#include \"retiarius/net/good.hpp\"\n")
file(WRITE "${WORK_DIR}/retiarius/net/near.cpp" "#include \"good.hpp\"\n")
file(WRITE "${WORK_DIR}/retiarius/net/loud.cpp" "void f() { std::printf(text); }\n")
file(WRITE "${WORK_DIR}/retiarius/net/quiet.cpp" "int n = std::snprintf(a, b, c);\n")
file(WRITE "${WORK_DIR}/retiarius/attic/old.hpp" "\n")
file(WRITE "${WORK_DIR}/retiarius/solve/twice.hpp"
     "namespace retiarius {\nenum class Piece { one };\n}\n")
string(REPEAT "int i;\n" 501 long)
file(WRITE "${WORK_DIR}/program/long.cpp" "${long}")
run_check()
if(result EQUAL 0)
  message(FATAL_ERROR "a tree with violations was accepted")
endif()
foreach(expected
    "base/up.hpp: base includes from net, which is below it"
    "net/near.cpp: .*is not of the form"
    "net/loud.cpp: the library neither prints nor exits"
    "attic/old.hpp: room attic is not in the list"
    "program/long.cpp: 501 lines, 500 at most"
    "solve/twice.hpp: retiarius::Piece is defined in retiarius/net/good.hpp too")
  string(REGEX REPLACE "[ \n]+" " " flat "${output}")
  if(NOT flat MATCHES "${expected}")
    message(FATAL_ERROR "no word of \"${expected}\" in:\n${output}")
  endif()
endforeach()
if(output MATCHES "quiet.cpp")
  message(FATAL_ERROR "formatting into memory was taken for printing:\n${output}")
endif()
