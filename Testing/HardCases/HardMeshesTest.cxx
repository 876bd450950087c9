// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The meshes are as bad as their cases say, by counts and exact arithmetic.
#include "CaseAccess.h"

#include "GridSummary.h"
#include "Grids.h"
#include "RayChords.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <set>

namespace
{
using namespace tetmarch::testing;

using Tet = std::array<vtkIdType, 4>;

std::vector<Tet> tetsOf(vtkUnstructuredGrid* grid)
{
  std::vector<Tet> tets;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCells()->GetCellAtId(cell, ids);
    tets.push_back({ ids->GetId(0), ids->GetId(1), ids->GetId(2), ids->GetId(3) });
  }
  return tets;
}

Vec3 pointOf(vtkUnstructuredGrid* grid, vtkIdType id)
{
  Vec3 p;
  grid->GetPoint(id, p.data());
  return p;
}

// Six times the volume in units of step^3, exactly; fails where a coordinate is no multiple of it.
std::int64_t exactSixVolumes(vtkUnstructuredGrid* grid, const Tet& tet, double step)
{
  std::int64_t p[4][3];
  for (int i = 0; i < 4; ++i)
  {
    const Vec3 position = pointOf(grid, tet[i]);
    for (int a = 0; a < 3; ++a)
    {
      const double multiple = position[a] / step;
      EXPECT_EQ(multiple, std::floor(multiple));
      p[i][a] = static_cast<std::int64_t>(multiple);
    }
  }
  std::int64_t e[3][3];
  for (int i = 0; i < 3; ++i)
  {
    for (int a = 0; a < 3; ++a)
    {
      e[i][a] = p[i + 1][a] - p[0][a];
    }
  }
  return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
         e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
         e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

struct VolumeSigns
{
  int Negative = 0;
  int Zero = 0;
  int Positive = 0;
};

VolumeSigns volumeSigns(vtkUnstructuredGrid* grid, double step)
{
  VolumeSigns signs;
  for (const Tet& tet : tetsOf(grid))
  {
    const std::int64_t volume = exactSixVolumes(grid, tet, step);
    ++(volume < 0 ? signs.Negative : volume == 0 ? signs.Zero : signs.Positive);
  }
  return signs;
}

bool hasRepeatedPoint(const Tet& tet)
{
  return std::set<vtkIdType>(tet.begin(), tet.end()).size() < 4;
}

// Points that lie exactly where another one lies.
int coincidentPoints(vtkUnstructuredGrid* grid)
{
  std::set<Vec3> positions;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    positions.insert(pointOf(grid, i));
  }
  return static_cast<int>(grid->GetNumberOfPoints()) - static_cast<int>(positions.size());
}

TEST(HardMeshes, SquashedLayersAreThatThin)
{
  for (int exponent = 3; exponent <= 8; ++exponent)
  {
    const Grid grid = gridOf("squashed-1e-" + std::to_string(exponent));
    const double thin = std::pow(10.0, -exponent) / 8.0;
    int thinTets = 0;
    for (const Tet& tet : tetsOf(grid))
    {
      double low = 2.0;
      double high = -1.0;
      for (const vtkIdType id : tet)
      {
        low = std::min(low, pointOf(grid, id)[2]);
        high = std::max(high, pointOf(grid, id)[2]);
      }
      if (high - low < 0.01)
      {
        EXPECT_NEAR(high - low, thin, 3e-16);
        ++thinTets;
      }
      else
      {
        EXPECT_GT(high - low, 0.12);
      }
    }
    EXPECT_EQ(thinTets, grid->GetNumberOfCells() / 2);
    EXPECT_GT(summarise(grid).LeastVolume, 0.0);
  }
}

TEST(HardMeshes, NeedlesShareOneEdge)
{
  const Grid grid = gridOf("needle-fan");
  EXPECT_EQ(grid->GetNumberOfCells(), 1000);
  for (const Tet& tet : tetsOf(grid))
  {
    EXPECT_EQ(std::count(tet.begin(), tet.end(), 0) + std::count(tet.begin(), tet.end(), 1), 2);
  }
  EXPECT_EQ(pointOf(grid, 0)[0], 0.0);
  EXPECT_EQ(pointOf(grid, 1)[1], 0.0);
  const GridSummary summary = summarise(grid);
  EXPECT_EQ(summary.FacesOnBoundary, 2000);
  EXPECT_GT(summary.LeastVolume, 0.0);
}

TEST(HardMeshes, FlatTetsAreExactlyFlat)
{
  const double step = 1.0 / 32.0;
  const VolumeSigns inside = volumeSigns(gridOf("flat-inside"), step);
  EXPECT_EQ(inside.Zero, 54);
  EXPECT_EQ(inside.Negative, 0);
  const Grid boundary = gridOf("flat-on-boundary");
  const VolumeSigns onBoundary = volumeSigns(boundary, step);
  EXPECT_EQ(onBoundary.Zero, 36);
  EXPECT_EQ(onBoundary.Negative, 0);
  for (const Tet& tet : tetsOf(boundary))
  {
    if (exactSixVolumes(boundary, tet, step) == 0)
    {
      std::set<double> x;
      for (const vtkIdType id : tet)
      {
        x.insert(pointOf(boundary, id)[0]);
      }
      EXPECT_EQ(x.size(), 1u);
      EXPECT_TRUE(*x.begin() == 0.0 || *x.begin() == 1.0);
    }
  }
}

