// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/VertexTets.h"

#include <numeric>

namespace tetmarch
{

// A counting sort.
VertexTets::VertexTets(const TetMesh& mesh)
  : Starts(mesh.Vertices.size() + 1, 0)
  , Tets(4 * mesh.Tets.size())
{
  for (const auto& tet : mesh.Tets)
  {
    for (const Id v : tet)
    {
      ++this->Starts[v + 1];
    }
  }
  std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());
  std::vector<Id> next(this->Starts.begin(), this->Starts.end() - 1);
  for (Id t = 0; t < mesh.numberOfTets(); ++t)
  {
    for (const Id v : mesh.Tets[t])
    {
      this->Tets[next[v]++] = t;
    }
  }
}

} // namespace tetmarch
