# shellcheck shell=bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
# For ./tetmarch: whether tests notice faults.

# mutants [OPTION]... [NAME-PATTERN]...: options are those of mutants.py. The build folder lies in the copy as that of the
# sources does in them, so that a compiler cache has both alike.
mutants() {
  local folder="$BUILD/mutants" program=("$SYSTEM_PYTHON" -B "$ROOT/Testing/Mutants/mutants.py")
  if [[ " $* " == *" --list "* ]]; then
    "${program[@]}" "$folder" "$@"
    return
  fi
  export CCACHE_BASEDIR="$folder/tree"
  prepare_machine
  install_packages "${PROCESS_PACKAGES[@]}"
  "${program[@]}" "$folder" --copy
  configure_from "$folder/tree" "$folder/tree/build" -DBUILD_TESTING=ON
  "${program[@]}" "$folder" "$@"
}
