# shellcheck shell=bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
# For ./tetmarch: Debian packages, and a clean root to try them in.

readonly PACKAGES_FOLDER="$BUILD/packages"
readonly CLEAN_ROOT="$BUILD/clean-root"
readonly PACKAGE_PACKAGES=(dpkg-dev file)

# package [test]
package() {
  case "$*" in
    "") make_packages ;;
    test) make_packages && test_packages ;;
    *) die "package takes nothing or test, not $*" ;;
  esac
}

make_packages() {
  prepare_machine
  install_packages "${VIEW_PACKAGES[@]}" "${PACKAGE_PACKAGES[@]}"
  configure "$BUILD"
  build all
  rm -f "$PACKAGES_FOLDER"/*.deb
  (cd "$BUILD" && cpack -G DEB >"$BUILD/cpack.log" 2>&1) || { cat "$BUILD/cpack.log" >&2; die "CPack failed, see above"; }
  say "to install them: apt-get install $PACKAGES_FOLDER/*.deb"
}

# Runs a command in the clean root, whose mounts are gone with the last process in it.
in_clean_root() {
  unshare --mount bash -euc '
    mount -t proc proc "$1/proc"
    mount --rbind /dev "$1/dev"
    exec chroot "$1" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
      DEBIAN_FRONTEND=noninteractive http_proxy="${http_proxy:-}" https_proxy="${https_proxy:-}" "${@:2}"' \
    in_clean_root "$CLEAN_ROOT" "$@"
}

# Every file that no package of Debian brought, but for what apt, dpkg and ldconfig keep.
files_of_the_root() {
  (cd "$CLEAN_ROOT" && find . -xdev \( -path ./proc -o -path ./dev -o -path ./sys -o -path ./var -o -path ./tmp -o \
    -path ./run -o -path ./try -o -path ./etc/ld.so.cache -o -name __pycache__ \) -prune -o -type f -print | sort)
}

make_clean_root() {
  local mirror
  install_packages debootstrap util-linux
  require_tools debootstrap unshare
  mirror="$(debian_mirror)"
  [[ -n "$mirror" ]] || die "apt knows no mirror of Debian; see /etc/apt and run apt-get update"
  rm -rf --one-file-system "$CLEAN_ROOT"
  say "making $CLEAN_ROOT from $mirror"
  unshare --mount debootstrap --variant=minbase bookworm "$CLEAN_ROOT" "$mirror" >"$BUILD/debootstrap.log" 2>&1 ||
    die "debootstrap failed, see $BUILD/debootstrap.log"
  apt-config dump | grep -E '^Acquire::(http|https|Check-Date|Check-Valid-Until)\b' \
    >"$CLEAN_ROOT/etc/apt/apt.conf.d/machine" || true
  : >"$CLEAN_ROOT/etc/apt/sources.list" # as on this machine, instead
  cp /etc/apt/sources.list "$CLEAN_ROOT/etc/apt/" 2>/dev/null || true
  cp -r /etc/apt/sources.list.d/. "$CLEAN_ROOT/etc/apt/sources.list.d/" 2>/dev/null || true
  in_clean_root apt-get -q update >>"$BUILD/debootstrap.log"
}

# The README's example of Python, between its fences.
python_of_the_readme() { sed -n '/^```python$/,/^```$/p' "$ROOT/README.md" | sed '1d;$d'; }

test_packages() {
  local names before after try="$CLEAN_ROOT/try"
  on_debian bookworm || die "packages are tried on Debian 12 only"
  ((EUID == 0)) || die "package test makes a root and enters it, so it wants root: sudo ./tetmarch package test"
  make_clean_root
  mkdir -p "$try/packages" "$try/Data"
  cp "$PACKAGES_FOLDER"/*.deb "$try/packages/"
  cp "$ROOT"/Data/golfball_small.vtu "$ROOT"/Data/bonsai_small.vti "$try/Data/"
  python_of_the_readme >"$try/example.py"
  mapfile -t names < <(for file in "$try"/packages/*.deb; do dpkg-deb -f "$file" Package; done)
  # What they depend on first, so that what is left afterwards is theirs alone.
  in_clean_root bash -euc 'cd /try/packages; apt-get -q -y install --no-install-recommends xvfb xauth ./*.deb' \
    >"$BUILD/package-install.log" 2>&1 || { tail -20 "$BUILD/package-install.log" >&2; die "the packages can't be installed"; }
  say "installed: ${names[*]}"
  in_clean_root bash -euc 'cd /try; tetmarch-render Data/golfball_small.vtu --size 200x150 --output tool.png;
    tetmarch-render Data/bonsai_small.vti --size 200x150 --output image.png; xvfb-run -a python3 example.py' ||
    die "what is installed doesn't draw"
  for picture in tool.png image.png golfball.png; do
    [[ "$(head -c 4 "$try/$picture" | tail -c 3)" == PNG ]] || die "$picture is no picture"
  done
  in_clean_root dpkg -r "${names[@]}" >>"$BUILD/package-install.log" 2>&1 || die "the packages can't be removed"
  before="$(in_clean_root bash -c 'cat /var/lib/dpkg/info/*.list' | sed 's/^/./' | sort -u)"
  after="$(files_of_the_root | comm -23 - <(echo "$before") | grep -iE 'tetmarch' || true)"
  [[ -z "$after" ]] || die "left behind: $after"
  rm -rf --one-file-system "$CLEAN_ROOT"
  say "the packages were installed in a clean root, draw, and leave nothing behind"
}

# install --prefix FOLDER
install_build() {
  [[ "${1:-}" == --prefix && -n "${2:-}" && $# == 2 ]] || die "install wants --prefix FOLDER"
  prepare_machine
  configure "$BUILD"
  build all
  cmake --install "$BUILD" --prefix "$2" >"$BUILD/install.log" || die "see $BUILD/install.log"
  say "installed to $2; Python finds it with PYTHONPATH=$2/lib/python3/dist-packages"
}
