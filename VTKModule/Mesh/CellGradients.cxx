// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Gradients.h"

#include "Mesh/LinearFit.h"
#include "Mesh/Orientation.h"
#include "Parallel/ParallelFor.h"

#include <algorithm>

namespace tetmarch
{

Vector3 gradientIn(const TetMesh& mesh, Id t, const std::array<float, 4>& scalars)
{
  const auto& tet = mesh.Tets[t];
  System3 system;
  for (int i = 0; i < 3; ++i)
  {
    system.Rows[i] = position(mesh.Vertices[tet[i + 1]]) - position(mesh.Vertices[tet[0]]);
    system.Right[i] = double(scalars[i + 1]) - double(scalars[0]);
  }
  return system.solution(system.determinant());
}

std::vector<Gradient> cellGradients(
  const TetMesh& mesh, const std::vector<std::array<float, 4>>& corners)
{
  const auto scalarsOf = [&](Id t)
  {
    const auto& v = mesh.Tets[t];
    const auto& all = mesh.Vertices;
    return corners.empty() ? std::array<float, 4>{ { all[v[0]].Scalar, all[v[1]].Scalar,
                               all[v[2]].Scalar, all[v[3]].Scalar } }
                           : corners[t];
  };
  std::vector<Gradient> gradients(mesh.Tets.size(), Gradient{});
  parallelFor(0, static_cast<vtkIdType>(gradients.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (Id t = static_cast<Id>(first); t < static_cast<Id>(last); ++t)
      {
        const std::array<float, 4> scalars = scalarsOf(t);
        if (*std::max_element(scalars.begin(), scalars.end()) != UndrawnScalar &&
            volumeSign(mesh, t) != 0)
        {
          const Vector3 g = gradientIn(mesh, t, scalars);
          gradients[t] = { { static_cast<float>(g[0]), static_cast<float>(g[1]),
            static_cast<float>(g[2]) } };
        }
      }
    });
  return gradients;
}

} // namespace tetmarch
