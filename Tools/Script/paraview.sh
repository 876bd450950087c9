# shellcheck shell=bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
# For ./tetmarch: ParaView 5.11 and the plugin for it.

readonly PARAVIEW_ROOT="$BUILD/paraview-root"
readonly PARAVIEW_BUILD="$BUILD/paraview"
# Debian's ParaView draws no icon in its toolbars without libqt5svg5, which it doesn't ask for. The last three are for
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

prepare_paraview() {
  on_debian bookworm || die "only Debian 12's ParaView is prepared here; elsewhere configure with" \
    "-DTETMARCH_PARAVIEW_PLUGIN=ON -DParaView_DIR=..."
  install_packages "${PARAVIEW_PACKAGES[@]}"
  unpack_paraview
}

# name_paraview_command PLUGIN [FILE]: sets PARAVIEW_COMMAND to the words of the command. ParaView 5.11 loads nothing by
# --plugins=PATH, without a word: it wants the folder and the name. A file after --plugins it takes for a plugin. What
# is loaded before its libraries lets it read appended data with any libexpat: Plugin/README.md.
name_paraview_command() {
  local folder libraries
  folder="$(dirname "$1")"
  libraries="$(echo "$PARAVIEW_ROOT"/usr/lib/*-linux-gnu)"
  PARAVIEW_COMMAND=(env "LD_PRELOAD=$folder/libTetMarchExpat.so" "LD_LIBRARY_PATH=$libraries"
    "$PARAVIEW_ROOT/usr/bin/paraview" "${@:2}" "--plugin-search-paths=$folder" --plugins=TetMarch)
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

# start_paraview PLUGIN FILE
start_paraview() {
  [[ -r "$2" ]] || die "there is no file $2 that can be read"
  [[ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]] ||
    die "ParaView's window needs a display, and there is none: log in with ssh -X, or draw with pvbatch or tetmarch-render"
  name_paraview_command "$1" "$2"
  exec "${PARAVIEW_COMMAND[@]}"
}

# paraview [FILE]
paraview() {
  local plugins
  plugins=("$PARAVIEW_BUILD"/lib/*/plugins/TetMarch/TetMarch.so)
  if (($# > 0)) && [[ -r "${plugins[0]}" ]]; then
    start_paraview "${plugins[0]}" "$1"
  fi
  prepare_machine
  prepare_paraview
  configure "$PARAVIEW_BUILD" -DTETMARCH_PARAVIEW_PLUGIN=ON -DBUILD_TESTING=ON \
    "-DParaView_DIR=$(echo "$PARAVIEW_ROOT"/usr/lib/*/cmake/paraview-*)"
  cmake --build "$PARAVIEW_BUILD"
  rm -f "$PARAVIEW_BUILD/test-results.xml"
  run_ctest "$PARAVIEW_BUILD"
  plugins=("$PARAVIEW_BUILD"/lib/*/plugins/TetMarch/TetMarch.so)
  explain_plugin "${plugins[0]}"
  if (($# > 0)); then start_paraview "${plugins[0]}" "$1"; fi
}
