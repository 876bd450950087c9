# Builds for finding errors: all of our own code is instrumented, VTK stays as it is. ./tetmarch sanitize, fuzz
# and coverage make them.
option(TETMARCH_SANITIZE "Stop at memory errors and undefined behaviour (ASan, UBSan)" OFF)
option(TETMARCH_FUZZ "Build the fuzzer, with the same; needs Clang and its libFuzzer" OFF)
option(TETMARCH_COVERAGE "Count how often each line runs, for gcov" OFF)

if (TETMARCH_SANITIZE OR TETMARCH_FUZZ)
  # What type an object has (vptr) can't be checked of VTK's, whose type information may be hidden.
  add_compile_options(-g -O1 -fno-omit-frame-pointer
    -fsanitize=address,undefined,float-cast-overflow -fno-sanitize=vptr -fno-sanitize-recover=all)
  add_link_options(-fsanitize=address,undefined)
endif ()
if (TETMARCH_FUZZ)
  if (NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    message(FATAL_ERROR "TETMARCH_FUZZ needs Clang: configure with -DCMAKE_CXX_COMPILER=clang++")
  endif ()
  add_compile_options(-fsanitize=fuzzer-no-link)
endif ()
if (TETMARCH_COVERAGE)
  # Threads count together.
  add_compile_options(-Og --coverage -fprofile-update=atomic)
  add_link_options(--coverage)
endif ()
