# shellcheck shell=bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
# For ./tetmarch: installing, and Debian packages.

readonly PACKAGES_FOLDER="$BUILD/packages"
readonly PACKAGE_PACKAGES=(dpkg-dev file)

# package [test | test-wheel]
package() {
  case "$*" in
    "") make_packages ;;
    test) make_packages && test_packages ;;
    test-wheel) test_wheels ;;
    *) die "package takes nothing, test or test-wheel, not $*" ;;
  esac
}

# make_packages_of BUILD_FOLDER
make_packages_of() {
  (cd "$1" && cpack -G DEB -B "$PACKAGES_FOLDER" >"$1/cpack.log" 2>&1) ||
    { cat "$1/cpack.log" >&2; die "CPack failed, see above"; }
}

# All that is installed, without the tests.
build_for_others() {
  prepare_machine
  install_packages "${VIEW_PACKAGES[@]}"
  configure "$BUILD" -DBUILD_TESTING=OFF
  build all
}

# The plugin's is for the ParaView of Debian 12.
make_packages() {
  build_for_others
  install_packages "${PACKAGE_PACKAGES[@]}"
  rm -f "$PACKAGES_FOLDER"/*.deb
  make_packages_of "$BUILD"
  if on_debian bookworm; then
    build_plugin
    make_packages_of "$PARAVIEW_BUILD"
  else
    say "the ParaView plugin gets no package: that is made on Debian 12 only"
  fi
  say "to install them: apt-get install $PACKAGES_FOLDER/*.deb"
}

# install --prefix FOLDER
install_build() {
  local lists
  [[ "${1:-}" == --prefix && -n "${2:-}" && $# == 2 ]] || die "install wants --prefix FOLDER"
  build_for_others
  cmake --install "$BUILD" --prefix "$2" >"$BUILD/install.log" || die "see $BUILD/install.log"
  say "installed to $2; Python finds it with PYTHONPATH=$2/lib/python3/dist-packages"
  if [[ ! -r "$(plugin_file)" ]]; then
    say "the ParaView plugin was left out, since it isn't built: ./tetmarch paraview builds it"
    return
  fi
  cmake --install "$PARAVIEW_BUILD" --prefix "$2" >>"$BUILD/install.log" || die "see $BUILD/install.log"
  lists=("$2"/lib/paraview-*/plugins/tetmarch.xml)
  say "ParaView loads the plugin with PV_PLUGIN_CONFIG_FILE=${lists[0]}"
}
