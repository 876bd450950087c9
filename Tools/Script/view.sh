# shellcheck shell=bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
# For ./tetmarch: the interactive window.

# Qt's widgets, and VTK's widget of Qt.
readonly VIEW_PACKAGES=(libvtk9-qt-dev qtbase5-dev)

# view [FILE]
view() {
  (($# <= 1)) || die "view takes one file, not $*"
  if [[ -z "${DISPLAY:-}${WAYLAND_DISPLAY:-}${QT_QPA_PLATFORM:-}" ]]; then
    die "there is no display for a window. ./tetmarch demo and build/bin/tetmarch-render draw without one;" \
      "ssh -X shows the window of another machine; xvfb-run -a ./tetmarch view runs it on an invisible display"
  fi
  prepare_machine
  install_packages "${VIEW_PACKAGES[@]}"
  configure "$BUILD"
  build tetmarch-view
  "$BUILD/bin/tetmarch-view" "$@"
}
