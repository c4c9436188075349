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

# INTERIM until the rooms list their files.
function (skyline_room_files out_sources out_headers)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "SUBDIRS")
  if (NOT arg_SUBDIRS)
    set(arg_SUBDIRS .)
  endif ()
  set(sources)
  set(headers)
  foreach (dir IN LISTS arg_SUBDIRS)
    file(GLOB s RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" CONFIGURE_DEPENDS ${dir}/*.cxx)
    file(GLOB h RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" CONFIGURE_DEPENDS ${dir}/*.h)
    list(APPEND sources ${s})
    list(APPEND headers ${h})
  endforeach ()
  list(FILTER sources EXCLUDE REGEX "main.cxx")
  if (NOT sources)
    file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/empty.cxx" "")
    set(sources "${CMAKE_CURRENT_BINARY_DIR}/empty.cxx")
  endif ()
  set(${out_sources} ${sources} PARENT_SCOPE)
  set(${out_headers} ${headers} PARENT_SCOPE)
endfunction ()

function (skyline_room_classes sources_var headers_var out_classes)
  set(classes)
  foreach (header IN LISTS ${headers_var})
    string(REGEX REPLACE "\\.h$" "" name "${header}")
    if (name MATCHES "^vtk" AND "${name}.cxx" IN_LIST ${sources_var})
      list(APPEND classes ${name})
      list(REMOVE_ITEM ${sources_var} ${name}.cxx)
      list(REMOVE_ITEM ${headers_var} ${name}.h)
    endif ()
  endforeach ()
  set(${sources_var} ${${sources_var}} PARENT_SCOPE)
  set(${headers_var} ${${headers_var}} PARENT_SCOPE)
  set(${out_classes} ${classes} PARENT_SCOPE)
endfunction ()
