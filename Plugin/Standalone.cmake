# TetMarch as a ParaView plugin: the module is compiled against ParaView's own VTK, beside the representations
# that show it. Nothing of this build may meet the VTK of the system in one process.
include(GNUInstallDirs)
option(BUILD_TESTING "Build the tests" OFF)
include(CTest)
include("${PROJECT_SOURCE_DIR}/VTKModule/CompileOptions.cmake")

option(BUILD_SHARED_LIBS "Build shared libraries" ON)

if (NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "The type of build" FORCE)
endif ()
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME plugin)

# Naming components keeps Qt out.
find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingCore RemotingServerManager RemotingViews)

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")

paraview_plugin_scan(
  PLUGIN_FILES "${PROJECT_SOURCE_DIR}/Plugin/paraview.plugin"
  PROVIDES_PLUGINS tetmarch_plugins
  ENABLE_BY_DEFAULT ON
  HIDE_PLUGINS_FROM_CACHE ON)
paraview_plugin_build(
  PLUGINS ${tetmarch_plugins}
  INSTALL_HEADERS OFF
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}"
  PLUGINS_FILE_NAME "tetmarch.xml"
  AUTOLOAD ${tetmarch_plugins}
  PLUGINS_COMPONENT plugin
  TARGET_COMPONENT plugin)
include(Plugin/DebianPackage.cmake)

if (CMAKE_SYSTEM_NAME STREQUAL "Linux")
  add_subdirectory(Plugin/Expat)
endif ()

if (BUILD_TESTING)
  add_subdirectory(Testing/Plugin)
endif ()
