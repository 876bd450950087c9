// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MonkeyGrids.h"

#include "GridBlocks.h"
#include "Grids.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace tetmarch::testing
{
namespace
{
void addNan(vtkUnstructuredGrid* grid)
{
  for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(grid->GetPointData()),
         static_cast<vtkDataSetAttributes*>(grid->GetCellData()) })
  {
    vtkDataArray* scalars = data->GetScalars();
    for (vtkIdType i = 3; i < scalars->GetNumberOfTuples(); i += 11)
    {
      scalars->SetTuple1(i, std::numeric_limits<double>::quiet_NaN());
    }
  }
}

void hideSome(vtkUnstructuredGrid* grid)
{
  vtkUnsignedCharArray* ghosts = grid->AllocateCellGhostArray();
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    ghosts->SetValue(cell, cell % 5 == 0 ? vtkDataSetAttributes::HIDDENCELL : 0);
  }
}

void makeVectors(vtkUnstructuredGrid* grid)
{
  vtkDataArray* scalars = grid->GetPointData()->GetScalars();
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("f");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(scalars->GetNumberOfTuples());
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    const double f = scalars->GetTuple1(i);
    vectors->SetTuple3(i, 0.6 * f, 0.6 * (1.0 - f), 0.5 * f * f);
  }
  grid->GetPointData()->SetScalars(vectors);
}

// Less and less of the field, over something that grows: the range moves.
Field fieldOf(int step)
{
  const Field sine = sineField();
  return [=](double x, double y, double z)
  { return 0.15 * step + (1.0 - 0.2 * step) * sine(x, y, z); };
}

void movePoints(vtkUnstructuredGrid* grid)
{
  vtkPoints* points = grid->GetPoints();
  for (vtkIdType i = 0; points && i < points->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> p{};
    points->GetPoint(i, p.data());
    // No cell turns over: the map's derivative is near to 1.
    points->SetPoint(i, p[0] + 0.03 * std::sin(4.0 * p[1]), p[1] + 0.02 * p[2],
      p[2] + 0.03 * std::sin(3.0 * p[0]));
  }
}

struct Row
{
  MonkeyTraits Traits;
  std::function<Grid(const Field& field)> Make;
};

const std::array<Row, MonkeyDatasets>& rows()
{
  static const std::array<Row, MonkeyDatasets> table{ {
    { { "tetrahedra" }, [](const Field& f) { return jitteredLattice(4, 0.15, 1, f); } },
    { { "hexahedra", false }, [](const Field& f) { return hexLattice(3, 0.15, f); } },
    { { "mixed cells" }, [](const Field& f) { return mixedCells(3, 1, 0.0, f); } },
    { { "hole", false }, [](const Field& f) { return latticeWithHole(4, 0.15, 1, f); } },
    { { "NaN", true, true },
      [](const Field& f)
      {
        Grid grid = jitteredLattice(4, 0.1, 2, f);
        addNan(grid);
        return grid;
      } },
    { { "hidden cells", true, false, true },
      [](const Field& f)
      {
        Grid grid = jitteredLattice(4, 0.1, 3, f);
        hideSome(grid);
        return grid;
      } },
    { { "vectors", true, false, false, 3 },
      [](const Field& f)
      {
        Grid grid = jitteredLattice(3, 0.15, 4, f);
        makeVectors(grid);
        return grid;
      } },
    { { "far from the origin" },
      [](const Field& f) {
        return withOffsetAndScale(jitteredLattice(3, 0.15, 1, f), { 1e6, -2e6, 1e6 }, 1.0);
      } },
    { { "blocks" }, [](const Field& f) { return jitteredLattice(4, 0.15, 5, f); } },
    { { "nothing" }, [](const Field&) { return emptyGrid(); } },
  } };
  return table;
}

constexpr int Blocks = 8; // the row of them
} // namespace

const MonkeyTraits& traitsOf(int dataset) { return rows()[dataset].Traits; }

vtkSmartPointer<vtkDataObject> makeMonkeyData(int dataset, int step, bool moved)
{
  const Grid grid = rows()[dataset].Make(fieldOf(step));
  if (moved)
  {
    movePoints(grid);
  }
  if (dataset == Blocks)
  {
    return blocks(cutIntoBlocks(grid, partsOfUnitCube(3)));
  }
  return grid;
}
} // namespace tetmarch::testing
