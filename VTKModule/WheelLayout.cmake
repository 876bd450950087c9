# The layout of a wheel: module, library and program lie in the package's folder, and find one another and VTK's
# libraries from there: beside it in a wheel of VTK, three folders further up in conda. A wheel can't hold the symbolic
# links of versioned libraries.
set(CMAKE_INSTALL_LIBDIR vtktetmarch)
set(CMAKE_INSTALL_BINDIR vtktetmarch/bin)
set(tetmarch_python_dir ".")
set(tetmarch_library_version)
set(CMAKE_BUILD_WITH_INSTALL_RPATH ON)
set(CMAKE_INSTALL_RPATH "$ORIGIN" "$ORIGIN/.." "$ORIGIN/../vtkmodules" "$ORIGIN/../../vtkmodules" "$ORIGIN/../../.."
  "$ORIGIN/../../../..")
add_link_options(-s)
