// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays that begin at an eye in the mesh see what they see if they begin before the mesh, and cross
// no cell behind the eye but that around it.
#include "Entries/EyeStart.h"

#include "Entries/EntryListMaker.h"
#include "Entries/VisiblePartFinder.h"
#include "Mesh/OutsideSigns.h"
#include "Reference/PartKernel.h"
#include "Reference/PointKernel.h"
#include "View/RayPoints.h"

#include "NamedCamera.h"
#include "PixelLists.h"
#include "SeenWaves.h"
#include "Shot.h"
#include "UnitMeshes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <random>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr PictureSize Picture{ 31, 23 };
constexpr std::uint64_t NoLimit = std::uint64_t(1) << 32;

// Places of an eye: anywhere in the box of a mesh, or exactly in its vertices, edges and faces.
class RandomEyes
{
public:
  enum Place
  {
    Anywhere,
    InVertex,
    InEdge,
    InFace,
    NearFace,
    Places
  };

  Vector3 next(const TetMesh& mesh)
  {
    const auto place = static_cast<Place>(this->Count++ % Places);
    std::array<double, 4> weights{};
    const unsigned corners = place == NearFace ? 3 : static_cast<unsigned>(place);
    for (unsigned i = 0; i < corners; ++i)
    {
      weights[i] = 0.25 + uniform(this->Generator);
    }
    if (place == NearFace)
    {
      weights[3] = 1e-7;
    }
    const auto ids = mesh.Tets[this->Generator() % mesh.Tets.size()];
    Vector3 eye{};
    double sum = 0;
    for (unsigned i = 0; i < 4; ++i)
    {
      add(weights[i], position(mesh.Vertices[ids[i]]), eye);
      sum += weights[i];
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double inBox = (2 * uniform(this->Generator) - 1) * mesh.Frame.HalfExtent[k];
      eye[k] = place == Anywhere ? inBox : eye[k] / sum;
    }
    return eye;
  }

  // A camera there that looks anywhere.
  View viewFrom(const Vector3& eye, const TetMesh& mesh)
  {
    Shot shot;
    Vector3 at = mesh.Frame.toData(eye);
    shot.Camera->SetPosition(at.data());
    for (double& x : at)
    {
      x += mesh.Frame.Radius * (uniform(this->Generator) - 0.5);
    }
    shot.Camera->SetFocalPoint(at.data());
    shot.Camera->SetViewUp(0.1, 1.0, 0.2);
    shot.Camera->SetViewAngle(this->Count % 2 ? 40.0 : 110.0);
    shot.Camera->SetClippingRange(1e-3 * mesh.Frame.Radius, 4 * mesh.Frame.Radius);
    return viewOf(shot, mesh);
  }

private:
  std::mt19937 Generator{ 11 };
  unsigned Count = 0;
};

struct Cells
{
  std::int64_t Crossed = 0;
  std::int64_t OfSearch = 0;
  int Starts = 0;
};

// A part as the GPU has it: the start's faces are behind its own.
VisiblePart withStart(VisiblePart part, const EyeStart& start)
{
  part.Faces.insert(part.Faces.end(), start.Inside.begin(), start.Inside.end());
  part.Links.insert(part.Links.end(), start.Links.begin(), start.Links.end());
  return part;
}

// visible: null to enter all of the mesh.
void expectSamePicture(const TetMesh& mesh, const IntegralTable& table, const VisiblePart* visible,
  const View& view, const EyeStartFinder& finder, Cells& cells)
{
  auto search = kernelOf<PointKernel<float>, float>(mesh, table, DefaultAccuracy);
  const auto& none = TableTraits::NothingTransparent;
  search.transparentRanges = { none[0], none[1], none[2], none[3] };
  auto kernel = kernelOf<PartKernel<float>, float>(mesh, table, DefaultAccuracy);
  const VisiblePart& entered = visible ? *visible : finder.whole();
  const EntryLists lists = EntryListMaker().make(
    NoLimit, mesh, entered.Faces, view, Picture.Width, Picture.Height, finder.start());
  const VisiblePart part = withStart(entered, finder.start());
  kernel.Part = &part;
  const std::array<double, 16> points = rayPoints(view, mesh.Frame);
  const std::array<double, 4> near = view.nearPlane();
  for (int row = 0; row < Picture.Height; ++row)
  {
    for (int column = 0; column < Picture.Width; ++column)
    {
      const auto ray = rayOf(search, view, points, Picture, column, row);
      auto listed = rayOf(kernel, view, points, Picture, column, row);
      useList(kernel, lists, column, row, listed);
      const auto along = [&](const auto& v)
      { return near[0] * double(v.x) + near[1] * double(v.y) + near[2] * double(v.z); };
      const auto begin = static_cast<float>(-(along(ray.origin) + near[3]) / along(ray.direction));
      const auto expected = search.castPlainRay(ray, 3.0f, begin, 3e38f);
      const auto found = kernel.castPlainRay(listed, 3.0f, begin, 3e38f);
      ASSERT_NEAR(found.radiance.color.x, expected.radiance.color.x, 1e-4f) << column << ' ' << row;
      ASSERT_NEAR(found.radiance.transmittance, expected.radiance.transmittance, 1e-4f);
      ASSERT_EQ(found.lost, 0);
      ASSERT_EQ(found.refused, 0);
      cells.Crossed += found.cells;
      cells.OfSearch += expected.cells;
    }
  }
}

