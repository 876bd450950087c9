// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/CellShapes.h"

#include "vtkCellType.h"

#include <algorithm>
#include <array>
#include <map>

namespace tetmarch
{
namespace
{

using Pieces = std::vector<CellPiece>;
using Edges = std::vector<std::array<int, 2>>;

const std::vector<Polygon> TetFaces = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
const std::vector<Polygon> VoxelFaces = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 },
  { 2, 6, 7, 3 }, { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };
const std::vector<Polygon> HexFaces = { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 },
  { 3, 7, 6, 2 }, { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };
const std::vector<Polygon> WedgeFaces = { { 0, 1, 2 }, { 3, 5, 4 }, { 0, 3, 4, 1 }, { 1, 4, 5, 2 },
  { 2, 5, 3, 0 } };
const std::vector<Polygon> PyramidFaces = { { 0, 3, 2, 1 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 },
  { 3, 0, 4 } };

std::vector<Polygon> prismFaces(int corners)
{
  std::vector<Polygon> faces(2);
  for (int i = 0; i < corners; ++i)
  {
    const int next = (i + 1) % corners;
    faces[0].push_back(i);
    faces[1].push_back(2 * corners - 1 - i);
    faces.push_back({ i, next, next + corners, i + corners });
  }
  return faces;
}

// The points in the middle of edges, numbered after the corners in the order of VTK's
// documentation.
const Edges TetEdges = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };
const Edges HexEdges = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 }, { 5, 6 }, { 6, 7 },
  { 7, 4 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };
const Edges WedgeEdges = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 }, { 5, 3 }, { 0, 3 },
  { 1, 4 }, { 2, 5 } };
const Edges PyramidEdges = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 0, 4 }, { 1, 4 }, { 2, 4 },
  { 3, 4 } };

// Cut every face of a quadratic cell into its corner triangles and the polygon of its edge points,
// or, with a point in its middle, into quads.
std::vector<Polygon> quadraticFaces(
  const std::vector<Polygon>& faces, const Edges& edges, int corners, int firstFacePoint = -1)
{
  std::map<std::array<int, 2>, int> middles;
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    const int middle = corners + static_cast<int>(e);
    middles[{ edges[e][0], edges[e][1] }] = middle;
    middles[{ edges[e][1], edges[e][0] }] = middle;
  }
  std::vector<Polygon> cut;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const Polygon& face = faces[f];
    Polygon inner;
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const int before = face[(i + face.size() - 1) % face.size()];
      const int after = face[(i + 1) % face.size()];
      const int in = middles.at({ before, face[i] });
      const int out = middles.at({ face[i], after });
      if (firstFacePoint < 0)
      {
        cut.push_back({ in, face[i], out });
        inner.push_back(out);
      }
      else
      {
        cut.push_back({ in, face[i], out, firstFacePoint + static_cast<int>(f) });
      }
    }
    if (firstFacePoint < 0)
    {
      cut.push_back(inner);
    }
  }
  return cut;
}

// A corner tetrahedron at each corner, and the octahedron between the points on the edges.
Pieces quadraticTetPieces()
{
  Pieces pieces;
  CellPiece octahedron{ {}, ApexSmallestId };
  for (const Polygon& face : quadraticFaces(TetFaces, TetEdges, 4))
  {
    const bool inner = std::all_of(face.begin(), face.end(), [](int p) { return p >= 4; });
    if (inner)
    {
      octahedron.Faces.push_back(face);
    }
  }
  const std::array<std::array<int, 4>, 4> atCorner = { { { 0, 4, 6, 7 }, { 1, 5, 4, 8 },
    { 2, 6, 5, 9 }, { 3, 7, 9, 8 } } };
  for (const auto& tet : atCorner)
  {
    pieces.push_back({ { { tet[1], tet[2], tet[3] } }, tet[0] });
    octahedron.Faces.push_back({ tet[1], tet[2], tet[3] });
  }
  pieces.push_back(octahedron);
  return pieces;
}

std::map<int, Pieces> makeTable()
{
  std::map<int, Pieces> table;
  table[VTK_VOXEL] = { { VoxelFaces, ApexSmallestId } };
  table[VTK_HEXAHEDRON] = { { HexFaces, ApexSmallestId } };
  table[VTK_WEDGE] = { { WedgeFaces, ApexSmallestId } };
  table[VTK_PYRAMID] = { { PyramidFaces, ApexSmallestId } };
  table[VTK_PENTAGONAL_PRISM] = { { prismFaces(5), ApexSmallestId } };
  table[VTK_HEXAGONAL_PRISM] = { { prismFaces(6), ApexSmallestId } };
  table[VTK_QUADRATIC_TETRA] = quadraticTetPieces();
  table[VTK_QUADRATIC_HEXAHEDRON] = { { quadraticFaces(HexFaces, HexEdges, 8), ApexMean } };
  table[VTK_QUADRATIC_WEDGE] = { { quadraticFaces(WedgeFaces, WedgeEdges, 6), ApexMean } };
  table[VTK_QUADRATIC_PYRAMID] = { { quadraticFaces(PyramidFaces, PyramidEdges, 5), ApexMean } };
  table[VTK_TRIQUADRATIC_HEXAHEDRON] = { { quadraticFaces(HexFaces, HexEdges, 8, 20), 26 } };
  return table;
}

} // namespace

const std::vector<CellPiece>* cellPieces(int cellType)
{
  static const std::map<int, Pieces> table = makeTable();
  const auto found = table.find(cellType);
  return found == table.end() ? nullptr : &found->second;
}

} // namespace tetmarch
