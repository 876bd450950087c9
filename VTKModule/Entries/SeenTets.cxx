// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Entries/SeenTets.h"

#include "Parallel/ParallelFor.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

// Of a scalar that is not finite; those of the others are less.
constexpr std::uint8_t UndrawnLevel = 255;

// Of a stored scalar; it ascends with them, so that other levels tell which one is greater.
std::uint8_t levelOf(float scalar)
{
  return scalar >= UndrawnScalar ? UndrawnLevel : static_cast<std::uint8_t>(scalar * 254.0f);
}

struct ScalarInterval
{
  float Low;
  float High;
};

ScalarInterval intervalOf(const TetMesh& mesh, const MeshScalars& scalars, std::size_t tet)
{
  if (!scalars.OfCells.empty())
  {
    return { scalars.OfCells[tet], scalars.OfCells[tet] };
  }
  if (!scalars.OfCorners.empty())
  {
    const auto ends =
      std::minmax_element(scalars.OfCorners[tet].begin(), scalars.OfCorners[tet].end());
    return { *ends.first, *ends.second };
  }
  // Without branches, which could not be predicted.
  ScalarInterval all{ UndrawnScalar, 0 };
  for (const Id id : mesh.Tets[tet])
  {
    const float scalar = mesh.Vertices[id].Scalar;
    all = { std::min(all.Low, scalar), std::max(all.High, scalar) };
  }
  return all;
}

} // namespace

TetLevels levelsOf(const TetMesh& mesh, const MeshScalars& scalars)
{
  TetLevels levels;
  levels.OfTets.resize(mesh.Tets.size());
  levels.OfClusters.resize(clustersOf(mesh));
  parallelFor(0, static_cast<vtkIdType>(levels.OfClusters.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto cluster = static_cast<std::size_t>(begin); cluster < static_cast<std::size_t>(end);
           ++cluster)
      {
        LevelInterval all{ UndrawnLevel, 0 };
        for (std::size_t tet = cluster * TetsOfCluster; tet < endOfCluster(mesh, cluster); ++tet)
        {
          const ScalarInterval interval = intervalOf(mesh, scalars, tet);
          const LevelInterval of{ levelOf(interval.Low), levelOf(interval.High) };
          levels.OfTets[tet] = of;
          all = { std::min(all.Low, of.Low), std::max(all.High, of.High) };
        }
        levels.OfClusters[cluster] = all;
      }
    });
  return levels;
}

SeenTets::SeenTets(const VisibleScalars& shown)
  : Runs(shown.Blend->isIsoSurface() ? runsAround(shown.Blend->IsoValues)
                                     : SeenScalars(*shown.Table, shown.Scalars->Range).runs())
  , UndrawnSeen(shown.UndrawnSeen)
{
  for (const SeenRun& run : this->Runs)
  {
    this->Levels.push_back({ run.MostLow >= 1 ? UndrawnLevel : levelOf(run.MostLow),
      run.LeastHigh <= 0 ? -1 : levelOf(run.LeastHigh) });
  }
}

std::uint64_t SeenTets::ofCluster(const TetMesh& mesh, const MeshScalars& scalars,
  const TetLevels& levels, std::size_t cluster) const
{
  const std::size_t first = cluster * TetsOfCluster;
  const std::size_t count = endOfCluster(mesh, cluster) - first;
  const LevelInterval all = levels.OfClusters[cluster];
  // The runs that may be in it.
  const auto begin = std::lower_bound(this->Levels.begin(), this->Levels.end(), all.Low,
    [](const RunLevels& run, int low) { return run.Low < low; });
  const auto end = std::upper_bound(begin, this->Levels.end(), all.High,
    [](int high, const RunLevels& run) { return high < run.High; });
  const bool isDrawn = all.High != UndrawnLevel;
  if (isDrawn && begin == end)
  {
    return 0;
  }
  if (isDrawn && begin->High < all.Low && all.High < begin->Low)
  {
    return ~std::uint64_t(0) >> (TetsOfCluster - count);
  }
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const LevelInterval of = levels.OfTets[first + i];
    bool isSeen = false;
    bool isSure = true;
    for (auto run = begin; run != end; ++run)
    {
      isSeen = isSeen || (of.High > run->High && of.Low < run->Low);
      isSure = isSure && of.High != run->High && of.Low != run->Low;
    }
    // A tetrahedron with a scalar that is not finite is drawn in the NaN colour or not at all.
    isSeen = of.High == UndrawnLevel ? this->UndrawnSeen
             : isSeen || isSure      ? isSeen
                                     : this->sees(mesh, scalars, first + i);
    bits |= std::uint64_t(isSeen ? 1 : 0) << i;
  }
  return bits;
}

bool SeenTets::sees(const TetMesh& mesh, const MeshScalars& scalars, std::size_t tet) const
{
  const ScalarInterval interval = intervalOf(mesh, scalars, tet);
  const auto run = std::lower_bound(this->Runs.begin(), this->Runs.end(), interval.Low,
    [](const SeenRun& before, float low) { return before.MostLow < low; });
  return run != this->Runs.end() && run->LeastHigh <= interval.High;
}

} // namespace tetmarch
