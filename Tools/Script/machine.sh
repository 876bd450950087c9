# shellcheck shell=bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
# For ./tetmarch: what a machine needs, building and testing.

# libgl1-mesa-dri is llvmpipe, the driver of a machine without GPU.
readonly PACKAGES=(cmake ninja-build g++ libvtk9-dev python3-vtk9 nlohmann-json3-dev
  libegl-dev libegl1 libgl1-mesa-dri libgtest-dev libbenchmark-dev glslang-tools xvfb)
readonly OSMESA_PACKAGES=(libosmesa6-dev) # which forky's Mesa has no more
readonly CHART_PACKAGES=(python3-numpy python3-matplotlib)
# For tests of the Python package: of the wheel, of notebooks, and of data in memory.
readonly PYTHON_PACKAGES=(python3-venv python3-nbclient python3-ipykernel python3-ipywidgets python3-xarray
  python3-meshio)
# For tests of web pages: browsers, what checks and runs their scripts, and what compares their pictures.
readonly WEB_PACKAGES=(chromium chromium-driver firefox-esr nodejs node-typescript python3-numpy python3-pil)
# For tests with several processes, whose pieces METIS makes.
readonly PROCESS_PACKAGES=(openmpi-bin python3-mpi4py metis)
# Mesa's compiler for AMD's GPUs, which needs no GPU; 60 MB.
readonly GPU_COMPILE_PACKAGES=(mesa-vulkan-drivers libvulkan-dev)

say() { printf 'tetmarch: %s\n' "$*"; }
die() { printf 'tetmarch: error: %s\n' "$*" >&2; exit 1; }

in_ci() { [[ "${CI:-}" == true ]]; }

# on_debian CODENAME: Debian 12 is bookworm.
on_debian() { grep -qx 'ID=debian' /etc/os-release && grep -qx "VERSION_CODENAME=$1" /etc/os-release; } 2>/dev/null

missing_packages() {
  local package
  for package in "$@"; do
    [[ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" == installed ]] || echo "$package"
  done
}

as_root() { if ((EUID == 0)); then "$@"; else sudo "$@"; fi; }

# apt_get as_root|in_forky ARGUMENT...
apt_get() {
  "$1" env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o Acquire::Retries=3 \
    -o DPkg::Lock::Timeout=300 "${@:2}" </dev/null || die "failed: apt-get ${*:2}"
}

install_packages() {
  if ! on_debian bookworm && ! on_debian forky; then
    say "this isn't Debian 12, so nothing is installed; wanted are what these packages hold: $*"
    return
  fi
  local missing
  mapfile -t missing < <(missing_packages "$@")
  ((${#missing[@]})) || return 0
  command -v apt-get >/dev/null || die "apt-get is missing; install by other means: ${missing[*]}"
  ((EUID == 0)) || command -v sudo >/dev/null ||
    die "neither root nor sudo here; let an administrator run: apt-get install ${missing[*]}"
  say "installing ${missing[*]}"
  apt_get as_root update
  apt_get as_root install --no-install-recommends "${missing[@]}"
}

require_tools() {
  local tool
  for tool in "$@"; do
    command -v "$tool" >/dev/null || die "$tool is missing; install it and run this again"
  done
}

# A compiler cache, where there is one, knows a file again in any clone.
use_compiler_cache() {
  command -v ccache >/dev/null || return 0
  export CMAKE_C_COMPILER_LAUNCHER="${CMAKE_C_COMPILER_LAUNCHER-ccache}"
  export CMAKE_CXX_COMPILER_LAUNCHER="${CMAKE_CXX_COMPILER_LAUNCHER-ccache}"
  export CCACHE_BASEDIR="${CCACHE_BASEDIR-$ROOT}" CCACHE_NOHASHDIR=1
  export CCACHE_SLOPPINESS="${CCACHE_SLOPPINESS-pch_defines,time_macros}" # for precompiled headers
  export CCACHE_INODECACHE=1 # a precompiled header has 100 MB, which each object would read again
}

prepare_machine() {
  local packages=("${PACKAGES[@]}")
  if in_ci; then packages+=(ccache); fi
  on_debian forky || packages+=("${OSMESA_PACKAGES[@]}")
  install_packages "${packages[@]}"
  require_tools cmake ninja c++
  use_compiler_cache
}

# configure BUILD_FOLDER CMAKE_OPTION...
configure() { configure_from "$ROOT" "$@"; }

# configure_from SOURCES BUILD_FOLDER CMAKE_OPTION...
configure_from() {
  local sources="$1" folder="$2" warnings=OFF
  shift 2
  if in_ci; then warnings=ON; fi
  mkdir -p "$folder"
  cmake -S "$sources" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release "-DPython3_EXECUTABLE=$SYSTEM_PYTHON" \
    "-DTETMARCH_WARNINGS_AS_ERRORS=$warnings" "$@" >"$folder/configure.log" 2>&1 ||
    { cat "$folder/configure.log" >&2; die "CMake couldn't configure the build, see above"; }
}

build() {
  ninja -C "$BUILD" -t targets all | grep "^$1: phony" >/dev/null ||
    die "this build has no $1; $BUILD/configure.log may say why"
  cmake --build "$BUILD" --target "$1" || die "the build failed, see above"
}

# VTK 9.1's own windows need an X server. `xvfb-run -a` may race for the display's number, -displayfd can't.
with_x_server() (
  require_tools Xvfb
  exec {pipe}< <(exec Xvfb -displayfd 3 -screen 0 1280x1024x24 -noreset -nolisten tcp 3>&1 >/dev/null 2>&1)
  server=$!
  trap 'kill "$server" 2>/dev/null' EXIT
  read -r display <&"$pipe" || die "Xvfb didn't start"
  DISPLAY=":$display" "$@"
)

# run_ctest BUILD_FOLDER CTEST_OPTION... A test may take two hours: on two idle cores the longest takes a few minutes.
run_ctest() {
  local folder="$1"
  shift
  with_x_server ctest --test-dir "$folder" --output-on-failure --no-tests=error -j2 --timeout 7200 \
    --output-junit "$folder/test-results.xml" "$@"
}

# junit_number ATTRIBUTE FILE: a number that the file's <testsuite> states.
junit_number() { sed -n "s/^[[:space:]]*$1=\"\([0-9]*\)\".*/\1/p" "$2" | head -n 1; }

# print_totals RESULT_FILE...: a file that wasn't written counts as one failure.
print_totals() {
  local file total=0 failed=0 skipped=0
  for file in "$@"; do
    if [[ -r "$file" ]]; then
      total=$((total + $(junit_number tests "$file")))
      failed=$((failed + $(junit_number failures "$file")))
      skipped=$((skipped + $(junit_number skipped "$file")))
    else
      total=$((total + 1))
      failed=$((failed + 1))
    fi
  done
  echo "$((total - failed - skipped)) passed, $failed failed, $skipped skipped"
}
