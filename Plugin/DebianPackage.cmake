# The plugin's Debian package, for the ParaView of the same Debian. ParaView's programs read PROGRAM_FOLDER/paraview.conf
# at their start: each line names a list of plugins, from that folder. Debian's packages of ParaView bring no such
# file. Other ParaViews have their own, so this one goes into the package alone.
include("${PROJECT_SOURCE_DIR}/VTKModule/DebianSettings.cmake")
file(RELATIVE_PATH tetmarch_plugin_list
  "/${CMAKE_INSTALL_BINDIR}" "/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/tetmarch.xml")
file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/paraview.conf" CONTENT "${tetmarch_plugin_list}\n" @ONLY)
install(FILES "${CMAKE_BINARY_DIR}/paraview.conf"
  DESTINATION "${CMAKE_INSTALL_BINDIR}"
  COMPONENT plugin
  EXCLUDE_FROM_ALL)

set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS
  "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/${PARAVIEW_PLUGIN_SUBDIR}/TetMarch")
# A plugin is for one minor version of ParaView.
set(tetmarch_version "${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}")
math(EXPR tetmarch_next_minor "${ParaView_VERSION_MINOR} + 1")
tetmarch_package(plugin tetmarch-paraview-plugin
  "paraview (>= ${tetmarch_version}), paraview (<< ${ParaView_VERSION_MAJOR}.${tetmarch_next_minor}~), libgl1-mesa-dri"
  "The representation Tet Marching for ParaView ${tetmarch_version}, which loads it by itself.")
set(CPACK_DEBIAN_PLUGIN_PACKAGE_RECOMMENDS python3-paraview)
include(CPack)
