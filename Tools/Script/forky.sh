# shellcheck shell=bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
# For ./tetmarch: a root with Debian forky, which has a newer VTK, Mesa and compiler.

readonly FORKY_ROOT="$BUILD/forky-root"
readonly FORKY_BUILD="$BUILD/forky"
readonly FORKY_SOURCES=/usr/src/tetmarch
readonly ROOT_PACKAGES=(debootstrap util-linux)
readonly PYVISTA_PACKAGES=(python3-pyvista) # which Debian 12 has not

# The mirror that this machine's apt has its own release from.
debian_mirror() {
  local release
  release="$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)"
  apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Origin: Debian' "Codename: $release" | head -n 1
}

# Runs a command in forky's root, where the sources are $FORKY_SOURCES, read-only, and $FORKY_BUILD is their build
# folder. The mounts are in a namespace of its own and gone with the last process in it, however that ends.
in_forky() {
  mkdir -p "$FORKY_BUILD" "$FORKY_ROOT$FORKY_SOURCES"
  unshare --mount bash -euc '
    mount -t proc proc "$1/proc"
    mount --rbind /sys "$1/sys"
    mount --rbind /dev "$1/dev"
    mount --bind "$2" "$1$3"
    mount -o remount,bind,ro "$1$3"
    mount --bind "$4" "$1$3/build"
    exec chroot "$1" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 CI=true \
      http_proxy="${http_proxy:-}" https_proxy="${https_proxy:-}" "${@:5}"' \
    in_forky "$FORKY_ROOT" "$ROOT" "$FORKY_SOURCES" "$FORKY_BUILD" "$@"
}

# make_root CODENAME FOLDER: a root of Debian with nothing but the least packages, in place of what is there.
make_root() {
  local mirror
  install_packages "${ROOT_PACKAGES[@]}"
  require_tools debootstrap unshare apt-get apt-config
  mirror="$(debian_mirror)"
  [[ -n "$mirror" ]] || die "apt knows no mirror of Debian to take $1 from; see /etc/apt and run apt-get update"
  say "making $2 of $1 from $mirror"
  rm -rf --one-file-system "$2"
  mkdir -p "$BUILD"
  # Debian 12's debootstrap has no script for forky, which is made as unstable is.
  unshare --mount debootstrap --variant=minbase "$1" "$2" "$mirror" sid >"$BUILD/debootstrap.log" 2>&1 ||
    die "debootstrap failed: see $BUILD/debootstrap.log and $2/debootstrap/debootstrap.log; it needs the network and" \
      "what a container may lack, to mount and to make device files"
  # A proxy, for instance, or a mirror that stands still.
  apt-config dump | grep -E '^Acquire::(http|https|Check-Date|Check-Valid-Until)\b' \
    >"$2/etc/apt/apt.conf.d/machine" || true
}

# A root with packages that was begun and not finished is begun again.
make_forky_root() {
  local finished="$FORKY_ROOT/finished"
  [[ ! -e "$finished" ]] || return 0
  make_root forky "$FORKY_ROOT"
  apt_get in_forky update
  apt_get in_forky install --no-install-recommends "${PACKAGES[@]}" "${CHART_PACKAGES[@]}" \
    "${GPU_COMPILE_PACKAGES[@]}" "${PYVISTA_PACKAGES[@]}"
  touch "$finished"
}
