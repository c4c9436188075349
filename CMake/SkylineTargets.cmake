# SPDX-License-Identifier: BSD-3-Clause
# What every target of Skyline has in common, in one place.

# skyline_compile_options(<target>): warnings, and no symbol interposition (a library's own calls
# stay inlinable, which the kernels need).
function (skyline_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  target_compile_options(${target} PRIVATE
    $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wshadow -fno-semantic-interposition>
    $<$<AND:$<BOOL:${SKYLINE_WERROR}>,$<COMPILE_LANGUAGE:CXX>>:-Werror>)
endfunction ()

# skyline_pkg_config(<package>): the library of Debian's pkg-config file as PkgConfig::<package>.
macro (skyline_pkg_config package)
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(${package} REQUIRED IMPORTED_TARGET ${package})
endmacro ()
