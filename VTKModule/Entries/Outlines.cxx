// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Entries/Outlines.h"

#include "Mesh/BoundaryEdges.h"
#include "Mesh/FacePlane.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

using Plane = std::array<double, 4>;

Vector3 vertexOf(const TetMesh& mesh, Id vertex) { return position(mesh.Vertices[vertex]); }

Plane planeOf(const TetMesh& mesh, Id face)
{
  const FacePlane plane(mesh, face);
  return { { plane.Normal[0], plane.Normal[1], plane.Normal[2], -plane.Offset } };
}

bool isTurnedTo(const std::array<double, 4>& eye, const Plane& plane)
{
  return plane[0] * eye[0] + plane[1] * eye[1] + plane[2] * eye[2] + plane[3] * eye[3] > 0;
}

bool isOutline(const OutlineEdge& edge, const std::array<double, 4>& eye)
{
  return edge.Planes[0] == Plane{} ||
         isTurnedTo(eye, edge.Planes[0]) != isTurnedTo(eye, edge.Planes[1]);
}

using ClipPoint = std::array<double, 3>; // x, y, w

ClipPoint toClip(const View& view, const Vector3& p)
{
  const auto& m = view.NormalizedToClip;
  const auto row = [&](int r)
  { return m[4 * r] * p[0] + m[4 * r + 1] * p[1] + m[4 * r + 2] * p[2] + m[4 * r + 3]; };
  return { { row(0), row(1), row(3) } };
}

/** The cells of a picture. */
class Cells
{
public:
  explicit Cells(const PictureCells& where)
    : Where(where)
    , Marks(static_cast<std::size_t>(where.Count[0]) * where.Count[1], 0.0f)
  {
  }

  // In steps of half a cell: only a cell whose corner the line cuts may be missed.
  void mark(ClipPoint a, ClipPoint b)
  {
    if (!this->clip(a, b))
    {
      return;
    }
    std::array<double, 2> begin{};
    std::array<double, 2> step{};
    double length = 0;
    for (int k = 0; k < 2; ++k)
    {
      begin[k] = this->inCells(a, k);
      step[k] = this->inCells(b, k) - begin[k];
      length = std::max(length, std::abs(step[k]));
    }
    const int steps = static_cast<int>(std::ceil(2 * length)) + 1;
    for (int i = 0; i <= steps; ++i)
    {
      this->markCell(begin[0] + step[0] * i / steps, begin[1] + step[1] * i / steps);
    }
  }

  std::vector<float> take() { return std::move(this->Marks); }

private:
  // Liang and Barsky 1984, against w > 0 and the four sides of the picture.
  bool clip(ClipPoint& a, ClipPoint& b) const
  {
    double begin = 0;
    double end = 1;
    const auto cut = [&](double atA, double atB) // inside where not negative
    {
      const double t = atA / (atA - atB);
      begin = atA < 0 && atB >= 0 ? std::max(begin, t) : begin;
      end = atA >= 0 && atB < 0 ? std::min(end, t) : end;
      return !(atA < 0 && atB < 0);
    };
    constexpr double least = 1e-9; // of w
    bool some = cut(a[2] - least, b[2] - least);
    for (int k = 0; k < 2; ++k)
    {
      some = some && cut(a[2] + a[k], b[2] + b[k]) && cut(a[2] - a[k], b[2] - b[k]);
    }
    if (!some || !(begin <= end))
    {
      return false;
    }
    const ClipPoint from = a;
    const ClipPoint to = b;
    for (int k = 0; k < 3; ++k)
    {
      a[k] = from[k] + begin * (to[k] - from[k]);
      b[k] = from[k] + end * (to[k] - from[k]);
    }
    return a[2] > 0 && b[2] > 0;
  }

  double inCells(const ClipPoint& p, int k) const
  {
    const double pixel = 0.5 * (p[k] / p[2] + 1) * this->Where.Picture[k];
    return (pixel - this->Where.Corner[k]) / this->Where.Side;
  }

  void markCell(double x, double y)
  {
    const int column = std::clamp(static_cast<int>(x), 0, this->Where.Count[0] - 1);
    const int row = std::clamp(static_cast<int>(y), 0, this->Where.Count[1] - 1);
    this->Marks[static_cast<std::size_t>(row) * this->Where.Count[0] + column] = 1.0f;
  }

  PictureCells Where;
  std::vector<float> Marks;
};

} // namespace

std::vector<OutlineEdge> outlineEdgesOf(const TetMesh& mesh)
{
  const std::vector<BoundaryEdge> all = sortedBoundaryEdges(mesh);
  std::vector<OutlineEdge> edges;
  edges.reserve(all.size() / 2 + 1);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const auto first = static_cast<Id>(all[i].Key >> 32);
    const auto second = static_cast<Id>(all[i].Key & 0xffffffffu);
    OutlineEdge edge{ { { vertexOf(mesh, first), vertexOf(mesh, second) } }, {} };
    if (pairOf(all, i) == EdgePair::Regular)
    {
      edge.Planes = { { planeOf(mesh, all[i].Face), planeOf(mesh, all[i + 1].Face) } };
      ++i;
    }
    edges.push_back(edge);
  }
  return edges;
}

std::vector<OutlineEdge> outlineEdgesOf(const Vector3& halfExtent)
{
  std::vector<OutlineEdge> edges;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (const double atU : { -1.0, 1.0 })
    {
      for (const double atV : { -1.0, 1.0 })
      {
        OutlineEdge edge{};
        edge.Ends[0][u] = edge.Ends[1][u] = atU * halfExtent[u];
        edge.Ends[0][v] = edge.Ends[1][v] = atV * halfExtent[v];
        edge.Ends[0][axis] = -halfExtent[axis];
        edge.Ends[1][axis] = halfExtent[axis];
        edge.Planes[0][u] = atU;
        edge.Planes[0][3] = -halfExtent[u];
        edge.Planes[1][v] = atV;
        edge.Planes[1][3] = -halfExtent[v];
        edges.push_back(edge);
      }
    }
  }
  return edges;
}

std::vector<float> outlineCells(
  const std::vector<OutlineEdge>& edges, const View& view, const PictureCells& where)
{
  Cells cells(where);
  for (const OutlineEdge& edge : edges)
  {
    if (isOutline(edge, view.Eye))
    {
      cells.mark(toClip(view, edge.Ends[0]), toClip(view, edge.Ends[1]));
    }
  }
  return cells.take();
}

} // namespace tetmarch
