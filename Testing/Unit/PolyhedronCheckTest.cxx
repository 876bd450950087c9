// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Polyhedra without faces, or with arrays of faces that don't fit, are errors (see
// GridCheckTest.cxx).
#include "BrokenGrids.h"

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

TEST(PolyhedronCheck, SoundOnesPass) { expectSound(tetAndPolyhedron(), 7); }

TEST(PolyhedronCheck, FacesOrTheirLocationsMissing)
{
  RawGrid raw = tetAndPolyhedron();
  raw.HasFaces = false;
  expectError(raw, { "polyhedron 1", "no faces" });
  const Grid grid = tetAndPolyhedron().grid();
  setCells(grid, cellTypesOf(grid), grid->GetCells(), nullptr, facesOf(grid));
  expectError(grid, { "polyhedron 1", "no face locations" });
}
} // namespace
