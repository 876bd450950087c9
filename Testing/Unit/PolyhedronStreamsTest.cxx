// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Arrays of faces as VTK has them up to 9.3: whatever they hold, nothing is read that isn't there.
#include "BrokenGrids.h"

#if TETMARCH_FACES_ARE_STREAMS

#include "vtkIdTypeArray.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

TEST(PolyhedronCheck, ArraysTooShort)
{
  RawGrid raw = tetAndPolyhedron();
  raw.Faces.Locations.pop_back();
  expectError(raw, { "face locations", "1 values", "polyhedron 1" });
  raw.Faces.Locations.clear();
  expectError(raw, { "face locations", "0 values", "polyhedron 1" });
  raw = tetAndPolyhedron();
  raw.Faces.Streams.clear();
  expectError(raw, { "face locations", "polyhedron 1", "at 0", "0 values" });
}

TEST(PolyhedronCheck, FaceLocationsOutOfRange)
{
  for (const vtkIdType wrong : { vtkIdType(-1), vtkIdType(31), VTK_ID_MAX, VTK_ID_MIN })
  {
    RawGrid raw = tetAndPolyhedron();
    raw.Faces.Locations[1] = wrong;
    expectError(
      raw, { "face locations", "polyhedron 1", "at " + std::to_string(wrong), "31 values" });
  }
}

TEST(PolyhedronCheck, NumbersOfFaces)
{
  for (const vtkIdType wrong :
    { vtkIdType(0), vtkIdType(-1), vtkIdType(8), VTK_ID_MAX, VTK_ID_MIN })
  {
    RawGrid raw = tetAndPolyhedron();
    raw.Faces.Streams[0] = wrong;
    expectError(raw, { "faces give polyhedron 1 " + std::to_string(wrong) + " faces", "at least 1",
                       "room for 7" });
  }
  RawGrid raw = tetAndPolyhedron();
  raw.Faces.Streams[0] = 7; // one more than there are
  expectError(raw, { "face 6 of polyhedron 1", "0 points" });
}

TEST(PolyhedronCheck, NumbersOfPointsOfFaces)
{
  for (const vtkIdType wrong :
    { vtkIdType(2), vtkIdType(0), vtkIdType(-4), VTK_ID_MAX, VTK_ID_MIN })
  {
    RawGrid raw = tetAndPolyhedron();
    raw.Faces.Streams[6] = wrong;
    expectError(raw, { "face 1 of polyhedron 1", std::to_string(wrong) + " points", "at least 3" });
  }
}

TEST(PolyhedronCheck, FacesThatAreCutShort)
{
  const RawGrid whole = tetAndPolyhedron();
  for (std::size_t size = 0; size < whole.Faces.Streams.size(); ++size)
  {
    RawGrid raw = whole;
    raw.Faces.Streams.resize(size);
    expectError(raw, { "polyhedron 1", "faces" });
  }
}

TEST(PolyhedronCheck, FacesThatNamePointsBeyondThePoints)
{
  for (const vtkIdType wrong : { vtkIdType(8), vtkIdType(-1), VTK_ID_MAX })
  {
    RawGrid raw = tetAndPolyhedron();
    raw.Faces.Streams[8] = wrong;
    expectError(
      raw, { "faces of polyhedron 1", "point " + std::to_string(wrong), "face 1", "8 points" });
  }
}

TEST(PolyhedronCheck, PolyhedraThatShareTheirFaces)
{
  RawGrid raw = tetAndPolyhedron();
  const Ids corners{ 0, 1, 2, 3, 4, 5, 6, 7 };
  raw.Types.push_back(VTK_POLYHEDRON);
  raw.Connectivity.insert(raw.Connectivity.end(), corners.begin(), corners.end());
  raw.Offsets.push_back(static_cast<vtkIdType>(raw.Connectivity.size()));
  raw.Faces.Locations.push_back(0);
  expectError(raw, { "face locations", "cell 2", "62 values", "31" });
}
} // namespace

#endif
