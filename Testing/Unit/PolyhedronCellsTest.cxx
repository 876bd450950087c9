// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Arrays of faces as VTK has them from 9.4 on: whatever they hold, nothing is read that isn't
// there.
#include "BrokenGrids.h"

#if !TETMARCH_FACES_ARE_STREAMS

#include "vtkCellArray.h"

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

const Ids Corners{ 0, 1, 2, 3, 4, 5, 6, 7 };

void addCopies(RawGrid& raw, int count)
{
  for (int i = 0; i < count; ++i)
  {
    raw.Types.push_back(VTK_POLYHEDRON);
    raw.Connectivity.insert(raw.Connectivity.end(), Corners.begin(), Corners.end());
    raw.Offsets.push_back(static_cast<vtkIdType>(raw.Connectivity.size()));
    const Ids faces{ 0, 1, 2, 3, 4, 5 };
    raw.Faces.Locations.insert(raw.Faces.Locations.end(), faces.begin(), faces.end());
    raw.Faces.LocationOffsets.push_back(static_cast<vtkIdType>(raw.Faces.Locations.size()));
  }
}

const vtkIdType WrongNumbers[]{ -1, 100, VTK_ID_MAX, VTK_ID_MIN };

TEST(PolyhedronCheck, ArraysTooShort)
{
  RawGrid raw = tetAndPolyhedron();
  raw.Faces.LocationOffsets.pop_back();
  expectError(raw, { "face locations", "1 entries", "polyhedron 1" });
  raw.Faces.LocationOffsets.clear();
  expectError(raw, { "face locations", "-1 entries", "polyhedron 1" });
  raw = tetAndPolyhedron();
  raw.Faces.Offsets.clear();
  expectError(raw, { "face locations", "polyhedron 1", "face 0", "-1 faces" });
}

TEST(PolyhedronCheck, NoFaces)
{
  RawGrid raw = tetAndPolyhedron();
  raw.Faces.LocationOffsets.back() = 0;
  expectError(raw, { "face locations", "polyhedron 1 no faces", "at least 1" });
}

TEST(PolyhedronCheck, FaceLocationsOutOfRange)
{
  for (const vtkIdType wrong : WrongNumbers)
  {
    RawGrid raw = tetAndPolyhedron();
    raw.Faces.LocationOffsets[2] = wrong;
    expectError(
      raw, { "offsets", "face locations of polyhedron 1", std::to_string(wrong), "6 values" });
    raw = tetAndPolyhedron();
    raw.Faces.LocationOffsets[1] = wrong;
    expectError(raw, { "offsets", "face locations of polyhedron 1",
                       "begins at " + std::to_string(wrong), "6 values" });
    raw = tetAndPolyhedron();
    raw.Faces.Locations[3] = wrong;
    expectError(raw, { "polyhedron 1 name face " + std::to_string(wrong), "6 faces" });
  }
}

TEST(PolyhedronCheck, OffsetsOfFacesOutOfRange)
{
  for (const vtkIdType wrong : WrongNumbers)
  {
    RawGrid raw = tetAndPolyhedron();
    raw.Faces.Offsets[3] = wrong;
    expectError(raw, { "offsets of face 2", "ends at " + std::to_string(wrong), "24 values" });
  }
}

TEST(PolyhedronCheck, NumbersOfPointsOfFaces)
{
  RawGrid raw = tetAndPolyhedron();
  raw.Faces.Offsets[2] = 6;
  expectError(raw, { "face 1, which polyhedron 1 has, 2 points", "at least 3" });
}

TEST(PolyhedronCheck, FacesThatAreCutShort)
{
  const RawGrid whole = tetAndPolyhedron();
  for (std::size_t array = 0; array < 2; ++array)
  {
    for (std::size_t size = 0; size < RawGrid(whole).Faces.faceArrays()[array]->size(); ++size)
    {
      RawGrid raw = whole;
      raw.Faces.faceArrays()[array]->resize(size);
      expectError(raw, { "polyhedron 1" });
      raw = whole;
    }
    for (std::size_t size = 0; size < RawGrid(whole).Faces.locationArrays()[array]->size(); ++size)
    {
      RawGrid raw = whole;
      raw.Faces.locationArrays()[array]->resize(size);
      expectError(raw, { "polyhedron 1" });
    }
  }
}

TEST(PolyhedronCheck, FacesThatNamePointsBeyondThePoints)
{
  for (const vtkIdType wrong : { vtkIdType(8), vtkIdType(-1), VTK_ID_MAX })
  {
    RawGrid raw = tetAndPolyhedron();
    raw.Faces.Points[6] = wrong;
    expectError(raw, { "face 1", "polyhedron 1", "point " + std::to_string(wrong), "8 points" });
  }
}

// A face of two polyhedra is nothing unusual, one of three is.
TEST(PolyhedronCheck, PolyhedraThatShareTheirFaces)
{
  RawGrid raw = tetAndPolyhedron();
  addCopies(raw, 1);
  TetMesh mesh;
  std::string error;
  EXPECT_EQ(buildTetMesh(raw.grid(), {}, mesh, error), BuildStatus::Done) << error;
  addCopies(raw, 1);
  expectError(raw, { "cell 3", "72", "24", "two polyhedra at most" });
}
} // namespace

#endif
