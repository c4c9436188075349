# SPDX-License-Identifier: BSD-3-Clause
# What all targets of Skyline have in common.

# skyline_compile_options(<target>): warnings, and no symbol interposition, so that a library can
# inline its own functions, which the kernels need.
function (skyline_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  target_compile_options(${target} PRIVATE
    $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wshadow -fno-semantic-interposition>
    $<$<AND:$<BOOL:${SKYLINE_WERROR}>,$<COMPILE_LANGUAGE:CXX>>:-Werror>)
endfunction ()

# skyline_pkg_config(<package>): makes the target PkgConfig::<package> from a pkg-config file.
macro (skyline_pkg_config package)
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(${package} REQUIRED IMPORTED_TARGET ${package})
endmacro ()