TEST(HardMeshes, EdgesWithoutLengthAndRepeatedPoints)
{
  const Grid distinct = gridOf("edges-without-length");
  EXPECT_EQ(coincidentPoints(distinct), 27);
  const VolumeSigns signs = volumeSigns(distinct, 0.125);
  EXPECT_EQ(signs.Negative, 0);
  EXPECT_GE(signs.Zero, 27 * 4); // four or six tetrahedra are about an edge

  const std::vector<Tet> tets = tetsOf(gridOf("repeated-points"));
  EXPECT_GE(std::count_if(tets.begin(), tets.end(), hasRepeatedPoint), 27 * 4 + 3);
  EXPECT_EQ(std::set<vtkIdType>(tets.back().begin(), tets.back().end()).size(), 2u);
}

TEST(HardMeshes, ReversedAndTangledTets)
{
  const double step = 1.0 / 1024.0;
  const int all = 6 * 6 * 6 * 6;
  EXPECT_EQ(volumeSigns(gridOf("jittered-cube"), step).Positive, all);
  EXPECT_EQ(volumeSigns(gridOf("reversed-all"), step).Negative, all);
  EXPECT_EQ(volumeSigns(gridOf("reversed-every-second"), step).Negative, all / 2);
  EXPECT_EQ(volumeSigns(gridOf("reversed-every-second"), step).Positive, all / 2);
  for (const char* name : { "tangled-inside", "tangled" })
  {
    const Grid grid = gridOf(name);
    int turned = 0;
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      turned += volumeOf(grid, facesOf(grid->GetCell(cell))) < 0.0;
    }
    EXPECT_GT(turned, 100) << name;
  }
}

TEST(HardMeshes, RepeatedCellsAndCracks)
{
  const auto distinctTets = [](vtkUnstructuredGrid* grid)
  {
    std::set<Tet> tets;
    for (Tet tet : tetsOf(grid))
    {
      std::sort(tet.begin(), tet.end());
      tets.insert(tet);
    }
    return static_cast<int>(tets.size());
  };
  EXPECT_EQ(gridOf("repeated-cells")->GetNumberOfCells(), 1296 + 432);
  EXPECT_EQ(distinctTets(gridOf("repeated-cells")), 1296);
  EXPECT_EQ(distinctTets(gridOf("repeated-mesh")), 1296);
  EXPECT_EQ(distinctTets(gridOf("two-equal-meshes")), 2592);
  EXPECT_EQ(coincidentPoints(gridOf("two-equal-meshes")), 343);

  const Grid crack = gridOf("crack");
  EXPECT_EQ(coincidentPoints(crack), 3 * 7);
  EXPECT_EQ(summarise(crack).FacesOnBoundary - summarise(gridOf("jittered-cube")).FacesOnBoundary,
    2 * 2 * 3 * 6);
}

TEST(HardMeshes, SeamsOfOneUlp)
{
  const auto seam = [](const char* name)
  {
    const Grid grid = gridOf(name);
    const vtkIdType first = 6 * 6 * 6;
    double end = 0.0;
    double begin = 2.0;
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      const double x = pointOf(grid, i)[0];
      end = i < first ? std::max(end, x) : end;
      begin = i >= first ? std::min(begin, x) : begin;
    }
    return begin - end;
  };
  const double ulp = std::numeric_limits<double>::epsilon();
  const double floatUlp = double(std::numeric_limits<float>::epsilon());
  EXPECT_EQ(seam("cubes-side-by-side"), 0.0);
  EXPECT_EQ(seam("gap-of-one-ulp"), ulp);
  EXPECT_EQ(seam("overlap-of-one-ulp"), -ulp / 2.0);
  EXPECT_EQ(seam("gap-of-one-float-ulp"), floatUlp);
  EXPECT_EQ(seam("overlap-of-one-float-ulp"), -floatUlp / 2.0);
  EXPECT_EQ(gridOf("gap-of-one-float-ulp")->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(gridOf("overlap-of-one-float-ulp")->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(gridOf("offset-1e4-float")->GetPoints()->GetDataType(), VTK_FLOAT);
}

TEST(HardMeshes, OffsetsAreExact)
{
  const Grid base = gridOf("jittered-cube");
  for (const auto& [name, offset] : { std::pair<const char*, double>{ "offset-1e6", 1e6 },
         { "offset-1e9", 1e9 }, { "offset-1e4-float", 1e4 } })
  {
    const Grid moved = gridOf(name);
    for (vtkIdType i = 0; i < base->GetNumberOfPoints(); ++i)
    {
      const Vec3 p = pointOf(moved, i);
      EXPECT_EQ((Vec3{ p[0] - offset, p[1] + offset, p[2] - offset }), pointOf(base, i)) << name;
    }
  }
}
} // namespace
