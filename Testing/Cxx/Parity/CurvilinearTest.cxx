// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A curvilinear grid, whose cells are computed, looks like its hexahedra.
#include "CurvilinearGrids.h"
#include "CutScene.h"
#include "GridTransforms.h"
#include "ScenePage.h"
#include "StoredCells.h"

#include "vtkBoundingBox.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkTetMarchFrameStatistics.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;

constexpr std::array<int, 3> Size{ { 9, 12, 7 } };

struct Case
{
  const char* Name;
  std::function<void(LitScene&)> Set;
};

void unlit(LitScene& scene) { scene.property()->ShadeOff(); }

const Case Cases[] = {
  { "points", unlit },
  { "cells",
    [](LitScene& scene)
    {
      unlit(scene);
      scene.drawCellScalars();
    } },
  { "isosurfaces",
    [](LitScene& scene)
    {
      scene.Mapper->SetBlendModeToIsoSurface();
      scene.property()->GetIsoSurfaceValues()->SetValue(0, 0.5);
    } },
  { "maximum",
    [](LitScene& scene)
    {
      unlit(scene);
      scene.Mapper->SetBlendModeToMaximumIntensity();
    } },
  { "mostly transparent", [](LitScene& scene) { setSpikyFunctions(scene.property()); } },
  { "clipped, from inside",
    [](LitScene& scene)
    {
      unlit(scene);
      clipObliquely(scene);
      lookFromInside(scene.camera());
    } },
  { "light", [](LitScene&) {} },
  { "gradients of cells, and gradient opacity",
    [](LitScene& scene)
    {
      scene.addGradientOpacity();
      scene.Mapper->SetGradientTypeToCell();
    } },
  { "shadows", [](LitScene& scene) { scene.Mapper->SetShadowMethodToAtVertices(); } },
  { "shadows along rays", [](LitScene& scene) { scene.Mapper->SetShadowMethodToAlongRays(); } },
};

TEST(Curvilinear, LooksLikeItsHexahedra)
{
  for (const NamedMovement& movement : everyMovement())
  {
    const auto grid = curvilinearGrid(Size, movement.Move);
    // A stored hexahedron is cut along other diagonals if points of it coincide.
    const Grid cells =
      movement.Joined ? inTetrahedra(withStoredCells(grid)) : withStoredCells(grid);
    for (const Case& c : Cases)
    {
      if (!movement.Computed && &c != Cases)
      {
        break; // both have stored cells
      }
      const std::string name = std::string(movement.Name) + ", " + c.Name;
      SCOPED_TRACE(name);
      LitScene stored(cells);
      LitScene computed(stored.Data);
      computed.Mapper->SetInputDataObject(grid);
      c.Set(stored);
      c.Set(computed);
      const Image expected = stored.render();
      const Difference difference = compare(computed.render(), expected);
      // Vertices are numbered otherwise: each sum in another order.
      EXPECT_LE(difference.Rms, 0.05 / 255.0);
      EXPECT_LE(difference.Max, 1.0 / 255.0);
      EXPECT_EQ(computed.Mapper->GetNumberOfTetrahedra(),
        movement.Joined ? 6 * grid->GetNumberOfCells() : stored.Mapper->GetNumberOfTetrahedra());
      EXPECT_EQ(computed.Mapper->GetNumberOfLostRays(), 0);
      std::cout << "[ MEASURED ] " << name << ": " << difference.text() << "\n";
    }
  }
}

TEST(Curvilinear, BlankedCellsAndChanges)
{
  const auto grid = curvilinearGrid(Size, everyMovement()[2].Move);
  Scene computed(withStoredCells(grid));
  computed.Mapper->SetInputDataObject(grid);
  const auto expectSame = [&](const char* change)
  {
    SCOPED_TRACE(change);
    Scene stored(withStoredCells(grid));
    EXPECT_LE(compare(computed.render(), stored.render()).Max, 1.0 / 255.0);
    return computed.frame();
  };
  const Image whole = expectSame("none");
  keepScenePage(computed.Window);
  EXPECT_EQ(vtkBoundingBox(computed.Mapper->GetBounds()), vtkBoundingBox(grid->GetBounds()));
  for (vtkIdType cell = 100; cell < 400; ++cell)
  {
    grid->BlankCell(cell);
  }
  grid->Modified();
  const Image blanked = expectSame("blanked cells");
  EXPECT_GT(compare(blanked, whole).Max, 0.02);
  grid->BlankPoint(0);
  grid->Modified();
  expectSame("a blanked point");
  double place[3];
  grid->GetPoint(555, place);
  grid->GetPoints()->SetPoint(555, place[0] + 0.02, place[1], place[2]);
  grid->GetPoints()->Modified();
  grid->Modified();
  EXPECT_GT(compare(expectSame("a moved point"), blanked).Max, 0.0);
}

// Where a ring closes, its first and last points may have other values. Then its cells are stored.
TEST(Curvilinear, ValuesJumpAtASeam)
{
  const auto grid = curvilinearGrid(Size, everyMovement()[4].Move);
  vtkDataArray* values = grid->GetPointData()->GetScalars();
  for (vtkIdType p = 0; p < values->GetNumberOfTuples(); ++p)
  {
    values->SetComponent(p, 0, double(p / (Size[0] + 1) % (Size[1] + 1)) / Size[1]);
  }
  Scene stored(withStoredCells(grid));
  Scene alone(stored.Data);
  alone.Mapper->SetInputDataObject(grid);
  const Image expected = stored.render();
  EXPECT_LE(compare(alone.render(), expected).Max, 1.0 / 255.0);
  for (vtkIdType p = 0; p < values->GetNumberOfTuples(); ++p)
  {
    values->SetComponent(p, 0, 0.5);
  }
  const vtkTypeInt64 bytes = alone.Mapper->GetGPUMemoryBytes();
  values->Modified();
  EXPECT_GT(compare(alone.render(), expected).Max, 0.1);
  EXPECT_LT(alone.Mapper->GetGPUMemoryBytes(), bytes - 100 * grid->GetNumberOfCells());
  keepScenePage(alone.Window);
}

TEST(Curvilinear, PicksAndGroundTruth)
{
  const auto grid = curvilinearGrid(Size, everyMovement()[3].Move);
  Scene stored(withStoredCells(grid), 64, 64);
  Scene computed(stored.Data, 64, 64);
  computed.Mapper->SetInputDataObject(grid);
  stored.render();
  computed.render();
  ASSERT_TRUE(computed.Mapper->CompareWithGroundTruth(computed.Volume));
  vtkTetMarchFrameStatistics* statistics = computed.Mapper->GetLastFrameStatistics();
  EXPECT_GT(statistics->GetNumberOfPixels(vtkTetMarchFrameStatistics::TRUE_ERROR), 500);
  EXPECT_LE(statistics->GetPercentile(vtkTetMarchFrameStatistics::TRUE_ERROR, 99.5),
    statistics->GetMaximum(vtkTetMarchFrameStatistics::ERROR_BOUND) + 1e-4);
  int hits = 0;
  for (int pixel = 0; pixel < 64 * 64; pixel += 97)
  {
    const int x = pixel % 64, y = pixel / 64;
    const bool hit = computed.Mapper->Pick(computed.Renderer, computed.Volume, x, y);
    ASSERT_EQ(stored.Mapper->Pick(stored.Renderer, stored.Volume, x, y), hit);
    EXPECT_EQ(computed.Mapper->GetPickedCellId(), stored.Mapper->GetPickedCellId());
    hits += hit ? 1 : 0;
  }
  EXPECT_GT(hits, 5);
}
} // namespace
