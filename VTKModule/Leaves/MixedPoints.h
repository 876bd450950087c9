// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Points between the centres of leaves: at corners, on edges and in faces.
#ifndef TetMarchLeavesMixedPoints_h
#define TetMarchLeavesMixedPoints_h

#include "Leaves/LeafCorners.h"

#include <map>
#include <utility>
#include <vector>

namespace tetmarch
{

// An edge of leaves that ends at a corner, and the leaves around it, in the order of a turn.
struct LeafEdge
{
  int Axis;
  LeafPlace Low, High; // its ends
  std::array<int, 4> Around;

  int second() const { return (this->Axis + 1) % 3; }
  int third() const { return (this->Axis + 2) % 3; }
};

// The face that two leaves share.
struct SharedFace
{
  int Low, High; // the leaves below and above it; NoLeaf outside of the mesh
  int Axis;      // its normal
};

/** A point, and the leaves whose values are mixed there; weights sum to 1. */
struct MixedPoint
{
  Vector3 Position{};
  std::vector<int> From;
  std::vector<double> Weights;
};

/** Numbers points: 0..Leaves::Shown - 1 are the centres of leaves, the mixed ones follow. */
class MixedPoints
{
public:
  explicit MixedPoints(const Leaves& leaves)
    : From(leaves)
  {
  }

  /** A new point; at least one of the leaves around it must be drawn. */
  int pointAt(const LeafCorner& corner);
  /** The point on an edge, the same for each of its ends: where the polygon of the centres around
   * the edge intersects it, but not near its ends. */
  int pointOn(const LeafEdge& edge);
  /** The point in a face, the same for each of its corners: the middle of the part that its leaves
   * share. */
  int pointIn(const SharedFace& face);

  Vector3 positionOf(int point) const;
  /** Gives the mixed points away. */
  std::vector<MixedPoint> release() { return std::move(this->Mixed); }

private:
  Vector3 positionOf(const LeafPlace& place) const;
  Vector3 middleOf(const SharedFace& face) const;
  int append(MixedPoint point);

  const Leaves& From;
  std::vector<MixedPoint> Mixed;
  std::map<std::pair<LeafPlace, int>, int> OnEdges; // by low end and axis
  std::map<std::array<int, 3>, int> InFaces;        // by the leaves below and above, and the axis
};

} // namespace tetmarch

#endif
