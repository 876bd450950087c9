# shellcheck shell=bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
# For ./tetmarch: Debian's ParaView (5.11 in Debian 12, 6.1 in forky) and the plugin for it.

readonly PARAVIEW_ROOT="$BUILD/paraview-root"
readonly PARAVIEW_BUILD="$BUILD/paraview"
# Debian 12's ParaView draws no icon in its toolbars without libqt5svg5, which it doesn't ask for. The last three are for
# the tests of its window.
readonly PARAVIEW_PACKAGES=(paraview paraview-dev openmpi-bin libqt5svg5 qtbase5-dev xdotool x11-apps)

# python3-paraview and python3-vtk9 can't both be installed, so ParaView is unpacked into a folder of its own
# and only what it depends on comes by apt.
unpack_paraview() {
  [[ -d "$PARAVIEW_ROOT" ]] && return
  local part="$PARAVIEW_ROOT.part" package
  rm -rf "$part"
  mkdir -p "$part"
  (cd "$part" && apt-get -q -o APT::Sandbox::User=root download paraview paraview-dev python3-paraview) ||
    die "failed: apt-get download paraview; run apt-get update and try again"
  for package in "$part"/*.deb; do
    dpkg -x "$package" "$part"
    rm "$package"
  done
  mv "$part" "$PARAVIEW_ROOT"
}

# In forky ParaView uses Debian's VTK and goes with its Python. Its CMake files name ParaView's modules of Python otherwise
# than the package does, and find_package(ParaView) fails where one is missing.
name_python_modules() {
  local module
  while read -r module; do
    as_root ln -sf "$(basename "$module")" "${module%.cpython-*}.so"
  done < <(find /usr/lib/python3/dist-packages/paraview -name '*.cpython-*.so')
}

prepare_paraview() {
  if on_debian bookworm; then
    install_packages "${PARAVIEW_PACKAGES[@]}"
    unpack_paraview
  elif on_debian forky; then
    install_packages paraview paraview-dev python3-paraview openmpi-bin
    name_python_modules
  else
    die "only Debian's ParaView is prepared here; elsewhere configure with" \
      "-DTETMARCH_PARAVIEW_PLUGIN=ON -DParaView_DIR=..."
  fi
}

# name_paraview_command PLUGIN [FILE]: sets PARAVIEW_COMMAND to the words of the command. ParaView 5.11 loads nothing by
# --plugins=PATH, without a word: it wants the folder and the name. A file after --plugins it takes for a plugin. What
# is loaded before its libraries lets it read appended data with any libexpat: Plugin/README.md.
name_paraview_command() {
  local folder
  folder="$(dirname "$1")"
  PARAVIEW_COMMAND=(paraview)
  if [[ -d "$PARAVIEW_ROOT" ]]; then
    PARAVIEW_COMMAND=(env "LD_PRELOAD=$folder/libTetMarchExpat.so${LD_PRELOAD:+:$LD_PRELOAD}"
      "LD_LIBRARY_PATH=$(echo "$PARAVIEW_ROOT"/usr/lib/*-linux-gnu)" "$PARAVIEW_ROOT/usr/bin/paraview")
  fi
  PARAVIEW_COMMAND+=("${@:2}" "--plugin-search-paths=$folder" --plugins=TetMarch)
}

explain_plugin() {
  local plugin="$1"
  name_paraview_command "$plugin"
  cat <<TEXT
The plugin is $plugin
To load it: in ParaView by Tools > Manage Plugins > Load New, in Python by
  paraview.simple.LoadPlugin("$plugin", remote=False)
or from the start with this ParaView, as ./tetmarch paraview FILE does (a file goes before the options):
  ${PARAVIEW_COMMAND[*]}
TEXT
}

# The plugin of this build, if there is one.
plugin_file() {
  local files=("$PARAVIEW_BUILD"/lib/*/plugins/TetMarch/TetMarch.so)
  echo "${files[0]}"
}

build_plugin() {
  local options=(-DTETMARCH_PARAVIEW_PLUGIN=ON -DBUILD_TESTING=ON)
  prepare_machine
  prepare_paraview
  if [[ -d "$PARAVIEW_ROOT" ]]; then
    options+=("-DParaView_DIR=$(echo "$PARAVIEW_ROOT"/usr/lib/*/cmake/paraview-*)")
  fi
  configure "$PARAVIEW_BUILD" "${options[@]}"
  cmake --build "$PARAVIEW_BUILD"
}

# start_paraview FILE: the plugin is built where that wasn't done before. Tests are for who asks for them.
start_paraview() {
  [[ -r "$1" ]] || die "there is no file $1 that can be read"
  [[ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]] ||
    die "ParaView's window needs a display, and there is none: log in with ssh -X, or draw with pvbatch or tetmarch-render"
  [[ -r "$(plugin_file)" ]] || build_plugin
  name_paraview_command "$(plugin_file)" "$1"
  exec "${PARAVIEW_COMMAND[@]}"
}

# paraview [FILE]
paraview() {
  (($# <= 1)) || die "paraview takes one file, not $*"
  if (($# == 1)); then
    start_paraview "$1"
  fi
  build_plugin
  rm -f "$PARAVIEW_BUILD/test-results.xml"
  run_ctest "$PARAVIEW_BUILD"
  explain_plugin "$(plugin_file)"
}
