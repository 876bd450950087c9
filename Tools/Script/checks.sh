# shellcheck shell=bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
# For ./tetmarch: checks that take longer than the tests, or need other builds.

readonly FUZZ_PACKAGES=(clang libclang-rt-14-dev)
readonly COVERAGE_PACKAGES=(gcovr)

# The least share of lines that unit tests reach, in percent, in each folder that knows no GL.
readonly LEAST_COVERAGE=90
COVERED_FOLDERS=()
while read -r floor room _; do
  if [[ "$floor" == [1-8] ]]; then COVERED_FOLDERS+=("VTKModule/$room"); fi
done <"$ROOT/VTKModule/floors.txt"
readonly COVERED_FOLDERS
readonly COVERING_PROGRAMS=(TetMarchUnitTests TetMarchProcessesTest TetMarchToolsUnitTest) # that need no GL

# stress [OPTION]... | stress lattices [RAYS]: options are those of the hard cases, and mean these alone.
stress() {
  prepare_machine
  configure "$BUILD" -DBUILD_TESTING=ON
  if [[ "${1:-}" == lattices ]]; then
    stress_lattices "${@:2}"
    return
  fi
  build tetmarch-hard-cases
  "$BUILD/bin/tetmarch-hard-cases" stress --file "$BUILD/stress.json" --table "$BUILD/stress.md" "$@"
  (($# > 0)) || stress_lattices
}

stress_lattices() {
  local rays="${1:-100000000}"
  [[ "$rays" =~ ^[1-9][0-9]*$ ]] || die "stress lattices takes a number of rays, not $rays"
  build TetMarchUnitTests
  TETMARCH_RAYS="$rays" "$BUILD/bin/TetMarchUnitTests" --gtest_filter='StructuredTraversal.*'
}

hard_cases() {
  prepare_machine
  install_packages "${CHART_PACKAGES[@]}"
  configure "$BUILD" -DBUILD_TESTING=ON
  build tetmarch-hard-cases
  build tetmarch-draw-hard-case
  [[ -f "$BUILD/stress.json" ]] || die "there are no rays to show yet: run ./tetmarch stress first"
  "$SYSTEM_PYTHON" "$ROOT/Testing/HardCases/make_page.py" --build "$BUILD" "$@"
}

# configure_instrumented BUILD_FOLDER CMAKE_OPTION...
configure_instrumented() {
  configure "$@" -DBUILD_TESTING=ON -DTETMARCH_WRAP_PYTHON=OFF
}

# fuzz [SECONDS] | fuzz files [COUNT]: without arguments both.
fuzz() {
  if [[ "${1:-}" == files ]]; then
    fuzz_files "${@:2}"
    return
  fi
  fuzz_grids "$@"
  (($# > 0)) || fuzz_files
}

# fuzz_files [COUNT]: of each kind of file
fuzz_files() {
  local count="${1:-200}" window=()
  [[ "$count" =~ ^[1-9][0-9]*$ ]] || die "fuzz files takes a number of files of each kind, not $count"
  prepare_machine
  configure "$BUILD" -DBUILD_TESTING=ON
  build TetMarchTryFiles
  build tetmarch-render
  # One file in twenty is opened in the window, where it is built.
  if ninja -C "$BUILD" -t targets all | grep '^TetMarchTryWindow: phony' >/dev/null; then
    build TetMarchTryWindow
    window=(--window "$BUILD/bin/TetMarchTryWindow" --opened "$((2 * count))")
  fi
  with_x_server "$SYSTEM_PYTHON" "$ROOT/Testing/Fuzz/Files/fuzz_files.py" --driver "$BUILD/bin/TetMarchTryFiles" \
    --render "$BUILD/bin/tetmarch-render" --each "$count" --drawn "$((2 * count))" --keep "$BUILD/fuzz/files" \
    "${window[@]}"
}

fuzz_grids() {
  local seconds="${1:-600}" folder="$BUILD/fuzz" corpus="$BUILD/fuzz/corpus" finds="$BUILD/fuzz/finds" status=0
  [[ "$seconds" =~ ^[0-9]+$ ]] || die "fuzz takes a number of seconds, not $seconds"
  prepare_machine
  install_packages "${FUZZ_PACKAGES[@]}"
  require_tools clang++
  configure_instrumented "$folder" -DTETMARCH_FUZZ=ON -DTETMARCH_BUILD_TOOLS=OFF \
    -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++
  cmake --build "$folder" --target TetMarchFuzz
  mkdir -p "$corpus" "$finds"
  cp "$ROOT"/Testing/Fuzz/Corpus/* "$ROOT"/Testing/Fuzz/Regressions/* "$corpus"
  say "fuzzing for $seconds seconds; the log is $folder/fuzz.log"
  "$folder/bin/TetMarchFuzz" "-max_total_time=$seconds" "-artifact_prefix=$finds/" -max_len=4096 -timeout=20 \
    -rss_limit_mb=3000 -print_final_stats=1 "$corpus" >"$folder/fuzz.log" 2>&1 || status=1
  sed -n 's/^stat::\([a-z_]*\): *\([0-9]*\)$/\1: \2/p' "$folder/fuzz.log"
  ((status == 0)) || die "something was found: $(sed -n 's/.*Test unit written to //p' "$folder/fuzz.log" | tail -n 1);" \
    "mend it, then keep that file in Testing/Fuzz/Regressions"
}

sanitize() {
  local folder="$BUILD/sanitize"
  prepare_machine
  configure_instrumented "$folder" -DTETMARCH_SANITIZE=ON
  cmake --build "$folder"
  rm -f "$folder/test-results.xml"
  # What Mesa and VTK keep to the end of a process is no leak of ours.
  LSAN_OPTIONS="suppressions=$ROOT/Testing/leaks-of-others.txt:print_suppressions=0" \
    run_ctest "$folder" -E '^Package'
}

coverage() {
  local folder="$BUILD/coverage" counts="$BUILD/coverage/counts.json" part program status=0
  prepare_machine
  install_packages "${COVERAGE_PACKAGES[@]}"
  require_tools gcovr
  configure_instrumented "$folder" -DTETMARCH_COVERAGE=ON
  cmake --build "$folder" --target "${COVERING_PROGRAMS[@]}"
  find "$folder" -name '*.gcda' -delete
  for program in "${COVERING_PROGRAMS[@]}"; do
    "$folder/bin/$program" --gtest_brief=1 || die "tests of $program failed"
  done
  gcovr --root "$ROOT" --filter "$ROOT/VTKModule/" --filter "$ROOT/Shaders/" --json "$counts" "$folder"
  gcovr --root "$ROOT" --add-tracefile "$counts"
  for part in "${COVERED_FOLDERS[@]}" Shaders; do
    say "$part: $(gcovr --root "$ROOT" --add-tracefile "$counts" --filter "$ROOT/$part/" | grep '^TOTAL')"
  done
  for part in "${COVERED_FOLDERS[@]}"; do
    gcovr --root "$ROOT" --add-tracefile "$counts" --filter "$ROOT/$part/" \
      --fail-under-line "$LEAST_COVERAGE" >/dev/null || status=1
  done
  return "$status"
}
