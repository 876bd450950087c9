// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra whose scalars are seen. Scalars are compared by levels of a byte first, cluster by
// cluster, so that an edit of a transfer function reads the scalars of few tetrahedra.
#ifndef TetMarchEntriesSeenTets_h
#define TetMarchEntriesSeenTets_h

#include "Entries/VisiblePart.h"
#include "Scalars/SeenScalars.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetmarch
{

/** Consecutive tetrahedra, which are neighbours along the space-filling curve. */
constexpr std::size_t TetsOfCluster = 64;

inline std::size_t clustersOf(const TetMesh& mesh)
{
  return (mesh.Tets.size() + TetsOfCluster - 1) / TetsOfCluster;
}

/** The tetrahedron behind the last one of a cluster. */
inline std::size_t endOfCluster(const TetMesh& mesh, std::size_t cluster)
{
  return std::min((cluster + 1) * TetsOfCluster, mesh.Tets.size());
}

/** Whether the bit of a tetrahedron is set (VisiblePart::Tets). */
inline bool hasTet(const std::vector<std::uint32_t>& tets, std::size_t tet)
{
  return (tets[tet / 32] >> (tet % 32) & 1u) != 0;
}

/** The levels of the least and of the greatest scalar of tetrahedra. */
struct LevelInterval
{
  std::uint8_t Low;
  std::uint8_t High;
};

/** The intervals of all tetrahedra, and of their clusters. */
struct TetLevels
{
  std::vector<LevelInterval> OfTets;
  std::vector<LevelInterval> OfClusters;
};

/** Parallel. */
TetLevels levelsOf(const TetMesh& mesh, const MeshScalars& scalars);

/** The scalars that are seen, and the tetrahedra that have any of them. */
class SeenTets
{
public:
  explicit SeenTets(const VisibleScalars& shown);

  /** Whether the same scalars are seen. */
  bool operator==(const SeenTets& other) const
  {
    return this->Runs == other.Runs && this->UndrawnSeen == other.UndrawnSeen;
  }
  /** One bit for each tetrahedron of a cluster; the levels are those of the mesh. */
  std::uint64_t ofCluster(const TetMesh& mesh, const MeshScalars& scalars, const TetLevels& levels,
    std::size_t cluster) const;

private:
  bool sees(const TetMesh& mesh, const MeshScalars& scalars, std::size_t tet) const;

  // The levels of a run's MostLow and LeastHigh; those that any scalar keeps are 255 and -1.
  struct RunLevels
  {
    int Low;
    int High;
  };

  std::vector<SeenRun> Runs;
  std::vector<RunLevels> Levels; // of Runs
  bool UndrawnSeen;
};

} // namespace tetmarch

#endif
