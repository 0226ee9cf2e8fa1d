# What `cmake --install` puts down: the library with its headers, and the package that
# find_package(Orthoball) finds.
include(CMakePackageConfigHelpers)

set(ORTHOBALL_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Orthoball)
install(TARGETS orthoball EXPORT OrthoballTargets)
install(
  DIRECTORY src/orthoball ${PROJECT_BINARY_DIR}/generated/orthoball
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING
  PATTERN "*.h")
install(
  EXPORT OrthoballTargets
  NAMESPACE Orthoball::
  DESTINATION ${ORTHOBALL_CMAKE_DIR})
configure_package_config_file(cmake/OrthoballConfig.cmake.in OrthoballConfig.cmake
                              INSTALL_DESTINATION ${ORTHOBALL_CMAKE_DIR})
write_basic_package_version_file(OrthoballConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/OrthoballConfig.cmake
              ${PROJECT_BINARY_DIR}/OrthoballConfigVersion.cmake
        DESTINATION ${ORTHOBALL_CMAKE_DIR})
install(FILES LICENSE THIRD_PARTY.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
