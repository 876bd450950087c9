// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/VertexScalars.h"

#include "Mesh/LinearFit.h"
#include "Mesh/Orientation.h"
#include "Mesh/SharedVertices.h"
#include "Parallel/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace tetmarch
{
namespace
{

// A cell around a vertex, relative to it.
struct Site
{
  Vector3 Step; // to the centre of the cell
  double Scalar;
  double Weight; // inverse squared distance
};

class CellFit
{
public:
  CellFit(const TetMesh& mesh, const VertexTets& around, const std::vector<std::uint8_t>& takesPart,
    const std::vector<float>& scalars)
    : Mesh(mesh)
    , Around(around)
    , TakesPart(takesPart)
    , Scalars(scalars)
  {
    this->findCenters();
  }

  void findSites(Id vertex, std::vector<Id>& tets, std::vector<Site>& sites) const
  {
    tets.clear();
    std::copy_if(this->Around.begin(vertex), this->Around.end(vertex), std::back_inserter(tets),
      [this](Id t) { return this->TakesPart[t] != 0; });
    const auto& cells = this->Mesh.TetCells;
    std::sort(tets.begin(), tets.end(),
      [&](Id a, Id b) { return std::make_pair(cells[a], a) < std::make_pair(cells[b], b); });
    tets.erase(
      std::unique(tets.begin(), tets.end(), [&](Id a, Id b) { return cells[a] == cells[b]; }),
      tets.end());
    sites.clear();
    for (const Id t : tets)
    {
      const Vector3 step = this->Centers[cells[t]] - position(this->Mesh.Vertices[vertex]);
      // The centre of a non-convex cell can coincide with a vertex.
      const double square = std::max(dot(step, step), LeastSquare);
      sites.push_back({ step, double(this->Scalars[t]), 1 / square });
    }
  }

  static float valueOf(const std::vector<Site>& sites)
  {
    if (sites.empty())
    {
      return UndrawnScalar;
    }
    double low = sites[0].Scalar, high = sites[0].Scalar;
    double weights = 0, scalar = 0, roots = 0, mean = 0;
    Vector3 step{};
    for (const Site& site : sites)
    {
      low = std::min(low, site.Scalar);
      high = std::max(high, site.Scalar);
      weights += site.Weight;
      scalar += site.Weight * site.Scalar;
      add(site.Weight, site.Step, step);
      roots += std::sqrt(site.Weight);
      mean += std::sqrt(site.Weight) * site.Scalar;
    }
    scalar /= weights;
    step = scaled(1 / weights, step);
    FittedGradient fit;
    for (const Site& site : sites)
    {
      fit.add(site.Weight, site.Step - step, 0);
    }
    // Solved for the step, so that the fit is a weighted sum over the sites.
    double value = mean / roots;
    for (int k = 0; k < 3; ++k)
    {
      fit.Normal.Right[k] = step[k];
    }
    Vector3 pull;
    if (fit.solve(pull))
    {
      double slope = 0, shares = 0;
      for (const Site& site : sites)
      {
        const double share = site.Weight * dot(site.Step - step, pull);
        slope += share * site.Scalar;
        shares += std::abs(share);
      }
      value = scalar - MostShares / std::max(shares, MostShares) * slope;
    }
    return static_cast<float>(std::min(std::max(value, low), high));
  }

private:
  static constexpr double LeastSquare = 1e-20;
  // Maximum total weight of the deviation from the mean. If centres are nearly coplanar it would be
  // large and arbitrary: it is damped there.
  static constexpr double MostShares = 5;

  // Centres of mass of the tetrahedra that take part, summed in an order independent of the number
  // of threads.
  void findCenters()
  {
    const auto& cells = this->Mesh.TetCells;
    const std::size_t count =
      cells.empty() ? 0 : std::size_t(*std::max_element(cells.begin(), cells.end())) + 1;
    std::vector<double> volumes(count, 0);
    this->Centers.assign(count, {});
    for (Id t = 0; t < this->Mesh.numberOfTets(); ++t)
    {
      if (this->TakesPart[t])
      {
        const double volume = std::abs(signedVolume(this->Mesh, t));
        for (const Id v : this->Mesh.Tets[t])
        {
          add(volume / 4, position(this->Mesh.Vertices[v]), this->Centers[cells[t]]);
        }
        volumes[cells[t]] += volume;
      }
    }
    for (std::size_t c = 0; c < count; ++c)
    {
      this->Centers[c] = volumes[c] > 0 ? scaled(1 / volumes[c], this->Centers[c]) : Vector3{};
    }
  }

  const TetMesh& Mesh;
  const VertexTets& Around;
  const std::vector<std::uint8_t>& TakesPart;
  const std::vector<float>& Scalars;
  std::vector<Vector3> Centers; // of cells
};

// At vertices that pieces of several processes share, from the cells of all of them.
void shareValues(Group& group, const TetMesh& mesh, const CellFit& fit, std::vector<float>& values)
{
  const std::vector<Id> vertices = boundaryVertices(mesh);
  std::vector<Bytes> records;
  std::vector<Id> tets;
  std::vector<Site> sites;
  for (const Id vertex : vertices)
  {
    fit.findSites(vertex, tets, sites);
    records.push_back(bytesOf(sites));
  }
  const auto shared = shareRecords(group, mesh, vertices, records);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    sites.clear();
    for (const Bytes& record : shared[i])
    {
      appendValues(record, sites);
    }
    if (!shared[i].empty())
    {
      values[vertices[i]] = CellFit::valueOf(sites);
    }
  }
}

} // namespace

std::vector<float> vertexScalars(const TetMesh& mesh, const VertexTets& around,
  const std::vector<std::uint8_t>& takesPart, const std::vector<float>& cellScalars, Group* group)
{
  const CellFit fit(mesh, around, takesPart, cellScalars);
  std::vector<float> values(mesh.Vertices.size());
  parallelFor(0, static_cast<vtkIdType>(values.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      std::vector<Id> tets;
      std::vector<Site> sites;
      for (vtkIdType v = first; v < last; ++v)
      {
        fit.findSites(static_cast<Id>(v), tets, sites);
        values[v] = CellFit::valueOf(sites);
      }
    });
  if (group)
  {
    shareValues(*group, mesh, fit, values);
  }
  return values;
}

} // namespace tetmarch
