# shellcheck shell=bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
# For ./tetmarch package test: a clean root of Debian, in which the packages are tried.

readonly CLEAN_ROOT="$BUILD/clean-root"

# Runs a command in the clean root, whose mounts are gone with the last process in it.
in_clean_root() {
  unshare --mount bash -euc '
    mount -t proc proc "$1/proc"
    mount --rbind /dev "$1/dev"
    exec chroot "$1" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
      DEBIAN_FRONTEND=noninteractive http_proxy="${http_proxy:-}" https_proxy="${https_proxy:-}" "${@:2}"' \
    in_clean_root "$CLEAN_ROOT" "$@"
}

# make_clean_root CODENAME
make_clean_root() {
  make_root "$1" "$CLEAN_ROOT"
  if on_debian "$1"; then
    : >"$CLEAN_ROOT/etc/apt/sources.list" # as on this machine, instead
    cp /etc/apt/sources.list "$CLEAN_ROOT/etc/apt/" 2>/dev/null || true
    cp -r /etc/apt/sources.list.d/. "$CLEAN_ROOT/etc/apt/sources.list.d/" 2>/dev/null || true
  fi
  in_clean_root apt-get -q update >>"$BUILD/debootstrap.log"
}

# install_in_clean_root PACKAGE_OR_FILE...: with what they depend on, and nothing that is only recommended.
install_in_clean_root() {
  in_clean_root bash -euc 'cd /try/packages; apt-get -q -y install --no-install-recommends "$@"' - "$@" \
    >>"$BUILD/package-install.log" 2>&1 ||
    { tail -20 "$BUILD/package-install.log" >&2; die "can't be installed: $*"; }
}

# The README's example of Python, between its fences.
python_of_the_readme() { sed -n '/^```python$/,/^```$/p' "$ROOT/README.md" | sed '1d;$d'; }

# Every file that no package of Debian brought, but for what apt, dpkg, ldconfig and users keep.
files_of_the_root() {
  (cd "$CLEAN_ROOT" && find . -xdev \( -path ./proc -o -path ./dev -o -path ./sys -o -path ./var -o -path ./tmp -o \
    -path ./run -o -path ./try -o -path ./root -o -path ./etc/ld.so.cache -o -name __pycache__ \) \
    -prune -o -type f -print | sort)
}

try_programs() {
  local picture
  in_clean_root bash -euc 'cd /try; tetmarch-render Data/golfball_small.vtu --size 200x150 --output tool.png;
    tetmarch-render Data/bonsai_small.vti --size 200x150 --output image.png; xvfb-run -a python3 example.py;
    tetmarch-view --help >/dev/null; xvfb-run -a python3 try_window.py tetmarch-view Data/bonsai_small.vti' ||
    die "what is installed doesn't draw"
  for picture in tool.png image.png golfball.png; do
    [[ "$(head -c 4 "$CLEAN_ROOT/try/$picture" | tail -c 3)" == PNG ]] || die "$picture is no picture"
  done
}

# The plugin with nothing but ParaView: its batch program and its window. ParaView's Python isn't to be had beside
# VTK's, so apt takes the latter away, and with it the Python package.
try_plugin() {
  install_in_clean_root python3-paraview
  in_clean_root bash -euc 'cd /try; export TETMARCH_TRIED=/try/batch.txt; xvfb-run -a pvbatch try_plugin.py
    export TETMARCH_TRIED=/try/window.txt
    timeout --kill-after=5 120 xvfb-run -a paraview --dr --script=/try/try_plugin.py' >"$BUILD/package-plugin.log" 2>&1 ||
    { tail -20 "$BUILD/package-plugin.log" >&2; die "ParaView doesn't draw with the plugin"; }
}

# Whatever is left then is said.
remove_packages() {
  local before after
  in_clean_root dpkg -r "$@" >>"$BUILD/package-install.log" 2>&1 || die "the packages can't be removed"
  before="$(in_clean_root bash -c 'cat /var/lib/dpkg/info/*.list' | sed 's/^/./' | sort -u)"
  after="$(files_of_the_root | comm -23 - <(echo "$before") | grep -iE 'tetmarch|paraview' || true)"
  [[ -z "$after" ]] || die "left behind: $after"
}

test_packages() {
  local names files try="$CLEAN_ROOT/try"
  on_debian bookworm || die "packages are tried on Debian 12 only"
  ((EUID == 0)) || die "package test makes a root and enters it, so it wants root: sudo ./tetmarch package test"
  make_clean_root bookworm
  mkdir -p "$try/packages" "$try/Data"
  cp "$PACKAGES_FOLDER"/*.deb "$try/packages/"
  cp "$ROOT"/Data/golfball_small.vtu "$ROOT"/Data/bonsai_small.vti "$try/Data/"
  cp "$ROOT"/Testing/Package/try_*.py "$try/"
  python_of_the_readme >"$try/example.py"
  mapfile -t names < <(for file in "$try"/packages/*.deb; do dpkg-deb -f "$file" Package; done)
  mapfile -t files < <(cd "$try/packages" && printf './%s\n' *.deb)
  : >"$BUILD/package-install.log"
  install_in_clean_root xvfb xauth x11-apps "${files[@]}"
  say "installed: ${names[*]}"
  try_programs
  try_plugin
  remove_packages "${names[@]}"
  rm -rf --one-file-system "$CLEAN_ROOT"
  say "the packages were installed in a clean root, draw, and leave nothing behind"
}
