// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CurvilinearMesh.h"

#include "Mesh/BoundaryHierarchy.h"
#include "Mesh/Convexity.h"
#include "Mesh/CurvilinearHand.h"
#include "Mesh/JoinedSides.h"
#include "Mesh/Orientation.h"
#include "Mesh/SharedVertices.h"
#include "Mesh/VertexPlaces.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace tetmarch
{
namespace
{

// The triangles of the sides, in the order of their numbers.
void findBoundary(int hand, TetMesh& mesh)
{
  const CurvilinearCells& cells = *mesh.Curvilinear;
  mesh.BoundaryFaces.reserve(cells.order().size());
  for (Id number = 0; number < cells.order().size(); ++number)
  {
    if (cells.order()[number] != CurvilinearCells::NoFace)
    {
      const Id halfFace = cells.boundaryHalfFace(number);
      mesh.BoundaryFaces.push_back(outwardFace(mesh, halfFace, hand * cells.sign(halfFace / 4)));
    }
  }
}

bool hasCoincidentVertices(const TetMesh& mesh)
{
  std::vector<Id> vertices = boundaryVertices(mesh);
  const auto place = [&mesh](Id v)
  { return std::tie(mesh.Vertices[v].X, mesh.Vertices[v].Y, mesh.Vertices[v].Z); };
  vtkSMPTools::Sort(
    vertices.begin(), vertices.end(), [&place](Id a, Id b) { return place(a) < place(b); });
  return std::adjacent_find(vertices.begin(), vertices.end(),
           [&place](Id a, Id b) { return place(a) == place(b); }) != vertices.end();
}

// The vertex of each point, if some points share theirs.
std::vector<Id> verticesOfPoints(const CurvilinearCells& cells)
{
  std::vector<Id> vertices(cells.numberOfPoints());
  std::iota(vertices.begin(), vertices.end(), Id(0));
  const std::array<Id, 3>& count = cells.cells();
  const std::array<Id, 3> strides = cells.pointStrides();
  for (int a = 0; a < 3; ++a)
  {
    const int u = (a + 1) % 3, v = (a + 2) % 3;
    std::array<Id, 3> p{};
    for (p[u] = 0; p[u] <= count[u]; ++p[u])
    {
      for (p[v] = 0; p[v] <= count[v]; ++p[v])
      {
        for (const Id end : { Id(0), count[a] })
        {
          p[a] = end;
          vertices[p[0] + strides[1] * p[1] + strides[2] * p[2]] = cells.vertexAt(p);
        }
      }
    }
  }
  return vertices;
}

} // namespace

BuildStatus buildCurvilinearMesh(vtkStructuredGrid* grid, const Progress& progress, bool joinsSides,
  TetMesh& mesh, std::string& error)
{
  mesh = {};
  if (static_cast<std::uint64_t>(grid->GetNumberOfCells()) > MostCurvilinearCells)
  {
    error = "The grid has " + std::to_string(grid->GetNumberOfCells()) + " cells; at most " +
            std::to_string(MostCurvilinearCells) +
            " of a curvilinear grid can be rendered. vtkExtractGrid takes a part of it, or every "
            "second point.";
    return BuildStatus::Failed;
  }
  int points[3];
  grid->GetDimensions(points);
  const std::array<Id, 3> count{ { Id(points[0] - 1), Id(points[1] - 1), Id(points[2] - 1) } };
  mesh.computeCells(CurvilinearCells(count));
  mesh.NumberOfPoints = grid->GetNumberOfPoints();
  mesh.HasCutCells = true;
  error = placeVertices(positionsOf(grid->GetPoints(), mesh), mesh);
  if (!error.empty())
  {
    return BuildStatus::Failed;
  }
  const JoinedSides joins = joinsSides ? joinedSides(mesh) : JoinedSides();
  if (joins.any())
  {
    mesh.computeCells(CurvilinearCells(count, joins));
    mesh.FirstPoints = verticesOfPoints(*mesh.Curvilinear);
  }
  bool unfinished = false;
  const int hand = handOf(mesh, subProgress(progress, 0.1, 0.8), unfinished);
  if (unfinished)
  {
    return BuildStatus::Stopped;
  }
  if (hand != 0)
  {
    findBoundary(hand, mesh);
  }
  if (hand == 0 || mesh.BoundaryFaces.size() > MostHierarchyFaces || hasCoincidentVertices(mesh))
  {
    mesh = {};
    return BuildStatus::Done;
  }
  mesh.MayReenter = !isConvex(mesh);
  return progress && !progress(1.0) ? BuildStatus::Stopped : BuildStatus::Done;
}

vtkSmartPointer<vtkUnstructuredGrid> hexahedraOf(vtkStructuredGrid* grid)
{
  int n[3];
  grid->GetDimensions(n);
  const vtkIdType row = n[0], layer = vtkIdType(n[0]) * n[1];
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(grid->GetNumberOfCells(), 8 * grid->GetNumberOfCells());
  for (int k = 0; k + 1 < n[2]; ++k)
  {
    for (int j = 0; j + 1 < n[1]; ++j)
    {
      for (int i = 0; i + 1 < n[0]; ++i)
      {
        const vtkIdType low = i + row * j + layer * k, high = low + layer;
        cells->InsertNextCell(
          { low, low + 1, low + 1 + row, low + row, high, high + 1, high + 1 + row, high + row });
      }
    }
  }
  auto hexahedra = vtkSmartPointer<vtkUnstructuredGrid>::New();
  hexahedra->SetPoints(grid->GetPoints());
  hexahedra->SetCells(VTK_HEXAHEDRON, cells);
  return hexahedra;
}

} // namespace tetmarch
