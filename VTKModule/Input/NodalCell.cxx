// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/NodalCell.h"

#include "vtkCellType.h"
#include "vtkDGCell.h"
#include "vtkLagrangeHexahedron.h"
#include "vtkLagrangeTetra.h"
#include "vtkLagrangeWedge.h"
#include "vtkTriQuadraticPyramid.h"

namespace tetmarch
{
namespace
{

NodalCell linearCell(vtkDGCell* type)
{
  NodalCell cell;
  for (int corner = 0; corner < type->GetNumberOfCorners(); ++corner)
  {
    cell.Nodes.push_back(type->GetCornerParameter(corner));
  }
  switch (type->GetShape())
  {
    case vtkDGCell::Tetrahedron:
      cell.Type = VTK_TETRA;
      break;
    case vtkDGCell::Hexahedron:
      cell.Type = VTK_HEXAHEDRON;
      break;
    case vtkDGCell::Wedge:
      cell.Type = VTK_WEDGE;
      break;
    default:
      cell.Type = VTK_PYRAMID;
  }
  return cell;
}

// The interval 0..1 of VTK's cells is -1..1 along the axes from `symmetric` on.
std::vector<NodalCell::Node> nodesOf(vtkCell* cell, int count, int symmetric)
{
  std::vector<NodalCell::Node> nodes(static_cast<std::size_t>(count));
  const double* at = cell->GetParametricCoords();
  for (NodalCell::Node& node : nodes)
  {
    for (int axis = 0; axis < 3; ++axis, ++at)
    {
      node[axis] = axis < symmetric ? *at : 2 * *at - 1;
    }
  }
  return nodes;
}

void setPoints(vtkCell* cell, int count)
{
  cell->Points->SetNumberOfPoints(count);
  cell->PointIds->SetNumberOfIds(count);
}

NodalCell curvedCell(vtkDGCell* type, int order)
{
  const int n = order + 1;
  switch (type->GetShape())
  {
    case vtkDGCell::Tetrahedron:
    {
      vtkNew<vtkLagrangeTetra> cell;
      setPoints(cell, n * (n + 1) * (n + 2) / 6);
      cell->Initialize();
      return { VTK_LAGRANGE_TETRAHEDRON, nodesOf(cell, cell->GetNumberOfPoints(), 3) };
    }
    case vtkDGCell::Hexahedron:
    {
      vtkNew<vtkLagrangeHexahedron> cell;
      setPoints(cell, n * n * n);
      cell->SetUniformOrderFromNumPoints(cell->GetNumberOfPoints());
      return { VTK_LAGRANGE_HEXAHEDRON, nodesOf(cell, cell->GetNumberOfPoints(), 0) };
    }
    case vtkDGCell::Wedge:
    {
      vtkNew<vtkLagrangeWedge> cell;
      setPoints(cell, n * n * (n + 1) / 2);
      cell->SetUniformOrderFromNumPoints(cell->GetNumberOfPoints());
      return { VTK_LAGRANGE_WEDGE, nodesOf(cell, cell->GetNumberOfPoints(), 2) };
    }
    default:
    {
      vtkNew<vtkTriQuadraticPyramid> cell;
      return { VTK_TRIQUADRATIC_PYRAMID, nodesOf(cell, cell->GetNumberOfPoints(), 0) };
    }
  }
}

} // namespace

NodalCell nodalCell(vtkDGCell* type, int order)
{
  return order > 1 ? curvedCell(type, order) : linearCell(type);
}

} // namespace tetmarch
