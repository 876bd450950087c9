# Compile options of our own code, shared by the module, the tools, the plugin and the tests.

# Headers that most files include: a target that precompiles them takes a third less time to compile. Each file still
# includes what it uses; CMAKE_DISABLE_PRECOMPILE_HEADERS shows where one doesn't. The list has no header of a VTK module
# with an object factory, whose macros differ from target to target.
set(tetmarch_common_headers <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory> <string>
  <vector> <vtkCellArray.h> <vtkCellData.h> <vtkDataArray.h> <vtkImageData.h> <vtkNew.h> <vtkPointData.h>
  <vtkPoints.h> <vtkSmartPointer.h> <vtkUnstructuredGrid.h>)

option(TETMARCH_WARNINGS_AS_ERRORS "Treat compiler warnings in TetMarch's own code as errors" OFF)

function (tetmarch_compile_options target)
  target_compile_features("${target}" PUBLIC cxx_std_17)
  if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    # No product may be fused with a sum behind our back: the traversal decides itself where an fma stands.
    target_compile_options("${target}" PRIVATE -Wall -Wextra -Wshadow -Wundef -ffp-contract=off
      # Clang's means long double, too.
      $<$<CXX_COMPILER_ID:GNU>:-Wdouble-promotion>
      $<$<BOOL:${TETMARCH_WARNINGS_AS_ERRORS}>:-Werror>)
  endif ()
endfunction ()
