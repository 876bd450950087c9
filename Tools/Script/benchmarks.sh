# shellcheck shell=bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
# For ./tetmarch: times, errors and pictures beside those of other mappers and other commits.

bench() {
  prepare_machine
  install_packages "${CHART_PACKAGES[@]}"
  configure "$BUILD" -DBUILD_TESTING=ON
  [[ "${1:-}" == against ]] || build tetmarch-bench
  case "${1:-}" in
    accuracy | effects | structured | grids | growth | interaction | light | pixels | web | against) "bench_$1" "${@:2}" ;;
    *) "$BUILD/bin/tetmarch-bench" "$@" ;;
  esac
}

bench_accuracy() {
  local folder="$BUILD/accuracy"
  mkdir -p "$folder"
  "$BUILD/bin/tetmarch-bench" refinement --output "$folder/refinement.json" --markdown "$folder/refinement.md"
  "$BUILD/bin/tetmarch-bench" accuracy --output "$folder/accuracy.json" --markdown "$folder/accuracy.md" "$@"
  "$SYSTEM_PYTHON" "$ROOT/Testing/Benchmark/make_accuracy_page.py" \
    "$folder/accuracy.json" "$folder/refinement.json" "$folder"
}

bench_effects() {
  local folder="$BUILD/effects" against=()
  mkdir -p "$folder"
  "$BUILD/bin/tetmarch-bench" effects --output "$folder/effects.json" --markdown "$folder/effects.md" "$@"
  if [[ -f "$BUILD/against/against.json" ]]; then against=(--against "$BUILD/against/against.json"); fi
  "$SYSTEM_PYTHON" "$ROOT/Testing/Benchmark/make_effects_page.py" "$folder/effects.json" "$folder" "${against[@]}"
}

bench_structured() {
  local folder="$BUILD/structured"
  mkdir -p "$folder"
  "$BUILD/bin/tetmarch-bench" structured --output "$folder/structured.json" --markdown "$folder/structured.md" "$@"
  "$SYSTEM_PYTHON" "$ROOT/Testing/Benchmark/make_structured_page.py" "$folder/structured.json" "$folder"
}

# How the time of a frame grows with the mesh. The largest, of 40 million tetrahedra, is drawn by this mapper alone.
bench_growth() {
  local folder="$BUILD/growth"
  mkdir -p "$folder"
  "$BUILD/bin/tetmarch-bench" --datasets lattice:12,lattice:26,lattice:55,lattice:119 --rounds 1 \
    --output "$folder/growth.json" --markdown "$folder/growth-frames.md" "$@"
  "$BUILD/bin/tetmarch-bench" --datasets lattice:188 --mappers tetmarch --rounds 1 --limit 600 \
    --output "$folder/largest.json" --markdown "$folder/largest.md" "$@"
  "$SYSTEM_PYTHON" "$ROOT/Testing/Benchmark/growth_chart.py" "$folder" "$folder/growth.json" "$folder/largest.json"
}

# What the CPU does for a frame, without the GL; the number of cubes along an edge of the lattices, and that of frames.
bench_interaction() {
  build tetmarch-interaction
  "$BUILD/bin/tetmarch-interaction" "$@"
}

# Pictures with fewer rays beside those with a ray for each pixel.
bench_pixels() {
  build vtkRenderingTetMarchPython
  PYTHONPATH="$BUILD/lib/python3/dist-packages" "$SYSTEM_PYTHON" "$ROOT/Testing/Python/with_display.py" \
    "$SYSTEM_PYTHON" "$ROOT/Testing/Benchmark/measure_pixels.py" "$BUILD/pixels" "$@"
}

# Curvilinear grids (with the options), an adaptive mesh and curved cells beside other ways to draw them.
bench_grids() {
  local kind
  build vtkRenderingTetMarchPython
  for kind in grids leaves curved; do
    PYTHONPATH="$BUILD/lib/python3/dist-packages" "$SYSTEM_PYTHON" "$ROOT/Testing/Python/with_display.py" \
      "$SYSTEM_PYTHON" "$ROOT/Testing/Benchmark/measure_$kind.py" "$BUILD/grids" "$@"
    set --
  done
}

# Accuracy and time of light. With --picture FILE, only the picture of its page is drawn.
bench_light() {
  local folder="$BUILD/light" here="$ROOT/Testing/Benchmark"
  build vtkRenderingTetMarchPython
  PYTHONPATH="$BUILD/lib/python3/dist-packages" "$SYSTEM_PYTHON" "$ROOT/Testing/Python/with_display.py" \
    "$SYSTEM_PYTHON" "$here/measure_light.py" "$folder" "$@"
  [[ " $* " == *" --picture "* ]] || "$SYSTEM_PYTHON" "$here/make_light_page.py" "$folder/light.json" "$folder"
}

# Pages in a browser beside the mapper and vtk.js, all without a GPU.
bench_web() {
  local here="$ROOT/Testing/Benchmark"
  install_packages "${WEB_PACKAGES[@]}"
  build vtkRenderingTetMarchPython
  LIBGL_ALWAYS_SOFTWARE=1 PYTHONPATH="$BUILD/lib/python3/dist-packages" "$SYSTEM_PYTHON" \
    "$ROOT/Testing/Python/with_display.py" "$SYSTEM_PYTHON" "$here/measure_web.py" "$BUILD/web" "$@"
}

# bench_against COMMIT [OPTION]...: the times, then the pictures, whose differences are an error. The other commit is
# configured and built by its own script, but for the Python package, by which both are drawn.
bench_against() {
  local commit folder="$BUILD/against" other compare="$ROOT/Testing/Benchmark/compare_pictures.py"
  commit="$(git -C "$ROOT" rev-parse --verify --short "${1:-}^{commit}")" || die "bench against takes a commit"
  other="$folder/$commit/build"
  if [[ ! -x "$folder/$commit/tetmarch" ]]; then
    mkdir -p "$folder/$commit"
    git -C "$ROOT" archive "$commit" | tar -x -C "$folder/$commit"
  fi
  { "$folder/$commit/tetmarch" bench --help && cmake --build "$other" --target vtkRenderingTetMarchPython; } \
    >"$folder/build.log" 2>&1 || die "$commit couldn't be built, see $folder/build.log"
  build vtkRenderingTetMarchPython
  build tetmarch-variants
  "$SYSTEM_PYTHON" "$ROOT/Testing/Benchmark/compare_times.py" "$BUILD" "$other" --output "$folder/against.json" "${@:2}"
  "$SYSTEM_PYTHON" "$compare" draw "$BUILD" "$folder/these.npz" --check
  "$SYSTEM_PYTHON" "$compare" draw "$other" "$folder/others.npz" --variants "$BUILD/bin/tetmarch-variants"
  "$SYSTEM_PYTHON" "$compare" compare "$folder/others.npz" "$folder/these.npz"
}
