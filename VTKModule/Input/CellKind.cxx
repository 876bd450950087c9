// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/CellKind.h"

#include "Input/CellShapes.h"

#include "vtkCellType.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

vtkIdType pointsOf(const std::vector<CellPiece>& pieces)
{
  int last = 0;
  for (const CellPiece& piece : pieces)
  {
    last = std::max(last, piece.Apex);
    for (const Polygon& face : piece.Faces)
    {
      last = std::max(last, *std::max_element(face.begin(), face.end()));
    }
  }
  return last + 1;
}

std::array<CellKind, 256> makeKinds()
{
  std::array<CellKind, 256> kinds{};
  kinds[VTK_EMPTY_CELL].Cut = CellCut::Empty;
  for (const int type :
    { VTK_VERTEX, VTK_POLY_VERTEX, VTK_LINE, VTK_POLY_LINE, VTK_TRIANGLE, VTK_TRIANGLE_STRIP,
      VTK_POLYGON, VTK_PIXEL, VTK_QUAD, VTK_QUADRATIC_EDGE, VTK_QUADRATIC_TRIANGLE,
      VTK_QUADRATIC_QUAD, VTK_QUADRATIC_POLYGON, VTK_BIQUADRATIC_QUAD, VTK_QUADRATIC_LINEAR_QUAD,
      VTK_BIQUADRATIC_TRIANGLE, VTK_CUBIC_LINE, VTK_PARAMETRIC_CURVE, VTK_PARAMETRIC_SURFACE,
      VTK_PARAMETRIC_TRI_SURFACE, VTK_PARAMETRIC_QUAD_SURFACE, VTK_HIGHER_ORDER_EDGE,
      VTK_HIGHER_ORDER_TRIANGLE, VTK_HIGHER_ORDER_QUAD, VTK_HIGHER_ORDER_POLYGON,
      VTK_LAGRANGE_CURVE, VTK_LAGRANGE_TRIANGLE, VTK_LAGRANGE_QUADRILATERAL, VTK_BEZIER_CURVE,
      VTK_BEZIER_TRIANGLE, VTK_BEZIER_QUADRILATERAL })
  {
    kinds[type].Cut = CellCut::LowDimensional;
  }
  for (const int type :
    { VTK_QUADRATIC_LINEAR_WEDGE, VTK_BIQUADRATIC_QUADRATIC_WEDGE,
      VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, VTK_PARAMETRIC_TETRA_REGION, VTK_PARAMETRIC_HEX_REGION,
      VTK_HIGHER_ORDER_TETRAHEDRON, VTK_HIGHER_ORDER_WEDGE, VTK_HIGHER_ORDER_PYRAMID,
      VTK_HIGHER_ORDER_HEXAHEDRON, VTK_LAGRANGE_PYRAMID, VTK_BEZIER_PYRAMID })
  {
    kinds[type].Cut = CellCut::Unsupported;
  }
  kinds[VTK_TETRA] = { CellCut::Tetrahedron, 4, 4 };
  kinds[VTK_POLYHEDRON] = { CellCut::Polyhedron, 4, VTK_ID_MAX };
  kinds[VTK_TRIQUADRATIC_PYRAMID] = { CellCut::ByVTK, 19, 19 };
  kinds[VTK_CONVEX_POINT_SET] = { CellCut::ByVTK, 4, VTK_ID_MAX };
  for (const int type : { VTK_LAGRANGE_TETRAHEDRON, VTK_BEZIER_TETRAHEDRON })
  {
    kinds[type] = { CellCut::ByVTK, 4, VTK_ID_MAX };
  }
  for (const int type : { VTK_LAGRANGE_WEDGE, VTK_BEZIER_WEDGE })
  {
    kinds[type] = { CellCut::ByVTK, 6, VTK_ID_MAX };
  }
  for (const int type : { VTK_LAGRANGE_HEXAHEDRON, VTK_BEZIER_HEXAHEDRON })
  {
    kinds[type] = { CellCut::ByVTK, 8, VTK_ID_MAX };
  }
  for (int type = 0; type < 256; ++type)
  {
    if (const std::vector<CellPiece>* pieces = cellPieces(type))
    {
      const vtkIdType points = pointsOf(*pieces);
      kinds[type] = { CellCut::Pieces, points, points };
    }
  }
  return kinds;
}

} // namespace

const std::array<CellKind, 256>& cellKinds()
{
  static const std::array<CellKind, 256> kinds = makeKinds();
  return kinds;
}

} // namespace tetmarch
