// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/BoundaryEdges.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <numeric>

namespace tetmarch
{

std::vector<BoundaryEdge> sortedBoundaryEdges(const TetMesh& mesh)
{
  std::vector<BoundaryEdge> edges;
  edges.reserve(3 * mesh.BoundaryFaces.size());
  for (Id f = 0; f < mesh.BoundaryFaces.size(); ++f)
  {
    const auto& face = mesh.BoundaryFaces[f];
    for (int i = 0; i < 3; ++i)
    {
      const Id a = face[i], b = face[(i + 1) % 3];
      edges.push_back(
        { std::uint64_t(std::min(a, b)) << 32 | std::max(a, b), f, face[(i + 2) % 3], a < b });
    }
  }
  vtkSMPTools::Sort(edges.begin(), edges.end(),
    [](const BoundaryEdge& a, const BoundaryEdge& b)
    { return a.Key != b.Key ? a.Key < b.Key : a.Face < b.Face; });
  return edges;
}

EdgePair pairOf(const std::vector<BoundaryEdge>& edges, std::size_t i)
{
  const bool pair = i + 1 < edges.size() && edges[i].Key == edges[i + 1].Key &&
                    (i == 0 || edges[i - 1].Key != edges[i].Key) &&
                    (i + 2 == edges.size() || edges[i + 2].Key != edges[i].Key);
  if (!pair)
  {
    return EdgePair::None;
  }
  return edges[i].Forward != edges[i + 1].Forward ? EdgePair::Regular : EdgePair::Folded;
}

FaceSets::FaceSets(std::size_t faces)
  : Parent(faces)
{
  std::iota(this->Parent.begin(), this->Parent.end(), Id(0));
}

void FaceSets::join(Id a, Id b) { this->Parent[this->rootOf(a)] = this->rootOf(b); }

Id FaceSets::rootOf(Id face)
{
  while (this->Parent[face] != face)
  {
    face = this->Parent[face] = this->Parent[this->Parent[face]];
  }
  return face;
}

} // namespace tetmarch
