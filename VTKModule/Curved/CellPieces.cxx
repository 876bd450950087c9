// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curved/CellPieces.h"

#include <algorithm>
#include <tuple>

namespace tetmarch
{
namespace
{

bool contains(const std::vector<int>& face, int corner)
{
  return std::find(face.begin(), face.end(), corner) != face.end();
}

// Triangles are equilateral and quadrilaterals square, with edges of the length 1.
double squaredLength(const PieceCorner& a, const PieceCorner& b, const CurvedShape& shape)
{
  const Vector3 d = b.place() - a.place();
  const double plane = d[0] * d[0] + d[1] * d[1];
  switch (shape.Kind)
  {
    case CurvedKind::Tetrahedron:
    {
      const double fourth = d[0] + d[1] + d[2];
      return 0.5 * (plane + d[2] * d[2] + fourth * fourth);
    }
    case CurvedKind::Wedge:
      return 0.5 * (plane + (d[0] + d[1]) * (d[0] + d[1])) + d[2] * d[2];
    case CurvedKind::Pyramid:
      return plane + 0.5 * d[2] * d[2];
    case CurvedKind::Hexahedron:
      break;
  }
  return plane + d[2] * d[2];
}

} // namespace

std::uint8_t facesOf(const CurvedShape& shape, int corner)
{
  unsigned faces = 0;
  for (std::size_t i = 0; i < shape.Faces.size(); ++i)
  {
    faces |= contains(shape.Faces[i], corner) ? 1U << i : 0;
  }
  return static_cast<std::uint8_t>(faces);
}

std::vector<Piece> firstPieces(const CurvedShape& shape, const std::vector<PiecePoint>& points)
{
  std::vector<PieceCorner> corners;
  for (std::size_t i = 0; i < shape.Corners.size(); ++i)
  {
    PieceCorner corner{ points[i], {}, facesOf(shape, static_cast<int>(i)) };
    std::copy(shape.Corners[i].begin(), shape.Corners[i].end(), corner.At.begin());
    corners.push_back(corner);
  }
  const auto isBefore = [&points](int a, int b) { return points[a] < points[b]; };
  const int apex =
    static_cast<int>(std::min_element(points.begin(), points.end()) - points.begin());
  std::vector<Piece> pieces;
  for (std::vector<int> face : shape.Faces)
  {
    if (contains(face, apex))
    {
      continue;
    }
    std::rotate(face.begin(), std::min_element(face.begin(), face.end(), isBefore), face.end());
    for (std::size_t i = 2; i < face.size(); ++i)
    {
      pieces.push_back(
        { { corners[face[0]], corners[face[i - 1]], corners[face[i]], corners[apex] } });
    }
  }
  return pieces;
}

PieceCorner middleOf(const PieceCorner& a, const PieceCorner& b, PiecePoint point)
{
  PieceCorner middle{ point, {}, static_cast<std::uint8_t>(a.Faces & b.Faces) };
  for (int k = 0; k < 3; ++k)
  {
    middle.At[k] = 0.5F * (a.At[k] + b.At[k]);
  }
  return middle;
}

int longestEdge(const Piece& piece, const CurvedShape& shape)
{
  const auto rank = [&](int edge)
  {
    const PieceCorner& a = piece[PieceEdges[edge][0]];
    const PieceCorner& b = piece[PieceEdges[edge][1]];
    return std::make_tuple(
      squaredLength(a, b, shape), std::min(a.Point, b.Point), std::max(a.Point, b.Point));
  };
  int longest = 0;
  for (int edge = 1; edge < 6; ++edge)
  {
    longest = rank(edge) > rank(longest) ? edge : longest;
  }
  return longest;
}

} // namespace tetmarch
