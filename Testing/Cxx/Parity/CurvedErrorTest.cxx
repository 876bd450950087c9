// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The error bound of pixels of curved cells that were cut with a coarse tolerance. The truth is the
// picture of a fine one.
#include "GridBuilder.h"
#include "QuadraticGrids.h"
#include "ViewScene.h"

#include "vtkCellType.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
using namespace tetmarch::testing;
using Mapper = vtkTetMarchVolumeMapper;

constexpr double Fine = 1e-3;
constexpr double LeastBound = 1e-5; // that the view tells
constexpr double GreatestBound = 1.0;

// A cell whose sides bulge by this part of its width.
Grid bulgingCell(double bulge, const Field& field)
{
  const Grid cell = triQuadraticHexLattice(1, 0.0, field);
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    Vec3 p;
    cell->GetPoint(i, p.data());
    Vec3 moved = p;
    for (int a = 0; a < 3; ++a)
    {
      const double b = p[(a + 1) % 3], c = p[(a + 2) % 3];
      moved[a] += bulge * (2.0 * p[a] - 1.0) * 16.0 * b * (1.0 - b) * c * (1.0 - c);
    }
    cell->GetPoints()->SetPoint(i, moved.data());
  }
  return cell;
}

// A quadratic one with straight edges. Its scalar rises by a slope along x, and in the middle of
// edges it is that much higher.
Grid oneTetrahedron(double slope, double higher)
{
  GridBuilder builder;
  Ids points;
  for (const Vec3& corner : { Vec3{ 0, 0, 0 }, Vec3{ 1, 0, 0 }, Vec3{ 0, 1, 0 }, Vec3{ 0, 0, 1 } })
  {
    points.push_back(builder.addPoint(corner));
  }
  for (const auto& ends :
    { Ids{ 0, 1 }, Ids{ 1, 2 }, Ids{ 2, 0 }, Ids{ 0, 3 }, Ids{ 1, 3 }, Ids{ 2, 3 } })
  {
    points.push_back(builder.between({ points[ends[0]], points[ends[1]] }));
  }
  builder.addCell(VTK_QUADRATIC_TETRA, points);
  return builder.finish(
    [=](double x, double y, double z)
    {
      const double bubble = x + y + z - x * x - y * y - z * z - x * y - y * z - z * x;
      return 0.2 + slope * x + 4.0 * higher * bubble;
    });
}

double waves(double x, double y, double z)
{
  return 0.5 + 0.25 * std::sin(5.0 * x + 2.0 * y) + 0.2 * std::cos(4.0 * z - 3.0 * y * x);
}

struct Case
{
  const char* Name;
  std::function<Grid()> Make;
  std::function<void(Scene&)> Set = [](Scene&) {};
  double Coarse = 5e-3;
  double MostOfBound = 500.0; // the mean bound, in mean errors
};

void drawCells(Scene& scene) { scene.drawCellScalars(); }
void drawSpikes(Scene& scene) { setSpikyFunctions(scene.property()); }
void drawTwoPeaks(Scene& scene) { setTwoPeaks(scene.property()); }
void drawDense(Scene& scene) { scene.property()->SetScalarOpacityUnitDistance(0.02); }
void drawInLight(Scene& scene) { setShading(scene.property()); }
void lookFromWithin(Scene& scene) { lookFromInside(scene.camera()); }
void drawEven(Scene& scene) { setPlainFunctions(scene.property(), { { 0.9, 0.6, 0.3 } }, 0.1); }
// Thin, of one colour, with an extinction in proportion to the scalar.
void drawThin(Scene& scene)
{
  drawEven(scene);
  vtkPiecewiseFunction* opacity = scene.property()->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(1.0, 0.3);
}
void cut(Scene& scene)
{
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(0.2, 0.8, 0.3, 0.9, 0.1, 0.6);
}

constexpr double Uncut = 1.0; // all that a cell may be off by