void expectSameFromInside(TetMesh mesh, Cells& cells)
{
  setWaves(mesh);
  const auto all = tableOf([](double f) { return std::array<double, 4>{ { f, 1 - f, 0.5, f } }; });
  const IntegralTable high = highTable();
  MeshScalars scalars;
  scalars.Range = { 0, 1, true };
  const Blending blend;
  const HiddenCells hidden;
  const VisiblePart visible = findVisiblePart(mesh, { &scalars, &high, &blend, &hidden, false });
  const auto signs = outsideSigns(mesh);
  RandomEyes eyes;
  EyeStartFinder finder;
  for (int i = 0; i < 15; ++i)
  {
    const Vector3 eye = eyes.next(mesh);
    const View view = eyes.viewFrom(eye, mesh);
    const bool enters = i % 3 == 2 && !visible.Faces.empty();
    SCOPED_TRACE(std::to_string(i) + (enters ? ", what is visible" : ", all"));
    finder.update(mesh, enters ? &visible : nullptr, { 1, std::uintptr_t(enters) }, eye,
      [&](Id tet) { return signs[tet]; });
    if (finder.isFound() && view.CutsNearPlane)
    {
      ++cells.Starts;
      ASSERT_NO_FATAL_FAILURE(expectSamePicture(
        mesh, enters ? high : all, enters ? &visible : nullptr, view, finder, cells));
    }
  }
}

TEST(EyeStart, ShowsWhatRaysSeeThatBeginBeforeTheMesh)
{
  Cells cells;
  for (const NamedGrid& named : everyGrid())
  {
    SCOPED_TRACE(named.Name);
    ASSERT_NO_FATAL_FAILURE(expectSameFromInside(builtWithHierarchy(named.Make()), cells));
  }
  std::cout << "[ MEASURED ] " << cells.Starts << " starts, " << cells.Crossed
            << " cells instead of " << cells.OfSearch << '\n';
  EXPECT_GT(cells.Starts, 10 * static_cast<int>(everyGrid().size()));
  EXPECT_LT(2.2 * double(cells.Crossed), double(cells.OfSearch));
}

// Around an eye among cells as small as what rounding moves are too many faces to test all: its
// rays rather search where they enter. Cells grow with the fourth power of the distance from a
// corner.
TEST(EyeStart, IsNotFoundAmongCellsOfRounding)
{
  const Grid grid = maskedLattice(60, 0.0, 1, linearField(),
    [](int i, int j, int k) {
      return std::max({ i, j, k }) < 8 || std::min({ i, j, k }) == 59;
    });
  vtkPoints* points = grid->GetPoints();
  for (vtkIdType point = 0; point < points->GetNumberOfPoints(); ++point)
  {
    std::array<double, 3> p;
    points->GetPoint(point, p.data());
    std::transform(p.begin(), p.end(), p.begin(), [](double x) { return x * x * x * x; });
    points->SetPoint(point, p.data());
  }
  const TetMesh mesh = built(grid);
  const auto signs = outsideSigns(mesh);
  EyeStartFinder finder;
  const auto isFoundAt = [&](double x)
  {
    const Vector3& half = mesh.Frame.HalfExtent;
    const Vector3 eye{ { x - half[0], 0.7 * x - half[1], 0.4 * x - half[2] } };
    finder.update(mesh, nullptr, { 1, 0 }, eye, [&](Id tet) { return signs[tet]; });
    return finder.isFound();
  };
  EXPECT_FALSE(isFoundAt(1e-6));
  EXPECT_TRUE(isFoundAt(2e-4));
  EXPECT_EQ(finder.start().Inside.size() + finder.start().OfPart.size(), 4u);
}
} // namespace
