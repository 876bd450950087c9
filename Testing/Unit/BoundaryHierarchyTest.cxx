// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The hierarchy holds every boundary face once, and finds every entry that a search over all finds.
#include "Mesh/BoundaryHierarchy.h"
#include "Mesh/TetMeshBuilder.h"
#include "Reference/PointKernel.h"
#include "Reference/PortablePointKernel.h"

#include "RandomRays.h"
#include "UnitMeshes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// Checks the subtree at a node and returns the node behind it.
std::size_t checkSubtree(const TetMesh& mesh, std::size_t node, int depth, std::vector<int>& seen,
  std::array<float, 3>& low, std::array<float, 3>& high)
{
  EXPECT_LT(depth, MostHierarchyDepth);
  const HierarchyNode& n = mesh.Hierarchy[node];
  low.fill(2.0f);
  high.fill(-2.0f);
  std::size_t next = node + 1;
  if (n.FirstFace >= 0)
  {
    for (int i = 0; i < static_cast<int>(n.Second); ++i)
    {
      const auto f = static_cast<std::size_t>(n.FirstFace) + static_cast<std::size_t>(i);
      ++seen.at(f);
      for (int corner = 0; corner < 3; ++corner)
      {
        const Vertex& v = mesh.Vertices[mesh.BoundaryFaces[f][corner]];
        const float p[3] = { v.X, v.Y, v.Z };
        for (int k = 0; k < 3; ++k)
        {
          low[k] = std::min(low[k], p[k]);
          high[k] = std::max(high[k], p[k]);
        }
      }
    }
  }
  else
  {
    EXPECT_GE(n.FirstFace, -3.0f);
    for (int child = 0; child < 2; ++child)
    {
      std::array<float, 3> childLow, childHigh;
      if (child == 1)
      {
        EXPECT_EQ(static_cast<float>(next), n.Second) << "the second child";
      }
      next = checkSubtree(mesh, next, depth + 1, seen, childLow, childHigh);
      for (int k = 0; k < 3; ++k)
      {
        low[k] = std::min(low[k], childLow[k]);
        high[k] = std::max(high[k], childHigh[k]);
      }
    }
  }
  for (int k = 0; k < 3; ++k)
  {
    // With the margin for the rounding of projections (a few 1e-7).
    EXPECT_LE(n.Center[k] - n.HalfSize[k], low[k] - 3e-6f);
    EXPECT_GE(n.Center[k] + n.HalfSize[k], high[k] + 3e-6f);
  }
  return next;
}

// Two trees, one of which may be empty: of the faces for re-entries, and of the others.
void checkTrees(const TetMesh& mesh)
{
  std::vector<int> seen(mesh.BoundaryFaces.size(), 0);
  std::array<float, 3> low, high;
  bool partsAtReentry = mesh.ReentryNodes == 0;
  int trees = 0;
  for (std::size_t node = 0; node < mesh.Hierarchy.size(); ++trees)
  {
    node = checkSubtree(mesh, node, 0, seen, low, high);
    partsAtReentry = partsAtReentry || node == mesh.ReentryNodes;
  }
  EXPECT_TRUE(partsAtReentry);
  EXPECT_LE(trees, 2);
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(seen.size()));
  EXPECT_LE(mesh.Hierarchy.size(), 2 * mesh.BoundaryFaces.size());
}

TEST(BoundaryHierarchy, EveryFaceIsInOneLeafAndInItsBoxes)
{
  for (const NamedGrid& named : everyGrid())
  {
    SCOPED_TRACE(named.Name);
    checkTrees(builtWithHierarchy(named.Make()));
  }
}

TEST(BoundaryHierarchy, ManyFacesInOnePlace)
{
  // Boxes that no cut can part: copies of one tetrahedron that share no point.
  Grid grid = singleTet();
  for (int doubling = 0; doubling < 9; ++doubling)
  {
    grid = joined(grid, grid);
  }
  TetMesh mesh = builtApart(grid);
  ensureHierarchy(mesh);
  EXPECT_EQ(mesh.BoundaryFaces.size(), 4u * 512);
  checkTrees(mesh);
}

