# `cmake --install`: library, headers, program, ready missions, documents, and the CMake package by
# which other projects find the library: find_package(retiarius), target retiarius::retiarius.
include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/retiarius")

install(TARGETS retiarius EXPORT retiarius ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/retiarius/"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/retiarius" FILES_MATCHING PATTERN "*.hpp")
install(EXPORT retiarius NAMESPACE retiarius:: FILE retiarius-targets.cmake
        DESTINATION "${package_dir}")

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/retiarius-config.cmake.in"
  "${PROJECT_BINARY_DIR}/retiarius-config.cmake" INSTALL_DESTINATION "${package_dir}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/retiarius-config-version.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/retiarius-config.cmake"
              "${PROJECT_BINARY_DIR}/retiarius-config-version.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/FindMETIS.cmake"
        DESTINATION "${package_dir}")

if(TARGET retiarius_program)
  install(TARGETS retiarius_program RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
endif()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/missions"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/retiarius" OPTIONAL)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/docs/" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(FILES "${PROJECT_SOURCE_DIR}/README.md" "${PROJECT_SOURCE_DIR}/CHANGELOG.md"
              "${PROJECT_SOURCE_DIR}/LICENSE"
        DESTINATION "${CMAKE_INSTALL_DOCDIR}")
