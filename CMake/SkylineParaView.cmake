# SPDX-License-Identifier: BSD-3-Clause
# For SKYLINE_PARAVIEW: finds ParaView, and makes find_package(VTK) find its VTK. ParaView_DIR is
# the place of ParaView; Utilities/install-paraview fetches one. See Documentation/paraview.md.
find_package(ParaView 5.11 QUIET COMPONENTS RemotingCore RemotingServerManager RemotingViews
  VTKExtensionsFiltersRendering WrapClientServer ProcessXML)
if (NOT ParaView_FOUND)
  message(FATAL_ERROR "SKYLINE_PARAVIEW: no ParaView 5.11 or later with headers in ParaView_DIR "
    "'${ParaView_DIR}' (${ParaView_NOT_FOUND_MESSAGE}). Use ./bootstrap paraview, which fetches "
    "Debian's ParaView and builds everything.")
endif ()
if (ParaView_VERSION VERSION_GREATER_EQUAL 5.14)
  message(WARNING "SKYLINE_PARAVIEW: tested with ParaView 5.11 and 5.13, not with ${ParaView_VERSION}")
endif ()
# Only ParaView's own VTK may be used. The VTK of the system must not be mixed with it.
set(VTK_DIR "${ParaView_DIR}/vtk" CACHE PATH "ParaView's VTK" FORCE)
set(skyline_paraview_module_files "${CMAKE_CURRENT_SOURCE_DIR}/Plugins/ParaView/vtk.module")

# Builds the plugin from the modules that exist already, and adds its tests.
macro (skyline_build_paraview_plugin)
  paraview_plugin_scan(
    PLUGIN_FILES "${CMAKE_CURRENT_SOURCE_DIR}/Plugins/ParaView/plugin/paraview.plugin"
    PROVIDES_PLUGINS skyline_plugins
    ENABLE_BY_DEFAULT ON
    HIDE_PLUGINS_FROM_CACHE ON)
  paraview_plugin_build(
    PLUGINS ${skyline_plugins}
    PLUGINS_FILE_NAME "skyline.plugins.xml"
    AUTOLOAD ${skyline_plugins})
  if (BUILD_TESTING)
    enable_testing()
    add_subdirectory(Testing/Plugins)
  endif ()
endmacro ()
