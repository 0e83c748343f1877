# What the library tells about its own build (retiarius/base/build_info.hpp). All but the revision
# is known when CMake configures; the revision is looked up at every build, so that it is right
# after a commit too.
set(RETIARIUS_BUILD_INFO_DIR "${PROJECT_BINARY_DIR}/generated")

add_custom_target(retiarius_revision
  COMMAND ${CMAKE_COMMAND} -D "SOURCE_DIR=${PROJECT_SOURCE_DIR}"
          -D "HEADER=${RETIARIUS_BUILD_INFO_DIR}/retiarius_revision.hpp"
          -P "${PROJECT_SOURCE_DIR}/cmake/revision.cmake"
  BYPRODUCTS "${RETIARIUS_BUILD_INFO_DIR}/retiarius_revision.hpp"
  COMMENT "Looking up the revision"
  VERBATIM)

if(RETIARIUS_NATIVE)
  set(RETIARIUS_KERNELS native)
else()
  set(RETIARIUS_KERNELS portable)
endif()
set(libraries
  Eigen "${Eigen3_VERSION}" fmt "${fmt_VERSION}" oneTBB "${TBB_VERSION}" METIS "${METIS_VERSION}"
  toml++ "${tomlplusplus_VERSION}" nlohmann-json "${nlohmann_json_VERSION}"
  HDF5 "${hdf5_VERSION}" zlib "${ZLIB_VERSION_STRING}" qhull "${qhull_VERSION}" SQLite "${sqlite_VERSION}"
  tinyobjloader "${tinyobjloader_VERSION}")

# `literals` becomes the names and values as pairs of C++ string literals, separated by commas.
function(pair_literals literals)
  set(result "")
  math(EXPR last "${ARGC} - 2")
  foreach(i RANGE 1 ${last} 2)
    math(EXPR j "${i} + 1")
    set(name "${ARGV${i}}")
    set(value "${ARGV${j}}")
    string(REPLACE "\\" "\\\\" value "${value}")
    string(REPLACE "\"" "\\\"" value "${value}")
    string(APPEND result "{\"${name}\", \"${value}\"}, ")
  endforeach()
  set(${literals} "${result}" PARENT_SCOPE)
endfunction()
# The options that can change results or speed.
pair_literals(RETIARIUS_OPTION_LITERALS native "${RETIARIUS_NATIVE}" sanitize "${RETIARIUS_SANITIZE}"
              flags "${CMAKE_CXX_FLAGS}")
pair_literals(RETIARIUS_LIBRARY_LITERALS ${libraries})
configure_file("${PROJECT_SOURCE_DIR}/retiarius/base/build_info.cpp.in"
               "${RETIARIUS_BUILD_INFO_DIR}/build_info.cpp" @ONLY)
