# shellcheck shell=bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
# For ./tetmarch: what a GPU's compiler makes of the shaders.

# gpu-compile [OPTION]...: options are those of gpu_compile.py.
gpu_compile() {
  prepare_machine
  install_packages "${GPU_COMPILE_PACKAGES[@]}"
  require_tools glslangValidator
  configure "$BUILD" -DBUILD_TESTING=ON
  build tetmarch-gpu-shaders
  build tetmarch-gpu-statistics
  "$SYSTEM_PYTHON" -B "$ROOT/Testing/GpuCompile/gpu_compile.py" "$BUILD" --markdown "$BUILD/gpu-compile.md" "$@"
}
