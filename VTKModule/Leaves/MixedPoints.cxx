// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Leaves/MixedPoints.h"

#include "Leaves/LinearWeights.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

// A point of the leaves around it that are drawn; their distances along `ignored` don't count.
template <std::size_t N>
MixedPoint mixedAt(
  const Vector3& place, const Leaves& leaves, const std::array<int, N>& around, int ignored = 3)
{
  MixedPoint point{ place, {}, {} };
  std::vector<Vector3> centers;
  for (const int leaf : around)
  {
    if (leaves.isShown(leaf) &&
        std::find(point.From.begin(), point.From.end(), leaf) == point.From.end())
    {
      point.From.push_back(leaf);
      centers.push_back(leaves.center(leaf) - place);
      for (int a = 0; a < 3; ++a)
      {
        centers.back()[a] *= a == ignored ? 0 : 1;
      }
    }
  }
  point.Weights = linearWeights(centers);
  return point;
}

} // namespace

int MixedPoints::append(MixedPoint point)
{
  this->Mixed.push_back(std::move(point));
  return static_cast<int>(this->From.Shown + this->Mixed.size() - 1);
}

int MixedPoints::pointAt(const LeafCorner& corner)
{
  return this->append(mixedAt(this->positionOf(corner.At), this->From, corner.Around));
}

int MixedPoints::pointOn(const LeafEdge& edge)
{
  const auto [known, isNew] = this->OnEdges.try_emplace({ edge.Low, edge.Axis }, 0);
  if (!isNew)
  {
    return known->second;
  }
  const auto& around = edge.Around;
  const int a = edge.Axis;
  const double low = this->From.Axes[a].position(edge.Low[a]);
  const double length = this->From.Axes[a].position(edge.High[a]) - low;
  MixedPoint point = mixedAt(this->positionOf(edge.Low), this->From, around, a);
  double share = 0.5;
  if (std::all_of(around.begin(), around.end(), [&](int leaf) { return this->From.isShown(leaf); }))
  {
    double crossed = 0;
    for (std::size_t i = 0; i < point.From.size(); ++i)
    {
      crossed += point.Weights[i] * this->From.center(point.From[i], a);
    }
    constexpr double margin = 0.125;
    share = std::clamp((crossed - low) / length, margin, 1 - margin);
  }
  point.Position[a] = low + share * length;
  return known->second = this->append(std::move(point));
}

Vector3 MixedPoints::middleOf(const SharedFace& face) const
{
  const int leaf = face.Low == NoLeaf ? face.High : face.Low;
  const int other = face.High == NoLeaf ? face.Low : face.High;
  Vector3 middle{};
  for (int a = 0; a < 3; ++a)
  {
    middle[a] = 0.5 * (std::max(this->From.low(leaf, a), this->From.low(other, a)) +
                        std::min(this->From.high(leaf, a), this->From.high(other, a)));
  }
  middle[face.Axis] = face.Low == NoLeaf ? this->From.low(face.High, face.Axis)
                                         : this->From.high(face.Low, face.Axis);
  return middle;
}

int MixedPoints::pointIn(const SharedFace& face)
{
  const auto [known, isNew] = this->InFaces.try_emplace({ face.Low, face.High, face.Axis }, 0);
  if (!isNew)
  {
    return known->second;
  }
  MixedPoint point{ this->middleOf(face), {}, {} };
  if (this->From.isShown(face.Low) && this->From.isShown(face.High))
  {
    const int a = face.Axis;
    const double below = point.Position[a] - this->From.center(face.Low, a);
    const double above = this->From.center(face.High, a) - point.Position[a];
    point.From = { face.Low, face.High };
    point.Weights = { above / (below + above), below / (below + above) };
  }
  else
  {
    point.From = { this->From.isShown(face.Low) ? face.Low : face.High };
    point.Weights = { 1 };
  }
  return known->second = this->append(std::move(point));
}

Vector3 MixedPoints::positionOf(const LeafPlace& place) const
{
  const auto& axes = this->From.Axes;
  return { { axes[0].position(place[0]), axes[1].position(place[1]), axes[2].position(place[2]) } };
}

Vector3 MixedPoints::positionOf(int point) const
{
  const auto shown = static_cast<int>(this->From.Shown);
  return point < shown ? this->From.center(point) : this->Mixed[point - shown].Position;
}

} // namespace tetmarch
