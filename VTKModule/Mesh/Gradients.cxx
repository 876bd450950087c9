// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Gradients.h"

#include "Mesh/LinearFit.h"
#include "Mesh/Orientation.h"
#include "Mesh/SharedVertices.h"
#include "Mesh/VertexScalars.h"
#include "Parallel/ParallelFor.h"

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
  parallelFor(0, static_cast<vtkIdType>(takesPart.size()),
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

  Vector3 gradientIn(Id t) const
  {
    const auto& tet = this->Mesh.Tets[t];
    const auto& of = this->Scalars;
    return tetmarch::gradientIn(
      this->Mesh, t, { { of[tet[0]], of[tet[1]], of[tet[2]], of[tet[3]] } });
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
    return fit.solve(gradient) ? gradient : this->weightedGradients(vertex).mean();
  }

  // The data of this piece at a vertex that other processes share.
  Bytes recordOf(Id vertex, std::vector<Id>& neighbours) const
  {
    this->findNeighbours(vertex, neighbours);
    const WeightedGradients weighted = this->weightedGradients(vertex);
    std::vector<double> numbers{ weighted.Sum[0], weighted.Sum[1], weighted.Sum[2],
      weighted.Volumes };
    for (const Id other : neighbours)
    {
      const Vector3 there = position(this->Values.Mesh.Vertices[other]);
      numbers.insert(numbers.end(), there.begin(), there.end());
      numbers.push_back(this->Values.Scalars[other]);
    }
    return bytesOf(numbers);
  }

  // The same estimate from the records of all pieces.
  Vector3 estimate(Id vertex, const std::vector<Bytes>& records) const
  {
    WeightedGradients weighted;
    std::vector<std::array<double, 4>> neighbours; // positions and scalars
    for (const Bytes& record : records)
    {
      std::vector<double> numbers;
      appendValues(record, numbers);
      add(1, { { numbers[0], numbers[1], numbers[2] } }, weighted.Sum);
      weighted.Volumes += numbers[3];
      for (std::size_t i = 4; i + 3 < numbers.size(); i += 4)
      {
        neighbours.push_back({ { numbers[i], numbers[i + 1], numbers[i + 2], numbers[i + 3] } });
      }
    }
    const auto isSamePlace = [](const std::array<double, 4>& a, const std::array<double, 4>& b)
    { return std::equal(a.begin(), a.begin() + 3, b.begin()); };
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(
      std::unique(neighbours.begin(), neighbours.end(), isSamePlace), neighbours.end());
    const Vector3 here = position(this->Values.Mesh.Vertices[vertex]);
    FittedGradient fit;
    for (const auto& other : neighbours)
    {
      const Vector3 step = Vector3{ { other[0], other[1], other[2] } } - here;
      fit.add(1 / dot(step, step), step, other[3] - double(this->Values.Scalars[vertex]));
    }
    Vector3 gradient;
    return fit.solve(gradient) ? gradient : weighted.mean();
  }

private:
  // Gradients in tetrahedra, weighted by their volumes.
  struct WeightedGradients
  {
    Vector3 Sum{};
    double Volumes = 0;
    Vector3 mean() const
    {
      return this->Volumes > 0 ? scaled(1 / this->Volumes, this->Sum) : this->Sum;
    }
  };

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

  WeightedGradients weightedGradients(Id vertex) const
  {
    WeightedGradients weighted;
    this->forEachTet(vertex,
      [&](Id t)
      {
        const double volume = std::abs(signedVolume(this->Values.Mesh, t));
        add(volume, this->Values.gradientIn(t), weighted.Sum);
        weighted.Volumes += volume;
      });
    return weighted;
  }

  // No other vertex has the same position: each shares a tetrahedron with volume with this one.
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
  parallelFor(0, static_cast<vtkIdType>(gradients.size()),
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

// At vertices that pieces of several processes share, from the data of all of them.
void shareGradients(
  Group& group, const Field& field, const VertexTets& around, std::vector<Gradient>& gradients)
{
  const VertexEstimator estimator(field, around);
  const std::vector<Id> vertices = boundaryVertices(field.Mesh);
  std::vector<Bytes> records;
  std::vector<Id> neighbours;
  for (const Id vertex : vertices)
  {
    records.push_back(estimator.recordOf(vertex, neighbours));
  }
  const auto shared = shareRecords(group, field.Mesh, vertices, records);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    if (!shared[i].empty())
    {
      gradients[vertices[i]] = rounded(estimator.estimate(vertices[i], shared[i]));
    }
  }
}

std::vector<Gradient> gradientsOf(const Field& field, const VertexTets& around, Group* group)
{
  std::vector<Gradient> gradients = atVertices(field, around);
  if (group)
  {
    shareGradients(*group, field, around, gradients);
  }
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

std::vector<Gradient> vertexGradients(const TetMesh& mesh, Group* group)
{
  const auto takesPart = findWhatTakesPart(mesh);
  const auto scalars = scalarsOf(mesh);
  return gradientsOf({ mesh, takesPart, scalars }, VertexTets(mesh), group);
}

std::vector<Gradient> vertexGradients(
  const TetMesh& mesh, const std::vector<float>& cellScalars, Group* group)
{
  const VertexTets around(mesh);
  const auto takesPart = findWhatTakesPart(mesh, [&](Id t) { return isDrawn(cellScalars[t]); });
  const auto scalars = vertexScalars(mesh, around, takesPart, cellScalars, group);
  return gradientsOf({ mesh, takesPart, scalars }, around, group);
}

std::vector<Gradient> componentGradients(const TetMesh& mesh,
  const std::vector<float>& firstOfCells, const std::vector<float>& extra, std::size_t extraCount,
  Group* group)
{
  const bool ofCells = !firstOfCells.empty();
  const VertexTets around(mesh);
  const auto takesPart = ofCells
                           ? findWhatTakesPart(mesh, [&](Id t) { return isDrawn(firstOfCells[t]); })
                           : findWhatTakesPart(mesh);
  const std::size_t count = 1 + extraCount;
  std::vector<Gradient> gradients(count * mesh.Vertices.size());
  std::vector<float> scalars = ofCells ? firstOfCells : scalarsOf(mesh);
  for (std::size_t k = 0; k < count; ++k)
  {
    for (std::size_t i = 0; k > 0 && i < scalars.size(); ++i)
    {
      scalars[i] = extra[extraCount * i + k - 1];
    }
    const std::vector<float> atVertices =
      ofCells ? vertexScalars(mesh, around, takesPart, scalars, group) : scalars;
    const std::vector<Gradient> own = gradientsOf({ mesh, takesPart, atVertices }, around, group);
    for (std::size_t v = 0; v < own.size(); ++v)
    {
      gradients[count * v + k] = own[v];
    }
  }
  return gradients;
}

} // namespace tetmarch
