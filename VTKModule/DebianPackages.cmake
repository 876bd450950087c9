# Debian packages by CPack: `./tetmarch package` makes them, `./tetmarch package test` tries them in a clean root.
# The plugin's is made by its own build: Plugin/DebianPackage.cmake.
include("${PROJECT_SOURCE_DIR}/VTKModule/DebianSettings.cmake")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")

set(tetmarch_same "libtetmarch1 (= ${PROJECT_VERSION})")
# llvmpipe draws where there is no GPU.
tetmarch_package(runtime libtetmarch1 "libgl1-mesa-dri"
  "The library: mappers of VTK for unstructured grids, images and rectilinear grids.")
tetmarch_package(development libtetmarch-dev "${tetmarch_same}, libvtk9-dev"
  "Headers, and what find_package(TetMarch) reads.")
if (TETMARCH_WRAP_PYTHON)
  tetmarch_package(python python3-tetmarch "${tetmarch_same}, python3, python3-vtk9, python3-numpy"
    "The Python package vtktetmarch.")
endif ()
if (TARGET tetmarch-render)
  tetmarch_package(tools tetmarch "${tetmarch_same}, libegl1" "tetmarch-render draws a volume into a PNG file.")
endif ()
if (TARGET tetmarch-view)
  tetmarch_package(view tetmarch-view "${tetmarch_same}" "tetmarch-view shows a volume in a window.")
endif ()
include(CPack)
