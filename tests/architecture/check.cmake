# The order of the house, checked on the sources below SOURCE_DIR:
#  - a room (folder of retiarius/) includes only from itself and from rooms above it in the list of
#    retiarius/CMakeLists.txt, always by the path "retiarius/room/file.hpp";
#  - the library neither prints nor exits;
#  - no C++ file has more than 500 lines;
#  - no two headers define types of the same name in the same namespace: the linker would take one's
#    functions for both, without a word.
# Every violation is listed; one is enough to fail.
cmake_minimum_required(VERSION 3.25)
set(longest 500)

file(READ "${SOURCE_DIR}/retiarius/CMakeLists.txt" list_file)
if(NOT list_file MATCHES "foreach\\(room ([a-z ]+)\\)")
  message(FATAL_ERROR "retiarius/CMakeLists.txt has no line foreach(room ...) that lists the rooms")
endif()
string(REPLACE " " ";" rooms "${CMAKE_MATCH_1}")
set(violations "")

function(violation text)
  set(violations ${violations} "${text}" PARENT_SCOPE)
endfunction()

# Includes of one file in `room`.
function(check_includes file room)
  list(FIND rooms "${room}" own)
  if(own EQUAL -1)
    violation("${file}: room ${room} is not in the list of retiarius/CMakeLists.txt")
  endif()
  file(STRINGS "${SOURCE_DIR}/${file}" lines REGEX "^[ \t]*#[ \t]*include[ \t]*\"")
  foreach(line IN LISTS lines)
    string(REGEX MATCH "\"([^\"]*)\"" ignored "${line}")
    set(included "${CMAKE_MATCH_1}")
    if(NOT included MATCHES "^retiarius/([a-z_]+)/")
      violation("${file}: \"${included}\" is not of the form \"retiarius/room/file.hpp\"")
    else()
      set(other "${CMAKE_MATCH_1}")
      list(FIND rooms "${other}" place)
      if(place EQUAL -1)
        violation("${file}: includes from ${other}, which is no room")
      elseif(place GREATER own)
        violation("${file}: ${room} includes from ${other}, which is below it")
      endif()
    endif()
  endforeach()
  set(violations "${violations}" PARENT_SCOPE)
endfunction()

function(check_silence file)
  file(STRINGS "${SOURCE_DIR}/${file}" lines
       REGEX "^[ \t]*#[ \t]*include[ \t]*<iostream>|std::cout|std::cerr|std::exit|std::abort|std::printf|[^a-z_:]printf\\(|stdout|fmt::print\\(\"|stderr")
  foreach(line IN LISTS lines)
    string(STRIP "${line}" line)
    if(NOT line MATCHES "^//")
      violation("${file}: the library neither prints nor exits: ${line}")
    endif()
  endforeach()
  set(violations "${violations}" PARENT_SCOPE)
endfunction()

function(check_length file)
  file(READ "${SOURCE_DIR}/${file}" text)
  string(REGEX MATCHALL "\n" ends "${text}")
  list(LENGTH ends length)
  if(length GREATER longest)
    violation("${file}: ${length} lines, ${longest} at most")
  endif()
  set(violations "${violations}" PARENT_SCOPE)
endfunction()

# Types that a header defines in the namespace that it opens first.
function(check_types file)
  file(STRINGS "${SOURCE_DIR}/${file}" lines
       REGEX "^namespace [a-z0-9_:]+ {|^(struct|class|enum class|enum) [A-Za-z0-9_]+ [^;]*{")
  set(space "")
  foreach(line IN LISTS lines)
    if(line MATCHES "^namespace ([a-z0-9_:]+) {")
      if(space STREQUAL "")
        set(space "${CMAKE_MATCH_1}")
      endif()
    elseif(line MATCHES "^(struct|class|enum class|enum) ([A-Za-z0-9_]+) ")
      set(type "${space}::${CMAKE_MATCH_2}")
      if(DEFINED "home_of_${type}")
        violation("${file}: ${type} is defined in ${home_of_${type}} too")
      endif()
      set("home_of_${type}" "${file}" PARENT_SCOPE)
    endif()
  endforeach()
  set(violations "${violations}" PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE library RELATIVE "${SOURCE_DIR}"
     "${SOURCE_DIR}/retiarius/*.hpp" "${SOURCE_DIR}/retiarius/*.cpp")
file(GLOB_RECURSE others RELATIVE "${SOURCE_DIR}"
     "${SOURCE_DIR}/program/*.[ch]pp" "${SOURCE_DIR}/tests/*.[ch]pp"
     "${SOURCE_DIR}/verification/*.[ch]pp" "${SOURCE_DIR}/benchmarks/*.[ch]pp"
     "${SOURCE_DIR}/fuzz/*.[ch]pp")
if(NOT library)
  message(FATAL_ERROR "no sources below ${SOURCE_DIR}/retiarius")
endif()
foreach(file IN LISTS library)
  string(REGEX REPLACE "^retiarius/([^/]+)/.*" "\\1" room "${file}")
  check_includes("${file}" "${room}")
  check_silence("${file}")
  check_length("${file}")
endforeach()
foreach(file IN LISTS others)
  check_length("${file}")
endforeach()
foreach(file IN LISTS library others)
  if(file MATCHES "\\.hpp$" AND NOT file MATCHES "^tests/")
    check_types("${file}")
  endif()
endforeach()

if(violations)
  list(JOIN violations "\n" text)
  message(FATAL_ERROR "The order of the house is broken:\n${text}")
endif()
