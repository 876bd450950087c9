# Compile options of our own code, shared by the module, the tools, the plugin and the tests.
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
