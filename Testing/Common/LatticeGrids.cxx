// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LatticeGrids.h"

#include "CubeTopology.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace tetmarch::testing
{
namespace
{
vtkIdType latticeId(int n, vtkIdType i, vtkIdType j, vtkIdType k)
{
  return i + (n + 1) * (j + (n + 1) * k);
}

vtkIdType cornerId(int n, int i, int j, int k, int corner)
{
  return latticeId(n, i + (corner & 1), j + ((corner >> 1) & 1), k + (corner >> 2));
}

template <typename Visit>
void forEachCube(int n, Visit&& visit)
{
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        visit(i, j, k);
      }
    }
  }
}

// Arrays are filled in place: InsertNextCell would take most of the time of a benchmark's set-up.
Grid tetGrid(const std::vector<double>& points, const Ids& connectivity, const Field& field)
{
  const auto tets = static_cast<vtkIdType>(connectivity.size() / 4);

  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(points.size() / 3));
  std::copy(points.begin(), points.end(), coordinates->GetPointer(0));
  vtkNew<vtkPoints> gridPoints;
  gridPoints->SetData(coordinates);

  vtkNew<vtkIdTypeArray> ids;
  ids->SetNumberOfValues(4 * tets);
  std::copy(connectivity.begin(), connectivity.end(), ids->GetPointer(0));
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(tets + 1);
  for (vtkIdType i = 0; i <= tets; ++i)
  {
    offsets->SetValue(i, 4 * i);
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, ids);
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfValues(tets);
  types->FillValue(VTK_TETRA);

  auto grid = Grid::New();
  grid->SetPoints(gridPoints);
  grid->SetCells(types, cells);
  attachFields(grid, field);
  return grid;
}
} // namespace

double uniform(std::mt19937& generator)
{
  return static_cast<double>(generator() & 0xffffffffu) / 4294967296.0;
}

std::vector<double> latticePoints(
  int n, double jitter, unsigned seed, const std::vector<bool>& pinned)
{
  std::mt19937 generator(seed);
  std::vector<double> points;
  points.reserve(3 * static_cast<std::size_t>(latticeId(n, n, n, n) + 1));
  forEachCube(n + 1,
    [&](int i, int j, int k)
    {
      const bool isPinned = !pinned.empty() && pinned[points.size() / 3];
      for (const int index : { i, j, k })
      {
        // Drawn for every point, so that pinning some leaves the others where they were.
        const double move = jitter * (2.0 * uniform(generator) - 1.0);
        const bool stays = isPinned || index == 0 || index == n;
        points.push_back((index + (stays ? 0.0 : move)) / n);
      }
    });
  return points;
}

Grid jitteredLattice(int n, double jitter, unsigned seed, const Field& field)
{
  Ids connectivity;
  connectivity.reserve(24 * static_cast<std::size_t>(n) * n * n);
  forEachCube(n,
    [&](int i, int j, int k)
    {
      for (const auto& tet : KuhnTets)
      {
        for (const int corner : tet)
        {
          connectivity.push_back(cornerId(n, i, j, k, corner));
        }
      }
    });
  return tetGrid(latticePoints(n, jitter, seed), connectivity, field);
}

Grid maskedLattice(int n, double jitter, unsigned seed, const Field& field, const CubeFilter& keep)
{
  const auto pointCount = static_cast<std::size_t>(latticeId(n, n, n, n) + 1);
  std::vector<bool> pinned(pointCount, false);
  std::vector<bool> used(pointCount, false);
  forEachCube(n,
    [&](int i, int j, int k)
    {
      auto& mark = keep(i, j, k) ? used : pinned;
      for (int corner = 0; corner < 8; ++corner)
      {
        mark[cornerId(n, i, j, k, corner)] = true;
      }
    });

  const std::vector<double> all = latticePoints(n, jitter, seed, pinned);
  std::vector<double> points;
  Ids newId(pointCount, -1);
  for (std::size_t id = 0; id < pointCount; ++id)
  {
    if (used[id])
    {
      newId[id] = static_cast<vtkIdType>(points.size() / 3);
      points.insert(points.end(), &all[3 * id], &all[3 * id] + 3);
    }
  }

  Ids connectivity;
  forEachCube(n,
    [&](int i, int j, int k)
    {
      if (keep(i, j, k))
      {
        for (const auto& tet : KuhnTets)
        {
          for (const int corner : tet)
          {
            connectivity.push_back(newId[cornerId(n, i, j, k, corner)]);
          }
        }
      }
    });
  return tetGrid(points, connectivity, field);
}
} // namespace tetmarch::testing
