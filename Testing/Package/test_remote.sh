#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
# TetMarch in VTK's Remote/: configures VTK with this module and what it depends on, then compiles the module's
# own files. They need no library of VTK's, which would take an hour to build.
# usage: test_remote.sh TETMARCH_SOURCE VTK_SOURCE WORK_FOLDER
set -euo pipefail

tetmarch="$1" vtk="$2" source="$3/vtk" build="$3/build"

# A tree of links stands for VTK's, so that VTK's own stays as it is. TetMarch itself is copied: VTK's search
# for modules doesn't follow links to folders.
make_source() {
  rm -rf "$source"
  mkdir -p "$source"
  cp -as "$vtk"/. "$source"
  mkdir -p "$source/Remote/TetMarch"
  cp -r "$tetmarch"/{CMakeLists.txt,vtk.module,VTKModule,Shaders} "$source/Remote/TetMarch"
}

configure() {
  cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DVTK_GROUP_ENABLE_Rendering=DONT_WANT -DVTK_GROUP_ENABLE_StandAlone=DONT_WANT \
    -DVTK_MODULE_ENABLE_VTK_RenderingTetMarch=YES
}

compile() {
  local command
  cd "$build"
  while read -r command; do
    bash -c "$command"
    printf '.'
  done < <(ninja -t commands RenderingTetMarch | grep 'Remote/TetMarch/.*\( -P \| -c \)')
  printf '\n%d objects of TetMarch compiled\n' "$(find Remote/TetMarch -name '*.o' | wc -l)"
}

make_source
configure
compile
