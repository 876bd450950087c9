# TetMarch as a project of its own: find VTK, build and wrap the module, the tools and the tests, install.
include(GNUInstallDirs)
option(BUILD_TESTING "Build the tests" OFF)
include(CTest)
include("${PROJECT_SOURCE_DIR}/VTKModule/CompileOptions.cmake")
include("${PROJECT_SOURCE_DIR}/VTKModule/Instrumentation.cmake")

option(BUILD_SHARED_LIBS "Build shared libraries" ON)
option(TETMARCH_WRAP_PYTHON "Build the Python package vtktetmarch" ON)
option(TETMARCH_BUILD_TOOLS "Build the programs tetmarch-render and tetmarch-view" ON)
option(TETMARCH_WHEEL "Put all that a Python wheel has into the folder vtktetmarch of the build" OFF)

if (NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "The type of build" FORCE)
endif ()
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
if (TETMARCH_WHEEL)
  include("${PROJECT_SOURCE_DIR}/VTKModule/WheelLayout.cmake")
else ()
  # Debian's Python looks below lib/, not below the multi-architecture folder.
  set(tetmarch_python_dir "lib/python3/dist-packages")
  file(RELATIVE_PATH tetmarch_lib_from_python "/${tetmarch_python_dir}/vtktetmarch" "/${CMAKE_INSTALL_LIBDIR}")
  set(CMAKE_INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}" "$ORIGIN/${tetmarch_lib_from_python}")
  set(tetmarch_library_version VERSION "${PROJECT_VERSION}" SOVERSION 1)
endif ()
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")

set(tetmarch_vtk_components
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonSystem CommonTransforms FiltersCore FiltersGeometry
  FiltersHyperTree IOExport ParallelCore RenderingAnnotation RenderingCore RenderingFreeType RenderingOpenGL2
  RenderingVolume RenderingVolumeOpenGL2 jsoncpp vtksys zlib)
list(JOIN tetmarch_vtk_components " " tetmarch_library_components) # those that other projects need
if (TETMARCH_WRAP_PYTHON)
  list(APPEND tetmarch_vtk_components Python WrappingPythonCore)
  find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
endif ()
find_package(VTK 9.1 REQUIRED COMPONENTS ${tetmarch_vtk_components}
  OPTIONAL_COMPONENTS
    ChartsCore FiltersCellGrid FiltersGeneral FiltersSources FiltersHybrid GUISupportQt ImagingCore
    InteractionStyle InteractionWidgets IOCGNSReader IOExodus IOImage IOLegacy IOParallel IOXML
    RenderingContextOpenGL2 TestingRendering ViewsContext2D)

vtk_module_scan(
  MODULE_FILES "${PROJECT_SOURCE_DIR}/vtk.module"
  REQUEST_MODULES VTK::RenderingTetMarch
  PROVIDES_MODULES tetmarch_modules
  ENABLE_TESTS OFF)

# vtk_module_build enters CMAKE_SOURCE_DIR/<folder of vtk.module>. With vtk.module in the top folder that is
# this very project again, under the name of its folder, unless the source root is said to be one level up.
set(tetmarch_real_source_dir "${CMAKE_SOURCE_DIR}")
get_filename_component(CMAKE_SOURCE_DIR "${PROJECT_SOURCE_DIR}" DIRECTORY)
vtk_module_build(
  MODULES ${tetmarch_modules}
  PACKAGE TetMarch
  INSTALL_EXPORT TetMarch
  LIBRARY_NAME_SUFFIX "${VTK_VERSION_MAJOR}.${VTK_VERSION_MINOR}"
  ${tetmarch_library_version}
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/tetmarch"
  CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/TetMarch")

if (TETMARCH_WRAP_PYTHON)
  vtk_module_wrap_python(
    MODULES ${tetmarch_modules}
    PYTHON_PACKAGE vtktetmarch
    MODULE_DESTINATION "${tetmarch_python_dir}"
    INSTALL_HEADERS OFF
    TARGET TetMarch::Python
    BUILD_STATIC OFF)
  set(tetmarch_package "${CMAKE_BINARY_DIR}/${tetmarch_python_dir}/vtktetmarch")
  file(GLOB tetmarch_python_files CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}/VTKModule/Python"
    "${PROJECT_SOURCE_DIR}/VTKModule/Python/*.py" "${PROJECT_SOURCE_DIR}/VTKModule/Python/*.pyi"
    "${PROJECT_SOURCE_DIR}/VTKModule/Python/py.typed")
  list(REMOVE_ITEM tetmarch_python_files make_stubs.py)
  foreach (file IN LISTS tetmarch_python_files)
    configure_file("VTKModule/Python/${file}" "${tetmarch_package}/${file}" COPYONLY)
    install(FILES "VTKModule/Python/${file}"
      DESTINATION "${tetmarch_python_dir}/vtktetmarch"
      COMPONENT python)
  endforeach ()
  configure_file(VTKModule/Python/built_for.py.in "${tetmarch_package}/built_for.py" @ONLY)
  install(FILES "${tetmarch_package}/built_for.py"
    DESTINATION "${tetmarch_python_dir}/vtktetmarch"
    COMPONENT python)
  configure_file(Tools/Common/ColorMaps.json "${tetmarch_package}/color_maps.json" COPYONLY)
  install(FILES Tools/Common/ColorMaps.json
    RENAME color_maps.json
    DESTINATION "${tetmarch_python_dir}/vtktetmarch"
    COMPONENT python)
  if (NOT CMAKE_CROSSCOMPILING AND NOT TETMARCH_SANITIZE AND NOT TETMARCH_FUZZ) # where Python can load the module
    add_custom_command(TARGET vtkRenderingTetMarchPython POST_BUILD
      COMMAND "${CMAKE_COMMAND}" -E env PYTHONDONTWRITEBYTECODE=1 "${Python3_EXECUTABLE}"
        "${PROJECT_SOURCE_DIR}/VTKModule/Python/make_stubs.py"
        "${tetmarch_package}" "${tetmarch_package}/vtkRenderingTetMarch.pyi"
      VERBATIM)
    install(FILES "${tetmarch_package}/vtkRenderingTetMarch.pyi"
      DESTINATION "${tetmarch_python_dir}/vtktetmarch"
      COMPONENT python)
  endif ()
endif ()
set(CMAKE_SOURCE_DIR "${tetmarch_real_source_dir}")

include(VTKModule/Package.cmake)
if (TETMARCH_BUILD_TOOLS)
  add_subdirectory(Tools)
endif ()
include(VTKModule/DebianPackages.cmake)
if (BUILD_TESTING)
  add_subdirectory(Testing)
endif ()
