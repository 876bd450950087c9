// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The mesh is made once for each grid, and a grid that fails is tried once. Whatever memory is
// refused gives an error, and nothing remains of it.
#include "Mesh/MeshStage.h"

#include "Caching/WithinMemory.h"
#include "Grids.h"
#include "Optics/IntegralTable.h"
#include "ScarceMemory.h"
#include "UnitMeshes.h"

#include "vtkPoints.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

const Progress NoProgress;

bool operator==(const TetMesh& a, const TetMesh& b)
{
  const auto same = [](const auto& x, const auto& y)
  {
    return x.size() == y.size() &&
           (x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0])) == 0);
  };
  return a.Tets == b.Tets && a.Links == b.Links && same(a.BoundaryFaces, b.BoundaryFaces) &&
         same(a.Hierarchy, b.Hierarchy) && same(a.Vertices, b.Vertices) &&
         a.ReentryNodes == b.ReentryNodes && a.ReentryFaces == b.ReentryFaces;
}

TEST(MeshStage, MadeOnceAGrid)
{
  MeshStage stage;
  const Grid grid = jitteredLattice(3);
  EXPECT_FALSE(stage.isCurrent(grid));
  EXPECT_EQ(stage.make(grid, {}, NoProgress), "");
  EXPECT_TRUE(stage.isCurrent(grid));
  EXPECT_EQ(stage.record().Runs, 1);
  EXPECT_TRUE(stage.isCurrent(jitteredLattice(3)));
  EXPECT_FALSE(stage.isCurrent(jitteredLattice(3, 0.1)));
  grid->GetPoints()->SetPoint(5, 0.3, 0.4, 0.0);
  grid->GetPoints()->Modified();
  EXPECT_FALSE(stage.isCurrent(grid));
}

TEST(MeshStage, AFailureIsMetOnce)
{
  MeshStage stage;
  const Grid grid = jitteredLattice(3);
  grid->GetPoints()->SetPoint(5, std::numeric_limits<double>::infinity(), 0.0, 0.0);
  const std::string error = stage.make(grid, {}, NoProgress);
  EXPECT_NE(error.find("point 5"), std::string::npos) << error;
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_FALSE(stage.isCurrent(grid));
    EXPECT_EQ(stage.make(grid, {}, NoProgress), error);
    EXPECT_TRUE(stage.mesh().Tets.empty());
  }
  EXPECT_EQ(stage.record().Runs, 1);
  // Another grid meanwhile.
  const Grid other = jitteredLattice(2);
  EXPECT_EQ(stage.make(other, {}, NoProgress), "");
  EXPECT_EQ(stage.make(grid, {}, NoProgress), error);
  EXPECT_FALSE(stage.isCurrent(other));
  // The array is mended; Modified() is called for the grid alone.
  grid->GetPoints()->SetPoint(5, 0.3, 0.4, 0.0);
  EXPECT_EQ(stage.make(grid, {}, NoProgress), error);
  grid->Modified();
  EXPECT_EQ(stage.make(grid, {}, NoProgress), "");
  EXPECT_TRUE(stage.isCurrent(grid));
  EXPECT_EQ(stage.record().Runs, 4);
}

TEST(MeshStage, TooLargeIsNotEvenTried)
{
  MeshStage stage;
  const Grid grid = jitteredLattice(3); // 162 tetrahedra, in two buffers of 81
  for (const ResourceLimits& tight : { ResourceLimits{ 80, 0 }, ResourceLimits{ 1 << 27, 2591 } })
  {
    EXPECT_NE(stage.make(grid, tight, NoProgress).find("at least"), std::string::npos);
    EXPECT_EQ(stage.record().Runs, 0);
  }
  EXPECT_EQ(stage.make(grid, { 81, 2592 }, NoProgress), "");
  EXPECT_EQ(stage.record().Runs, 1);
}

TEST(MeshStage, AStoppedBuildIsTriedAgain)
{
  MeshStage stage;
  const Grid grid = jitteredLattice(3);
  EXPECT_EQ(stage.make(grid, {}, [](double) { return false; }), "");
  EXPECT_FALSE(stage.isCurrent(grid));
  EXPECT_TRUE(stage.mesh().Tets.empty());
  EXPECT_EQ(stage.make(grid, {}, NoProgress), "");
  EXPECT_TRUE(stage.isCurrent(grid));
}

TEST(MeshStage, WhicheverAllocationFails)
{
  std::vector<Grid> grids = { latticeWithHole(4, 0.15, 1), mixedCells(2),
    polyhedronLattice(2, 0.1) };
  // Of an exception in another thread VTK's own pool of threads would die.
  if (std::string(vtkSMPTools::GetBackend()) != "STDThread")
  {
    grids.push_back(jitteredLattice(14));
  }
  for (const Grid& grid : grids)
  {
    MeshStage sound;
    ASSERT_EQ(sound.make(grid, {}, NoProgress), "");
    MeshStage stage;
    int failures = 0;
    vtkObject::GlobalWarningDisplayOff(); // VTK complains of objects whose constructors throw
    for (int i = 0; i < 100000; ++i)
    {
      std::string error;
      bool failed = false;
      {
        const ScarceMemory scarce(512, i);
        error = stage.make(grid, {}, NoProgress);
        failed = ScarceMemory::failures() > 0;
      }
      if (!failed)
      {
        EXPECT_EQ(error, "");
        break;
      }
      ++failures;
      if (error.empty()) // std::stable_partition does without
      {
        EXPECT_TRUE(stage.mesh() == sound.mesh());
        stage = {};
        continue;
      }
      EXPECT_NE(error.find("too little memory for preparing the mesh"), std::string::npos) << error;
      EXPECT_FALSE(stage.isCurrent(grid));
      EXPECT_TRUE(stage.mesh().Tets.empty());
      grid->Modified();
    }
    vtkObject::GlobalWarningDisplayOn();
    EXPECT_GT(failures, 10);
    EXPECT_TRUE(stage.isCurrent(grid));
    EXPECT_TRUE(stage.mesh() == sound.mesh());
    std::cout << "[ MEASURED ] " << failures << " allocations failed one by one\n";
  }
}

// Or doesn't matter: std::stable_partition does without.
TEST(MeshStage, WhicheverAllocationOfTheHierarchyFails)
{
  const Grid grid = jitteredLattice(5);
  const TetMesh complete = builtWithHierarchy(grid);
  int failures = 0;
  bool failed = true;
  for (int i = 0; failed; ++i)
  {
    MeshStage stage;
    ASSERT_EQ(stage.make(grid, {}, NoProgress), "");
    ASSERT_FALSE(stage.mesh().hasHierarchy());
    const TetMesh before = stage.mesh();
    std::string error;
    {
      const ScarceMemory scarce(512, i);
      error = stage.addHierarchy();
      failed = ScarceMemory::failures() > 0;
    }
    failures += error.empty() ? 0 : 1;
    ASSERT_TRUE(error.empty() || error.find("search tree") != std::string::npos) << error;
    ASSERT_TRUE(stage.mesh() == (error.empty() ? complete : before)) << "after allocation " << i;
    ASSERT_TRUE(failed || error.empty());
  }
  EXPECT_GT(failures, 3);
}

TEST(WithinMemory, LengthsPastAnyMemory)
{
  std::vector<double> values;
  const std::string error =
    withinMemory("the values", [&] { values.resize(values.max_size() + 1); });
  EXPECT_NE(error.find("too little memory for the values"), std::string::npos) << error;
  EXPECT_EQ(withinMemory("nothing", [] {}), "");
}
} // namespace
