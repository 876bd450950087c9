// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Leaves/DualCells.h"

#include <algorithm>
#include <utility>

namespace tetmarch
{
namespace
{

class DualCellMaker
{
public:
  explicit DualCellMaker(const Leaves& leaves)
    : From(leaves)
    , Points(leaves)
  {
  }

  DualCells made(const std::vector<LeafCorner>& corners)
  {
    for (const LeafCorner& corner : corners)
    {
      this->isBox(corner) ? this->addBox(corner) : this->addFan(corner);
    }
    this->Made.Mixed = this->Points.release();
    return std::move(this->Made);
  }

private:
  bool equalAlong(int axis, int a, int b) const
  {
    return this->From.All[a].Low[axis] == this->From.All[b].Low[axis] &&
           this->From.All[a].Size[axis] == this->From.All[b].Size[axis];
  }

  bool isBox(const LeafCorner& corner) const
  {
    const auto& around = corner.Around;
    bool box =
      std::all_of(around.begin(), around.end(), [&](int leaf) { return this->From.isShown(leaf); });
    for (int octant = 0; octant < 8 && box; ++octant)
    {
      for (int a = 0; a < 3; ++a)
      {
        box = box && around[octant] != around[octant ^ (1 << a)] &&
              this->equalAlong(a, around[octant], around[(octant >> a & 1) * (1 << a)]);
      }
    }
    return box;
  }

  void addBox(const LeafCorner& corner)
  {
    const auto& around = corner.Around;
    this->Made.Boxes.push_back({ { around[0], around[1], around[3], around[2], around[4], around[5],
      around[7], around[6] } });
  }

  // Whether four centres form a rectangle, whose edges run through the faces of their leaves.
  bool isRectangle(const LeafEdge& edge) const
  {
    const auto& q = edge.Around;
    const int b = edge.second();
    const int c = edge.third();
    const bool shown =
      std::all_of(q.begin(), q.end(), [&](int leaf) { return this->From.isShown(leaf); });
    return shown && q[0] != q[1] && q[1] != q[2] && q[2] != q[3] && q[3] != q[0] &&
           this->equalAlong(b, q[0], q[3]) && this->equalAlong(b, q[1], q[2]) &&
           this->equalAlong(c, q[0], q[1]) && this->equalAlong(c, q[2], q[3]) &&
           this->equalAlong(edge.Axis, q[0], q[1]) && this->equalAlong(edge.Axis, q[1], q[2]) &&
           this->equalAlong(edge.Axis, q[2], q[3]);
  }

  void addFan(const LeafCorner& corner)
  {
    const auto& around = corner.Around;
    if (std::none_of(
          around.begin(), around.end(), [&](int leaf) { return this->From.isShown(leaf); }))
    {
      return;
    }
    const int middle = this->Points.pointAt(corner);
    for (int side = 0; side < 6; ++side)
    {
      LeafEdge edge;
      if (this->findEdge(corner, side / 2, side % 2, edge))
      {
        this->isRectangle(edge) ? this->addPyramid(edge.Around, middle)
                                : this->addTetrahedra(edge, middle);
      }
    }
  }

  // The edge from the corner along an axis; false if a face or a leaf is there
  // instead, or none of its leaves is drawn.
  bool findEdge(const LeafCorner& corner, int axis, int side, LeafEdge& edge) const
  {
    edge.Axis = axis;
    const int b = 1 << edge.second();
    const int c = 1 << edge.third();
    const int first = side << axis;
    const auto& around = corner.Around;
    edge.Around = { { around[first], around[first | b], around[first | b | c],
      around[first | c] } };
    const auto& q = edge.Around;
    if ((q[0] == q[1] && q[2] == q[3]) || (q[0] == q[3] && q[1] == q[2]) ||
        std::none_of(q.begin(), q.end(), [&](int leaf) { return this->From.isShown(leaf); }))
    {
      return false;
    }
    edge.Low = edge.High = corner.At;
    int& end = side == 1 ? edge.High[axis] : edge.Low[axis];
    bool found = false;
    for (const int number : q)
    {
      if (number != NoLeaf)
      {
        const Leaf& leaf = this->From.All[number];
        const int other = side == 1 ? leaf.Low[axis] + leaf.Size[axis] : leaf.Low[axis];
        end = !found ? other : side == 1 ? std::min(end, other) : std::max(end, other);
        found = true;
      }
    }
    return true;
  }

  void addPyramid(const std::array<int, 4>& base, int apex)
  {
    std::array<int, 5> cell{ { base[0], base[1], base[2], base[3], apex } };
    if (this->volumeOf({ { cell[0], cell[1], cell[2], apex } }) < 0)
    {
      std::swap(cell[1], cell[3]);
    }
    this->Made.Pyramids.push_back(cell);
  }

  void addTetrahedron(std::array<int, 4> cell)
  {
    if (this->volumeOf(cell) < 0)
    {
      std::swap(cell[2], cell[3]);
    }
    this->Made.Tetrahedra.push_back(cell);
  }

  void addTetrahedra(const LeafEdge& edge, int middle)
  {
    const int on = this->Points.pointOn(edge);
    for (int k = 0; k < 4; ++k)
    {
      const int leaf = edge.Around[k];
      const int next = edge.Around[(k + 1) % 4];
      if (leaf == next || (!this->From.isShown(leaf) && !this->From.isShown(next)))
      {
        continue;
      }
      const bool ascends = k < 2; // from the low side to the high side
      const SharedFace face{ ascends ? leaf : next, ascends ? next : leaf,
        k % 2 == 0 ? edge.second() : edge.third() };
      if (this->isCrossedBetweenCenters(face))
      {
        this->addTetrahedron({ { middle, on, leaf, next } });
        continue;
      }
      const int in = this->Points.pointIn(face);
      for (const int center : { leaf, next })
      {
        if (this->From.isShown(center))
        {
          this->addTetrahedron({ { middle, on, in, center } });
        }
      }
    }
  }

  // Whether the line between the centres of two leaves that are drawn intersects their face.
  bool isCrossedBetweenCenters(const SharedFace& face) const
  {
    if (!this->From.isShown(face.Low) || !this->From.isShown(face.High))
    {
      return false;
    }
    const Vector3 low = this->From.center(face.Low);
    const Vector3 high = this->From.center(face.High);
    const double at = this->From.high(face.Low, face.Axis);
    const double share = (at - low[face.Axis]) / (high[face.Axis] - low[face.Axis]);
    bool crossed = true;
    for (const int a : { (face.Axis + 1) % 3, (face.Axis + 2) % 3 })
    {
      const double place = low[a] + share * (high[a] - low[a]);
      crossed = crossed &&
                place > std::max(this->From.low(face.Low, a), this->From.low(face.High, a)) &&
                place < std::min(this->From.high(face.Low, a), this->From.high(face.High, a));
    }
    return crossed;
  }

  // Six times the volume; positive in VTK's order.
  double volumeOf(const std::array<int, 4>& points) const
  {
    const Vector3 origin = this->Points.positionOf(points[0]);
    return dot(cross(this->Points.positionOf(points[1]) - origin,
                 this->Points.positionOf(points[2]) - origin),
      this->Points.positionOf(points[3]) - origin);
  }

  const Leaves& From;
  MixedPoints Points;
  DualCells Made;
};

} // namespace

DualCells dualCellsOf(const Leaves& leaves, const std::vector<LeafCorner>& corners)
{
  return DualCellMaker(leaves).made(corners);
}

} // namespace tetmarch
