# SPDX-License-Identifier: BSD-3-Clause
# What all targets of Skyline have in common.
set(_skyline_symbols "${CMAKE_CURRENT_LIST_DIR}/SkylineSymbols.map")

# skyline_compile_options(<target>): warnings, hidden symbols (what other libraries need is exported by
# its module's macro, SKYLINECORE_EXPORT for example), and no symbol interposition (a library's own
# calls stay inlinable, which the kernels need).
function (skyline_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  set_target_properties(${target} PROPERTIES
    C_VISIBILITY_PRESET hidden
    CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON)
  get_target_property(kind ${target} TYPE)
  if (UNIX AND NOT APPLE AND kind MATCHES "SHARED_LIBRARY|MODULE_LIBRARY")
    target_link_options(${target} PRIVATE "LINKER:--version-script=${_skyline_symbols}")
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS "${_skyline_symbols}")
  endif ()
  target_compile_options(${target} PRIVATE
    $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wshadow -fno-semantic-interposition>
    $<$<AND:$<BOOL:${SKYLINE_WERROR}>,$<COMPILE_LANGUAGE:CXX>>:-Werror>)
endfunction ()

# skyline_pkg_config(<package>): makes the target PkgConfig::<package> from a pkg-config file.
macro (skyline_pkg_config package)
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(${package} REQUIRED IMPORTED_TARGET ${package})
endmacro ()
