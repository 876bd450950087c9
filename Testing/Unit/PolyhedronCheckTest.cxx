// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whatever the arrays of faces hold: as GridCheckTest.cxx.
#include "BrokenGrids.h"

#include "vtkIdTypeArray.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// A tetrahedron and a polyhedron of 6 faces, whose stream begins at 0: the number of faces, then
// five values a face.
RawGrid polyhedron()
{
  RawGrid raw = gridOf({ Tet, { VTK_POLYHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } } });
  raw.HasFaces = true;
  raw.FaceLocations = { -1, 0 };
  raw.Faces = { 6, 4, 0, 4, 7, 3, 4, 1, 2, 6, 5, 4, 0, 1, 5, 4, 4, 3, 7, 6, 2, 4, 0, 3, 2, 1, 4, 4,
    5, 6, 7 };
  return raw;
}

TEST(PolyhedronCheck, SoundOnesPass) { expectSound(polyhedron(), 7); }

TEST(PolyhedronCheck, FacesOrTheirLocationsMissing)
{
  RawGrid raw = polyhedron();
  raw.HasFaces = false;
  expectError(raw, { "polyhedron 1", "no faces" });
  raw = polyhedron();
  raw.FaceLocations.pop_back();
  expectError(raw, { "face locations", "1 values", "polyhedron 1" });
  raw.FaceLocations.clear();
  expectError(raw, { "face locations", "0 values", "polyhedron 1" });
  raw = polyhedron();
  raw.Faces.clear();
  expectError(raw, { "face locations", "polyhedron 1", "at 0", "0 values" });
  const Grid grid = polyhedron().grid();
  grid->SetCells(grid->GetCellTypesArray(), grid->GetCells(), nullptr, grid->GetFaces());
  expectError(grid, { "polyhedron 1", "no face locations" });
}

TEST(PolyhedronCheck, FaceLocationsOutOfRange)
{
  for (const vtkIdType wrong : { vtkIdType(-1), vtkIdType(31), VTK_ID_MAX, VTK_ID_MIN })
  {
    RawGrid raw = polyhedron();
    raw.FaceLocations[1] = wrong;
    expectError(
      raw, { "face locations", "polyhedron 1", "at " + std::to_string(wrong), "31 values" });
  }
}

TEST(PolyhedronCheck, NumbersOfFaces)
{
  for (const vtkIdType wrong :
    { vtkIdType(0), vtkIdType(-1), vtkIdType(8), VTK_ID_MAX, VTK_ID_MIN })
  {
    RawGrid raw = polyhedron();
    raw.Faces[0] = wrong;
    expectError(raw, { "faces give polyhedron 1 " + std::to_string(wrong) + " faces", "at least 1",
                       "room for 7" });
  }
  RawGrid raw = polyhedron();
  raw.Faces[0] = 7; // one more than there are
  expectError(raw, { "face 6 of polyhedron 1", "0 points" });
}

TEST(PolyhedronCheck, NumbersOfPointsOfFaces)
{
  for (const vtkIdType wrong :
    { vtkIdType(2), vtkIdType(0), vtkIdType(-4), VTK_ID_MAX, VTK_ID_MIN })
  {
    RawGrid raw = polyhedron();
    raw.Faces[6] = wrong;
    expectError(raw, { "face 1 of polyhedron 1", std::to_string(wrong) + " points", "at least 3" });
  }
}

TEST(PolyhedronCheck, FacesThatAreCutShort)
{
  const RawGrid whole = polyhedron();
  for (std::size_t size = 0; size < whole.Faces.size(); ++size)
  {
    RawGrid raw = whole;
    raw.Faces.resize(size);
    expectError(raw, { "polyhedron 1", "faces" });
  }
}

TEST(PolyhedronCheck, FacesThatNamePointsBeyondThePoints)
{
  for (const vtkIdType wrong : { vtkIdType(8), vtkIdType(-1), VTK_ID_MAX })
  {
    RawGrid raw = polyhedron();
    raw.Faces[8] = wrong;
    expectError(
      raw, { "faces of polyhedron 1", "point " + std::to_string(wrong), "face 1", "8 points" });
  }
}

TEST(PolyhedronCheck, PolyhedraThatShareTheirFaces)
{
  RawGrid raw = polyhedron();
  const Ids corners{ 0, 1, 2, 3, 4, 5, 6, 7 };
  raw.Types.push_back(VTK_POLYHEDRON);
  raw.Connectivity.insert(raw.Connectivity.end(), corners.begin(), corners.end());
  raw.Offsets.push_back(static_cast<vtkIdType>(raw.Connectivity.size()));
  raw.FaceLocations.push_back(0);
  expectError(raw, { "face locations", "cell 2", "62 values", "31" });
}
} // namespace
