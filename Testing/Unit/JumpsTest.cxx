// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Scalars that jump between cells: pictures are those of cells without common vertices.
#include "Entries/VisiblePart.h"
#include "Mesh/Gradients.h"
#include "Mesh/TetMeshBuilder.h"
#include "Shot.h"

#include "vtkContourValues.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

Shot jumpingShot(vtkUnstructuredGrid* grid, double most = 0.2)
{
  Shot shot;
  shot.Data = withJumps(grid, most);
  return shot;
}

// Each corner has the scalar of the point of its own cell.
TEST(Jumps, AreOfCorners)
{
  for (const Grid& shared : { jitteredLattice(4, 0.15, 1, sineField()), hexLattice(4, 0.1),
         polyhedronLattice(3, 0.1), mixedCells(3, 1, 0.1) })
  {
    const Grid grid = withJumps(shared, 0.2);
    TetMesh mesh = built(grid);
    vtkDataArray* array = grid->GetPointData()->GetScalars();
    const MeshScalars scalars = readScalars(grid, { array }, mesh);
    ASSERT_TRUE(scalars.Jump);
    ASSERT_EQ(scalars.OfCorners.size(), mesh.Tets.size());
    std::size_t found = 0;
    for (std::size_t t = 0; t < mesh.Tets.size(); ++t)
    {
      vtkIdList* points = grid->GetCell(mesh.TetCells[t])->GetPointIds();
      for (std::size_t i = 0; i < 4; ++i)
      {
        const Vertex vertex = mesh.Vertices[mesh.Tets[t][i]];
        for (const vtkIdType point : *points)
        {
          Vector3 place;
          grid->GetPoint(point, place.data());
          const Vertex there = vertexAt(place, mesh.Frame);
          if (there.X == vertex.X && there.Y == vertex.Y && there.Z == vertex.Z)
          {
            const double value = array->GetComponent(point, 0);
            ASSERT_EQ(scalars.OfCorners[t][i], storedScalar(value, scalars.Range));
            ++found;
          }
        }
      }
    }
    EXPECT_GT(found, 3 * mesh.Tets.size());
    EXPECT_LE(scalars.Range.Low, array->GetRange()[0]);
    EXPECT_GE(scalars.Range.High, array->GetRange()[1]);
  }
}

TEST(Jumps, HaveTheGradientsOfCellsApart)
{
  const Grid grid = withJumps(jitteredLattice(4, 0.15, 1, sineField()), 0.2);
  const DrawnScalars drawn{ grid->GetPointData()->GetScalars() };
  TetMesh mesh = built(grid);
  TetMesh apart = builtApart(grid);
  const auto found = cellGradients(mesh, readScalars(grid, drawn, mesh).OfCorners);
  EXPECT_TRUE(readScalars(grid, drawn, apart).OfCorners.empty());
  const auto expected = cellGradients(apart);
  std::map<Id, Gradient> ofCells;
  for (std::size_t t = 0; t < expected.size(); ++t)
  {
    ofCells[apart.TetCells[t]] = expected[t];
  }
  for (std::size_t t = 0; t < found.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_NEAR(found[t][k], ofCells.at(mesh.TetCells[t])[k], 1e-4);
    }
  }
}

// A value that each cell computes anew may be rounded in another way.
TEST(Jumps, AreNotOfRounding)
{
  const auto jumps = [](auto array, double offset, double ulps)
  {
    const Grid grid = withRepeatedPoints(jitteredLattice(3, 0.15, 1, sineField()));
    array->SetNumberOfTuples(grid->GetNumberOfPoints());
    vtkDataArray* f = grid->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < f->GetNumberOfTuples(); ++i)
    {
      auto value = array->GetValue(0);
      value = static_cast<decltype(value)>(offset + f->GetComponent(i, 0));
      const auto next = std::nextafter(value, value + 1);
      array->SetValue(
        i, i % 2 == 0 ? value : value + static_cast<decltype(value)>(ulps) * (next - value));
    }
    TetMesh mesh = built(grid);
    const MeshScalars scalars = readScalars(grid, { array }, mesh);
    EXPECT_EQ(scalars.Jump, !scalars.OfCorners.empty());
    return scalars.Jump;
  };
  for (const double offset : { 0.0, 300.0, -1e5 })
  {
    EXPECT_FALSE(jumps(vtkSmartPointer<vtkFloatArray>::New(), offset, 1)) << offset;
    EXPECT_TRUE(jumps(vtkSmartPointer<vtkFloatArray>::New(), offset, 5)) << offset;
    EXPECT_FALSE(jumps(vtkSmartPointer<vtkDoubleArray>::New(), offset, 10)) << offset;
    EXPECT_TRUE(jumps(vtkSmartPointer<vtkDoubleArray>::New(), offset, 0x1p32)) << offset;
  }
}

// One visible scalar at a tetrahedron's own corners makes it visible.
TEST(Jumps, AreSeenInTheirOwnTetrahedra)
{
  const Grid grid = withJumps(jitteredLattice(4, 0.15, 1, sineField()), 0.3);
  TetMesh mesh = built(grid);
  MeshScalars scalars = readScalars(grid, { grid->GetPointData()->GetScalars() }, mesh);
  scalars.Range = { 0, 1, true };
  const IntegralTable table = tableOf(
    [](double f) {
      return std::array<double, 4>{ { f, f, f, std::max(0.0, 40.0 * (f - 0.7)) } };
    });
  const Blending blend;
  const HiddenCells hidden;
  const VisiblePart part = findVisiblePart(mesh, { &scalars, &table, &blend, &hidden });
  std::array<int, 4> seenAlone{};
  for (Id tet = 0; tet < mesh.numberOfTets(); ++tet)
  {
    int seen = 0;
    std::size_t last = 0;
    for (std::size_t i = 0; i < 4; ++i)
    {
      const bool isSeen = scalars.OfCorners[tet][i] > 0.7005f;
      seen += isSeen ? 1 : 0;
      last = isSeen ? i : last;
    }
    ASSERT_EQ(part.Tets[tet / 32] >> (tet % 32) & 1u, seen > 0 ? 1u : 0u) << tet;
    seenAlone[last] += seen == 1 ? 1 : 0;
  }
  EXPECT_GT(*std::min_element(seenAlone.begin(), seenAlone.end()), 3);
}

