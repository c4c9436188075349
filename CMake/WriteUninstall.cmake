# SPDX-License-Identifier: BSD-3-Clause
# Run by `cmake --install` when everything else is in its place: writes the script that removes it all.
# SKYLINE_CMAKE_DESTINATION: the folder of the script, below the prefix.
set(destination "${SKYLINE_CMAKE_DESTINATION}")
set(script "${CMAKE_INSTALL_PREFIX}/${destination}/SkylineUninstall.cmake")
list(APPEND CMAKE_INSTALL_MANIFEST_FILES "${script}")
file(RELATIVE_PATH prefix_from_here "/prefix/${destination}" "/prefix")
set(files)
foreach (file IN LISTS CMAKE_INSTALL_MANIFEST_FILES)
  file(RELATIVE_PATH file "${CMAKE_INSTALL_PREFIX}" "${file}")
  string(APPEND files "\n  \"${file}\"")
endforeach ()
configure_file("${CMAKE_CURRENT_LIST_DIR}/SkylineUninstall.cmake.in" "$ENV{DESTDIR}${script}" @ONLY)
