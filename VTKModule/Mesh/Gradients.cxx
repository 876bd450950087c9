// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Gradients.h"

#include "Mesh/LinearFit.h"
#include "Mesh/Orientation.h"
#include "Mesh/VertexScalars.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tetmarch
{
namespace
{

bool isDrawn(float scalar) { return scalar != UndrawnScalar; }

Gradient rounded(const Vector3& g)
{
  return { { static_cast<float>(g[0]), static_cast<float>(g[1]), static_cast<float>(g[2]) } };
}

// For each tetrahedron whether it has a volume and all of its scalars are drawn.
template <typename IsKnown>
std::vector<std::uint8_t> findWhatTakesPart(const TetMesh& mesh, IsKnown&& isKnown)
{
  std::vector<std::uint8_t> takesPart(mesh.Tets.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(takesPart.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        const auto t = static_cast<Id>(i);
        takesPart[i] = isKnown(t) && volumeSign(mesh, t) != 0 ? 1 : 0;
      }
    });
  return takesPart;
}

std::vector<std::uint8_t> findWhatTakesPart(const TetMesh& mesh)
{
  return findWhatTakesPart(mesh,
    [&](Id t)
    {
      const auto& tet = mesh.Tets[t];
      return std::all_of(
        tet.begin(), tet.end(), [&](Id v) { return isDrawn(mesh.Vertices[v].Scalar); });
    });
}

// One scalar a vertex.
struct Field
{
  const TetMesh& Mesh;
  const std::vector<std::uint8_t>& TakesPart;
  const std::vector<float>& Scalars;

  Vector3 step(Id from, Id to) const
  {
    return position(this->Mesh.Vertices[to]) - position(this->Mesh.Vertices[from]);
  }

  double change(Id from, Id to) const
  {
    return double(this->Scalars[to]) - double(this->Scalars[from]);
  }

  // The tetrahedron has a volume.
  Vector3 gradientIn(Id t) const
  {
    const auto& tet = this->Mesh.Tets[t];
    System3 system;
    for (int i = 0; i < 3; ++i)
    {
      system.Rows[i] = this->step(tet[0], tet[i + 1]);
      system.Right[i] = this->change(tet[0], tet[i + 1]);
    }
    return system.solution(system.determinant());
  }
};

class VertexEstimator
{
public:
  VertexEstimator(const Field& field, const VertexTets& around)
    : Values(field)
    , Around(around)
  {
  }

  Vector3 estimate(Id vertex, std::vector<Id>& neighbours) const
  {
    this->findNeighbours(vertex, neighbours);
    FittedGradient fit;
    for (const Id other : neighbours)
    {
      const Vector3 step = this->Values.step(vertex, other);
      fit.add(1 / dot(step, step), step, this->Values.change(vertex, other));
    }
    Vector3 gradient;
    return fit.solve(gradient) ? gradient : this->meanOfTets(vertex);
  }

private:
  template <typename Visit>
  void forEachTet(Id vertex, Visit&& visit) const
  {
    std::for_each(this->Around.begin(vertex), this->Around.end(vertex),
      [&](Id t)
      {
        if (this->Values.TakesPart[t])
        {
          visit(t);
        }
      });
  }

  // The mean of the gradients in the tetrahedra, weighted by their volumes.
  Vector3 meanOfTets(Id vertex) const
  {
    Vector3 sum{};
    double volumes = 0;
    this->forEachTet(vertex,
      [&](Id t)
      {
        const double volume = std::abs(signedVolume(this->Values.Mesh, t));
        add(volume, this->Values.gradientIn(t), sum);
        volumes += volume;
      });
    return volumes > 0 ? scaled(1 / volumes, sum) : sum;
  }

  // No other vertex is in the same place: each shares a tetrahedron with volume with this one.
  void findNeighbours(Id vertex, std::vector<Id>& neighbours) const
  {
    neighbours.clear();
    this->forEachTet(vertex,
      [&](Id t)
      {
        const auto& tet = this->Values.Mesh.Tets[t];
        std::copy_if(tet.begin(), tet.end(), std::back_inserter(neighbours),
          [vertex](Id v) { return v != vertex; });
      });
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  }

  const Field& Values;
  const VertexTets& Around;
};

std::vector<Gradient> atVertices(const Field& field, const VertexTets& around)
{
  const VertexEstimator estimator(field, around);
  std::vector<Gradient> gradients(field.Mesh.Vertices.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(gradients.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      std::vector<Id> neighbours;
      for (vtkIdType v = first; v < last; ++v)
      {
        gradients[v] = rounded(estimator.estimate(static_cast<Id>(v), neighbours));
      }
    });
  return gradients;
}

std::vector<float> scalarsOf(const TetMesh& mesh)
{
  std::vector<float> scalars;
  scalars.reserve(mesh.Vertices.size());
  for (const Vertex& v : mesh.Vertices)
  {
    scalars.push_back(v.Scalar);
  }
  return scalars;
}

} // namespace

std::vector<Gradient> vertexGradients(const TetMesh& mesh)
{
  const auto takesPart = findWhatTakesPart(mesh);
  const auto scalars = scalarsOf(mesh);
  return atVertices({ mesh, takesPart, scalars }, VertexTets(mesh));
}

std::vector<Gradient> vertexGradients(const TetMesh& mesh, const std::vector<float>& cellScalars)
{
  const VertexTets around(mesh);
  const auto takesPart = findWhatTakesPart(mesh, [&](Id t) { return isDrawn(cellScalars[t]); });
  const auto scalars = vertexScalars(mesh, around, takesPart, cellScalars);
  return atVertices({ mesh, takesPart, scalars }, around);
}

std::vector<Gradient> cellGradients(const TetMesh& mesh)
{
  const auto takesPart = findWhatTakesPart(mesh);
  const auto scalars = scalarsOf(mesh);
  const Field field{ mesh, takesPart, scalars };
  std::vector<Gradient> gradients(mesh.Tets.size(), Gradient{});
  vtkSMPTools::For(0, static_cast<vtkIdType>(gradients.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType t = first; t < last; ++t)
      {
        if (takesPart[t])
        {
          gradients[t] = rounded(field.gradientIn(static_cast<Id>(t)));
        }
      }
    });
  return gradients;
}

} // namespace tetmarch