// Several of its subtrees are built in threads.
TEST(BoundaryHierarchy, ManyFaces)
{
  TetMesh mesh = builtApart(withRepeatedPoints(jitteredLattice(12)));
  ensureHierarchy(mesh);
  EXPECT_EQ(mesh.BoundaryFaces.size(), 4u * 6 * 12 * 12 * 12);
  checkTrees(mesh);
}

using Entries = std::vector<std::pair<double, int>>;

template <typename Kernel>
Entries entriesByHierarchy(Kernel& kernel, const typename Kernel::Ray& ray, bool amongAll)
{
  Entries entries;
  typename Kernel::Entry entry;
  entry.depth = -3e38f;
  entry.face = -1;
  for (entry = kernel.nextEntry(ray, entry, amongAll); entry.face >= 0 && entries.size() < 100;
       entry = kernel.nextEntry(ray, entry, amongAll))
  {
    entries.emplace_back(double(entry.depth), entry.face);
  }
  return entries;
}

template <typename Kernel>
Entries entriesByBruteForce(Kernel& kernel, const typename Kernel::Ray& ray, Id faces)
{
  Entries entries;
  for (Id b = 0; b < faces; ++b)
  {
    typename Kernel::FaceIntersection face;
    if (kernel.enters(ray, b, face))
    {
      entries.emplace_back(double(kernel.intersectionPoint(face).x), static_cast<int>(b));
    }
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

// Boundary faces in the leaves of the first nodes: they come in that order.
Id facesOfNodes(const TetMesh& mesh, std::size_t nodes)
{
  Id faces = 0;
  for (std::size_t n = 0; n < nodes; ++n)
  {
    faces += mesh.Hierarchy[n].FirstFace >= 0 ? static_cast<Id>(mesh.Hierarchy[n].Second) : 0;
  }
  return faces;
}

template <typename Kernel, typename Real>
void expectSameEntries(const TetMesh& mesh, int rays, std::size_t& mostEntries)
{
  Kernel kernel = kernelOf<Kernel, Real>(mesh, whiteTable());
  const Id all = facesOfNodes(mesh, mesh.Hierarchy.size());
  const Id reentries = facesOfNodes(mesh, mesh.ReentryNodes);
  ASSERT_EQ(all, mesh.BoundaryFaces.size());
  ASSERT_EQ(reentries, mesh.ReentryFaces);
  RandomRays random(17);
  for (int i = 0; i < rays; ++i)
  {
    const auto ray = random.next<Kernel, Real>(kernel, mesh);
    const Entries expected = entriesByBruteForce(kernel, ray, all);
    ASSERT_EQ(entriesByHierarchy(kernel, ray, true), expected) << i;
    ASSERT_EQ(entriesByHierarchy(kernel, ray, false), entriesByBruteForce(kernel, ray, reentries))
      << i;
    mostEntries = std::max(mostEntries, expected.size());
  }
}

TEST(BoundaryHierarchy, FindsEveryEntryInOrder)
{
  // 36,000 rays in all.
  const auto check = [](vtkUnstructuredGrid* grid, std::size_t leastReentries)
  {
    TetMesh mesh = builtApart(grid);
    ensureHierarchy(mesh);
    std::size_t most = 0;
    expectSameEntries<PointKernel<float>, float>(mesh, 2000, most);
    expectSameEntries<PointKernel<double>, double>(mesh, 2000, most);
    expectSameEntries<PortablePointKernel<float>, float>(mesh, 2000, most);
    EXPECT_GE(most, leastReentries);
  };
  check(nestedShells(8), 4);
  check(latticeWithHole(6), 2);
  check(twoComponents(4), 2);
  check(jitteredLattice(4, 0.0), 1);
  check(defectiveTets(), 1);
  check(joined(jitteredLattice(2), jitteredLattice(2)), 2);
}
} // namespace
