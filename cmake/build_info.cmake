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

# The options that can change results or speed.
set(options "native=${RETIARIUS_NATIVE}" "sanitize=${RETIARIUS_SANITIZE}")
string(STRIP "${CMAKE_CXX_FLAGS}" flags)
if(flags)
  list(APPEND options "flags=${flags}")
endif()
set(libraries
  "Eigen ${Eigen3_VERSION}" "fmt ${fmt_VERSION}" "oneTBB ${TBB_VERSION}" "METIS ${METIS_VERSION}"
  "toml++ ${tomlplusplus_VERSION}" "nlohmann-json ${nlohmann_json_VERSION}" "HDF5 ${hdf5_VERSION}"
  "qhull ${qhull_VERSION}" "tinyobjloader ${tinyobjloader_VERSION}")

# `quoted` becomes the items of `list_name` as C++ string literals, separated by commas.
function(quote_items list_name quoted)
  set(literals "")
  foreach(item IN LISTS ${list_name})
    string(REPLACE "\\" "\\\\" item "${item}")
    string(REPLACE "\"" "\\\"" item "${item}")
    string(APPEND literals "\"${item}\", ")
  endforeach()
  set(${quoted} "${literals}" PARENT_SCOPE)
endfunction()
quote_items(options RETIARIUS_OPTION_LITERALS)
quote_items(libraries RETIARIUS_LIBRARY_LITERALS)
configure_file("${PROJECT_SOURCE_DIR}/retiarius/base/build_info.cpp.in"
               "${RETIARIUS_BUILD_INFO_DIR}/build_info.cpp" @ONLY)