void expectGroundTruth(const Shot& shot)
{
  const Image truth = byGroundTruth(shot);
  MarchCounters counters;
  EXPECT_LE(compare(byReference<float>(shot, DefaultAccuracy, counters), truth).Max, 1.0 / 255.0);
  EXPECT_EQ(counters.Refused + counters.Lost + counters.Guarded, 0);
  const Difference exact = compare(byReference<double>(shot, GroundTruthAccuracy, counters), truth);
  EXPECT_LE(exact.Max, 1e-4) << exact.text();
  EXPECT_FALSE(MarchedShot(shot, DefaultAccuracy).Scalars.OfCorners.empty());
}

TEST(Jumps, AreExactInAVolume)
{
  const Grid lattice = jitteredLattice(6, 0.15, 1, sineField());
  expectGroundTruth(jumpingShot(lattice));
  Shot cut = jumpingShot(lattice);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.5, 0.45, 0.5);
  plane->SetNormal(-1.0, 0.3, -0.6);
  vtkNew<vtkPlaneCollection> planes;
  planes->AddItem(plane);
  cut.Cut.Planes = planes;
  expectGroundTruth(cut);
  Shot cropped = jumpingShot(lattice);
  cropped.Cut = { nullptr, true, { { 0.2, 0.6, 0.2, 0.6, 0.2, 0.6 } },
    Clipping::AllRegions - 0x2000 };
  expectGroundTruth(cropped);
}

// What the march gathers where each cell has vertices of its own.
class ApartScene
{
public:
  ApartScene(const Shot& shot, const MarchedShot& marched)
    : Mesh(builtApart(shot.Data))
    , Scene(marched.Scene)
  {
    ensureHierarchy(this->Mesh);
    readScalars(shot.Data, { shot.Data->GetPointData()->GetScalars() }, this->Mesh);
    this->Scene.Mesh = &this->Mesh;
    this->Scene.CornerScalars = nullptr;
  }

private:
  TetMesh Mesh;

public:
  ReferenceScene Scene;
};

template <typename Real>
Difference differenceApart(const Shot& shot)
{
  const auto imageOf = [](const ReferenceScene& scene)
  {
    const ReferenceImage image = renderReference<Real>(scene, DefaultAccuracy);
    EXPECT_EQ(image.Counters.Refused + image.Counters.Lost + image.Counters.Guarded, 0);
    return Image::fromFloats(Shot::Size, Shot::Size, image.Pixels.data());
  };
  const MarchedShot marched(shot, DefaultAccuracy);
  EXPECT_FALSE(marched.Scalars.OfCorners.empty());
  return compare(imageOf(marched.Scene), imageOf(ApartScene(shot, marched).Scene));
}

// No jump over the value of a surface is a surface.
TEST(Jumps, ArePicturesOfCellsApart)
{
  for (const BlendMode mode : { BlendMode::Maximum, BlendMode::Minimum, BlendMode::Average,
         BlendMode::Additive, BlendMode::IsoSurface })
  {
    Shot shot = jumpingShot(jitteredLattice(6, 0.15, 1, sineField()));
    shot.Blend.Mode = static_cast<int>(mode);
    shot.Adjust = [](vtkVolumeProperty* property)
    {
      property->GetIsoSurfaceValues()->SetNumberOfContours(2);
      property->GetIsoSurfaceValues()->SetValue(0, 0.3);
      property->GetIsoSurfaceValues()->SetValue(1, 0.6);
    };
    const Difference exact = differenceApart<double>(shot);
    EXPECT_LE(exact.Max, 1e-7) << static_cast<int>(mode) << ": " << exact.text();
    const Difference rounded = differenceApart<float>(shot);
    EXPECT_LE(rounded.Rms, 1e-4) << static_cast<int>(mode) << ": " << rounded.text();
  }
}

// A surface ends where the scalar jumps over its value; none is drawn in the face.
TEST(Jumps, OverAValueAreNoSurface)
{
  Shot shot;
  shot.Data = withRepeatedPoints(jitteredLattice(4, 0.0));
  vtkDataArray* f = shot.Data->GetPointData()->GetScalars();
  for (vtkIdType cell = 0; cell < shot.Data->GetNumberOfCells(); ++cell)
  {
    double sum = 0;
    for (vtkIdType i = 0; i < 4; ++i)
    {
      sum += shot.Data->GetPoint(4 * cell + i)[0];
    }
    for (vtkIdType i = 0; i < 4; ++i)
    {
      f->SetComponent(4 * cell + i, 0, sum < 2.0 ? 0.0 : 1.0);
    }
  }
  shot.Blend.Mode = static_cast<int>(BlendMode::IsoSurface);
  shot.Adjust = [](vtkVolumeProperty* property)
  { property->GetIsoSurfaceValues()->SetValue(0, 0.5); };
  const MarchedShot marched(shot, DefaultAccuracy);
  const ReferenceImage image = renderReference<float>(marched.Scene, DefaultAccuracy);
  EXPECT_EQ(*std::max_element(image.Pixels.begin(), image.Pixels.end()), 0.0f);
}
} // namespace
