// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MarchedMesh.h"

#include "Mesh/TetMeshBuilder.h"

#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <stdexcept>
#include <string>

namespace tetmarch::testing
{
namespace
{
TetMesh builtAs(vtkUnstructuredGrid* grid, const PieceOptions& options)
{
  TetMesh mesh;
  std::string error;
  if (buildTetMesh(grid, {}, mesh, error, options) != BuildStatus::Done)
  {
    throw std::runtime_error(error);
  }
  return mesh;
}
} // namespace

TetMesh built(vtkUnstructuredGrid* grid) { return builtAs(grid, {}); }

TetMesh builtApart(vtkUnstructuredGrid* grid)
{
  PieceOptions options;
  options.SeparatePoints = true;
  return builtAs(grid, options);
}

TetMesh builtWithHierarchy(vtkUnstructuredGrid* grid)
{
  TetMesh mesh = built(grid);
  ensureHierarchy(mesh);
  return mesh;
}

Grid asGrid(const TetMesh& mesh)
{
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("f");
  for (const Vertex& v : mesh.Vertices)
  {
    points->InsertNextPoint(double(v.X), double(v.Y), double(v.Z));
    scalars->InsertNextValue(double(v.Scalar));
  }
  grid->SetPoints(points);
  grid->Allocate(static_cast<vtkIdType>(mesh.Tets.size()));
  for (const auto& tet : mesh.Tets)
  {
    const vtkIdType ids[4] = { tet[0], tet[1], tet[2], tet[3] };
    grid->InsertNextCell(VTK_TETRA, 4, ids);
  }
  grid->GetPointData()->SetScalars(scalars);
  return grid;
}

IntegralTable tableOf(const std::function<std::array<double, 4>(double)>& f, int entries)
{
  SampledFunctions functions;
  const int count = samplesOfTable(entries);
  for (int i = 0; i < count; ++i)
  {
    functions.Samples.push_back(f(static_cast<double>(i) / (count - 1)));
  }
  functions.Before = functions.Samples.front();
  functions.After = functions.Samples.back();
  return makeIntegralTable(functions);
}

const IntegralTable& whiteTable()
{
  static const IntegralTable table = tableOf(
    [](double) {
      return std::array<double, 4>{ { 1.0, 1.0, 1.0, 1.0 } };
    },
    64);
  return table;
}
} // namespace tetmarch::testing