const Case Cases[] = {
  // The worst that may be: of one sign in all of the cell; all faces off as far as they can.
  { "Bubble", [] { return oneTetrahedron(0.0, 0.8); }, drawThin, Uncut, 2.0 },
  { "BubbleOnASlope", [] { return oneTetrahedron(0.7, 0.05); }, drawThin, Uncut, 3.0 },
  { "FacesAlone", [] { return bulgingCell(0.1, waves); }, drawEven, Uncut, 6.0 },
  { "StraightEdges", [] { return triQuadraticHexLattice(3, 0.0, waves); } },
  { "Tetrahedra", [] { return quadraticTetLattice(2, 0.1, waves); } },
  { "Wedges", [] { return quadraticWedgeLattice(2, 0.1, waves); } },
  { "OneColor", [] { return quadraticHexLattice(2, 0.15, waves); }, drawThin },
  { "Spikes", [] { return quadraticHexLattice(3, 0.1, waves); }, drawSpikes },
  { "MuchTransparent", [] { return quadraticHexLattice(3, 0.1, waves); }, drawTwoPeaks },
  { "Dense", [] { return quadraticHexLattice(3, 0.1, waves); }, drawDense },
  { "InLight", [] { return quadraticHexLattice(3, 0.1, waves); }, drawInLight },
  { "Cells", [] { return quadraticHexLattice(3, 0.15, waves); }, drawCells },
  { "Bulging", [] { return bulgingCell(0.2, waves); } },
  { "Cropped", [] { return bulgingCell(0.2, waves); }, cut },
  { "FromInside", [] { return quadraticHexLattice(3, 0.15, waves); }, lookFromWithin },
};

struct BoundedPicture
{
  Image Picture;
  std::vector<double> Bounds; // -1 where the ray met nothing
};

BoundedPicture drawn(const Case& of, double tolerance)
{
  ViewScene scene(of.Make(), 96, 96);
  scene.property()->SetScalarOpacityUnitDistance(0.25);
  of.Set(scene);
  scene.Mapper->SetErrorTolerance(1e-4);
  scene.Mapper->SetGeometryTolerance(tolerance);
  BoundedPicture bounded;
  scene.Mapper->CollectDiagnosticsOn();
  bounded.Picture = scene.render();
  scene.Mapper->SetViewRange(LeastBound, GreatestBound);
  scene.Mapper->AutomaticViewRangeOff();
  const Image view = scene.view(Mapper::VIEW_ERROR_BOUND);
  const double decades = std::log10(GreatestBound / LeastBound);
  const auto colors = static_cast<double>(scene.table()->GetNumberOfTableValues());
  for (const int entry : entriesOf(view, scene.table()))
  {
    const double upTo = LeastBound * std::pow(10.0, decades * (entry + 1) / colors);
    bounded.Bounds.push_back(entry < 0 ? -1.0 : upTo);
  }
  return bounded;
}

class CurvedError : public testing::TestWithParam<Case>
{
};

TEST_P(CurvedError, IsBounded)
{
  const BoundedPicture coarse = drawn(GetParam(), GetParam().Coarse);
  const BoundedPicture fine = drawn(GetParam(), Fine);
  int both = 0;
  int wrong = 0; // by more than 1e-4
  double meanError = 0.0;
  double meanBound = 0.0;
  double meanFine = 0.0;
  double worst = 0.0; // of the bound
  for (std::size_t i = 0; i < coarse.Bounds.size(); ++i)
  {
    if (coarse.Bounds[i] < 0.0 || fine.Bounds[i] < 0.0)
    {
      continue;
    }
    double error = 0.0;
    for (std::size_t k = 4 * i; k < 4 * i + 4; ++k)
    {
      const double difference = double(coarse.Picture.Rgba[k]) - double(fine.Picture.Rgba[k]);
      error = std::max(error, std::abs(difference));
    }
    ++both;
    wrong += error > 1e-4 ? 1 : 0;
    meanError += error;
    meanBound += coarse.Bounds[i];
    meanFine += fine.Bounds[i];
    worst = std::max(worst, error / (coarse.Bounds[i] + fine.Bounds[i]));
  }
  std::cout << "[ MEASURED ] " << GetParam().Name << ": " << both
            << " pixels, off by more than 1e-4: " << wrong << ", mean error " << meanError / both
            << ", bound " << meanBound / both << ", of the truth " << meanFine / both
            << ", most of it " << worst << '\n';
  EXPECT_GT(both, 1000);
  EXPECT_GT(wrong, 100);
  EXPECT_LE(worst, 1.0);
  EXPECT_LE(meanBound, GetParam().MostOfBound * meanError);
}

INSTANTIATE_TEST_SUITE_P(Of, CurvedError, testing::ValuesIn(Cases),
  [](const auto& of) { return std::string(of.param.Name); });
} // namespace
