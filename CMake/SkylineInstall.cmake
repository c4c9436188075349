# SPDX-License-Identifier: BSD-3-Clause
# For find_package(Skyline): installs the config file beside the targets that vtk_module_build
# exports.
include(CMakePackageConfigHelpers)

set(config "${CMAKE_BINARY_DIR}/${skyline_cmake_destination}/SkylineConfig")
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/SkylineConfig.cmake.in" "${config}.cmake"
  INSTALL_DESTINATION "${skyline_cmake_destination}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${config}Version.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${config}.cmake" "${config}Version.cmake"
  DESTINATION "${skyline_cmake_destination}")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")

# The last of all rules: it lists what the others have installed.
install(CODE "set(SKYLINE_CMAKE_DESTINATION \"${skyline_cmake_destination}\")")
install(SCRIPT "${CMAKE_CURRENT_LIST_DIR}/WriteUninstall.cmake")
