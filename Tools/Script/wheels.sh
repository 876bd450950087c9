# shellcheck shell=bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
# For ./tetmarch package test-wheel: what the README tells users of Python, in clean roots.

readonly WHEEL_LOG="$BUILD/wheel.log"

# The commands with which the README's section on Python begins, typed in the folder of the sources.
commands_for_python() { sed -n '/^## Python$/,/^builds /s/^    //p' "$ROOT/README.md"; }

# in_wheel_root COMMAND: with a display, in the folder of the sources.
in_wheel_root() {
  # LLVM 21 of forky makes wrong code of some shaders for AVX2, see Testing/README.md.
  in_clean_root env GALLIUM_OVERRIDE_CPU_CAPS=avx PIP_NO_INDEX=1 bash -euc "cd /try/tetmarch; $1" </dev/null >>"$WHEEL_LOG" 2>&1 ||
    { tail -20 "$WHEEL_LOG" >&2; die "failed in the clean root: $1"; }
}

# try_wheel CODENAME
try_wheel() {
  local sources="$CLEAN_ROOT/try/tetmarch" command start left
  make_clean_root "$1"
  : >"$WHEEL_LOG"
  mkdir -p "$sources"
  (cd "$ROOT" && git ls-files -z | tar -c --null -T -) | tar -x -C "$sources"
  python_of_the_readme >"$sources/example.py"
  echo 'APT::Get::Assume-Yes "true"; APT::Install-Recommends "false";' >"$CLEAN_ROOT/etc/apt/apt.conf.d/try"
  in_wheel_root "apt-get install xvfb xauth"
  while read -r command; do
    start=$SECONDS
    in_wheel_root "xvfb-run -a $command"
    say "$1: $((SECONDS - start)) s: $command"
  done < <(commands_for_python)
  in_wheel_root "cd /try; tetmarch/env/bin/tetmarch-render tetmarch/Data/bonsai_small.vti --size 200x150 --output tool.png"
  for command in "$sources/golfball.png" "$CLEAN_ROOT/try/tool.png"; do
    [[ "$(head -c 4 "$command" | tail -c 3)" == PNG ]] || die "$command is no picture"
  done
  say "$1: the wheel has $(sed -n 's/.*filename=vtktetmarch.*size=\([0-9]*\).*/\1/p' "$WHEEL_LOG") bytes"
  in_wheel_root "apt-get install python3-nbclient python3-ipykernel python3-ipywidgets
    env/bin/python -m ipykernel install --sys-prefix
    xvfb-run -a env/bin/python -B Testing/Python/NotebookTest.py 2>&1 | tee /dev/stderr | grep -x OK" # not skipped
  if [[ "$1" == forky ]]; then # Debian 12 has no PyVista
    in_wheel_root "apt-get install python3-pyvista"
    in_wheel_root "xvfb-run -a env/bin/python -c 'import pyvista; pyvista.OFF_SCREEN = True
picture = pyvista.Wavelet().tetmarch.plot(window_size=(160, 120), screenshot=True, return_img=True)
assert picture.std() > 5'"
  fi
  in_wheel_root "env/bin/pip uninstall --yes vtktetmarch"
  left="$(find "$sources/env" -iname '*tetmarch*')"
  [[ -z "$left" ]] || die "left behind: $left"
  rm -rf --one-file-system "$CLEAN_ROOT"
}

test_wheels() {
  on_debian bookworm || die "wheels are tried on Debian 12 only"
  ((EUID == 0)) || die "package test-wheel makes roots and enters them, so it wants root: sudo ./tetmarch package test-wheel"
  require_tools git
  try_wheel bookworm
  try_wheel forky
  say "what the README tells users of Python works in clean roots of Debian 12 and forky"
}
