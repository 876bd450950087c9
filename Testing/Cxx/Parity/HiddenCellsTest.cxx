// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells that ghost arrays hide: not drawn, no hindrance to rays or light, and hidden without a new
// mesh.
#include "ErrorWatch.h"
#include "GapScene.h"
#include "LitScene.h"

#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"

#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;
using Ghosts = vtkDataSetAttributes;

constexpr int Side = 96;

void showAll(vtkUnstructuredGrid* grid)
{
  grid->GetCellData()->RemoveArray(Ghosts::GhostArrayName());
}

const Place All = [](double, double, double) { return true; };
const Place Slab = [](double, double, double z) { return z > 0.25 && z < 0.75; };
const Place Front = [](double, double, double z) { return z > 0.5; };
const Place Crumbs = isCrumb;

TEST(HiddenCells, LeaveTheOpacityOfTheRest)
{
  for (const bool ofCells : { false, true })
  {
    Scene scene(jitteredLattice(4, 0.0, 1, constantField(0.7)), Side, Side);
    if (ofCells)
    {
      scene.drawCellScalars();
    }
    setPlainFunctions(scene.property(), { 1.0, 0.5, 0.25 }, 0.8);
    scene.property()->SetScalarOpacityUnitDistance(1.0);
    lookDownZ(scene.camera(), 0.4);
    const struct
    {
      Place Hidden;
      double Seen;
    } cases[] = { { [](double, double, double) { return false; }, 1.0 }, { Slab, 0.5 },
      { Front, 0.5 }, { [](double, double, double z) { return z < 0.25; }, 0.75 }, { All, 0.0 } };
    vtkTypeInt64 crossed = 0;
    for (const auto& c : cases)
    {
      hide(scene.Data, c.Hidden);
      const double alpha = -std::expm1(-0.8 * c.Seen);
      const Image picture = scene.render();
      for (std::size_t i = 0; i < picture.Rgba.size(); i += 4)
      {
        ASSERT_NEAR(picture.Rgba[i + 1], 0.5 * alpha, 2e-5) << c.Seen;
        ASSERT_NEAR(picture.Rgba[i + 3], alpha, 2e-5) << c.Seen;
      }
      // What is hidden may be crossed, but need not be.
      crossed = crossed > 0 ? crossed : scene.Mapper->GetNumberOfCrossedCells();
      const auto cells = static_cast<double>(scene.Mapper->GetNumberOfCrossedCells());
      EXPECT_LE(cells, static_cast<double>(crossed));
      EXPECT_GE(cells, 0.99 * c.Seen * static_cast<double>(crossed));
      EXPECT_EQ(scene.Mapper->GetNumberOfRays(), c.Seen > 0.0 ? Side * Side : 0);
      EXPECT_EQ(scene.Mapper->GetNumberOfRefusedEntries(), 0);
      EXPECT_EQ(scene.Mapper->GetNumberOfLostRays(), 0);
    }
    EXPECT_EQ(scene.Mapper->GetMeshBuilds(), 1);
    EXPECT_EQ(scene.Mapper->GetScalarsBuilds(), 1);
    EXPECT_EQ(scene.Mapper->GetTablesBuilds(), 1);
  }
}

// A grid of the cells that aren't hidden.
Grid restOf(vtkUnstructuredGrid* grid, const Place& hidden)
{
  const Grid rest = Grid::New();
  rest->SetPoints(grid->GetPoints());
  rest->GetPointData()->ShallowCopy(grid->GetPointData());
  rest->GetCellData()->CopyAllocate(grid->GetCellData());
  rest->Allocate(grid->GetNumberOfCells());
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (!isAt(grid, cell, hidden))
    {
      grid->GetCellPoints(cell, points);
      rest->GetCellData()->CopyData(
        grid->GetCellData(), cell, rest->InsertNextCell(grid->GetCellType(cell), points));
    }
  }
  return rest;
}

TEST(HiddenCells, LookAsIfTheyWereNotThere)
{
  for (const bool ofCells : { false, true })
  {
    for (const Place& place : { Slab, Front, Crumbs })
    {
      Scene whole(jitteredLattice(6, 0.15, 1, sineField()), Side, Side);
      Scene rest(restOf(whole.Data, place), Side, Side);
      if (ofCells)
      {
        whole.drawCellScalars();
        rest.drawCellScalars();
      }
      hide(whole.Data, place);
      const Difference difference = compare(whole.render(), rest.render());
      EXPECT_LE(difference.Max, 2.0 / 255.0) << difference.text();
      EXPECT_LE(difference.Rms, 0.3 / 255.0) << difference.text();
      EXPECT_GE(whole.Mapper->GetNumberOfTetrahedra(), rest.Mapper->GetNumberOfTetrahedra());
      std::cout << "[ MEASURED ] " << difference.text() << '\n';
    }
  }
}

TEST(HiddenCells, OfAnyKindOfGhost)
{
  Scene scene(jitteredLattice(6, 0.15, 1, sineField()), Side, Side);
  const Image all = scene.render();
  hide(scene.Data, Crumbs);
  const Image hidden = scene.render();
  EXPECT_GT(compare(all, hidden).Max, 0.05);
  const int others =
    Ghosts::EXTERIORCELL | Ghosts::HIGHCONNECTIVITYCELL | Ghosts::LOWCONNECTIVITYCELL;
  for (const int type : { 1, 8, 32, 1 | 16, 8 | 2 })
  {
    hide(scene.Data, Crumbs, type);
    // Duplicates are no part of the mesh, whose rays are rounded otherwise then.
    const double rounding = type & Ghosts::DUPLICATECELL ? 1e-6 : 0.0;
    EXPECT_LE(compare(scene.render(), hidden).Max, rounding) << type;
  }
  hide(scene.Data, Crumbs, others);
  EXPECT_EQ(compare(scene.render(), all).Max, 0.0);
  showAll(scene.Data);
  EXPECT_EQ(compare(scene.render(), all).Max, 0.0);

  // Hidden points hide the cells around them.
  const Place around = [](double x, double y, double z)
  { return std::abs(x - 0.5) < 0.2 && std::abs(y - 0.5) < 0.2 && std::abs(z - 0.5) < 0.2; };
  vtkUnsignedCharArray* ghosts = scene.Data->AllocatePointGhostArray();
  std::vector<bool> touches(static_cast<std::size_t>(scene.Data->GetNumberOfCells()), false);
  vtkNew<vtkIdList> cells;
  for (vtkIdType p = 0; p < scene.Data->GetNumberOfPoints(); ++p)
  {
    double x[3];
    scene.Data->GetPoint(p, x);
    ghosts->SetValue(p, Ghosts::DUPLICATEPOINT);
    if (around(x[0], x[1], x[2]))
    {
      ghosts->SetValue(p, Ghosts::HIDDENPOINT);
      scene.Data->GetPointCells(p, cells);
      for (const vtkIdType cell : *cells)
      {
        touches[static_cast<std::size_t>(cell)] = true;
      }
    }
  }
  ghosts->Modified();
  const Image byPoints = scene.render();
  EXPECT_GT(compare(byPoints, all).Max, 0.05);
  scene.Data->GetPointData()->RemoveArray(Ghosts::GhostArrayName());
  vtkUnsignedCharArray* ofCells = scene.Data->AllocateCellGhostArray();
  for (vtkIdType c = 0; c < scene.Data->GetNumberOfCells(); ++c)
  {
    ofCells->SetValue(c, touches[static_cast<std::size_t>(c)] ? Ghosts::HIDDENCELL : 0);
  }
  ofCells->Modified();
  EXPECT_EQ(compare(scene.render(), byPoints).Max, 0.0);
}

TEST(HiddenCells, ArraysThatDontFitHideNothing)
{
  Scene scene(jitteredLattice(6, 0.15, 1, sineField()), Side, Side);
  const ErrorWatch watch(scene.Mapper);
  const Image all = scene.render();
  const auto expectIgnored = [&](vtkDataArray* ghosts, vtkIdType count)
  {
    ghosts->SetName(Ghosts::GhostArrayName());
    ghosts->SetNumberOfTuples(count);
    ghosts->Fill(Ghosts::HIDDENCELL);
    scene.Data->GetCellData()->AddArray(ghosts);
    EXPECT_EQ(compare(scene.render(), all).Max, 0.0);
    showAll(scene.Data);
  };
  expectIgnored(vtkNew<vtkIntArray>(), scene.Data->GetNumberOfCells());
  expectIgnored(vtkNew<vtkUnsignedCharArray>(), 7);
  EXPECT_TRUE(watch.Errors.empty());
}

// Two processes, each of which has a layer of the other's cells: what both draw is the whole.
TEST(HiddenCells, DuplicatesAtTheBorderOfBlocksAreDrawnOnce)
{
  const Grid grid = jitteredLattice(8, 0.0, 1, sineField());
  const Place front = [](double, double, double z) { return z > 0.5; };
  const Image whole = Scene(grid, Side, Side).render();
  // Two layers of cubes more than is drawn.
  const auto block = [&](const Place& owned, const Place& present, bool flagged)
  {
    const Grid cells =
      restOf(grid, [&](double x, double y, double z) { return !present(x, y, z); });
    if (flagged)
    {
      hide(
        cells, [&](double x, double y, double z) { return !owned(x, y, z); },
        Ghosts::DUPLICATECELL);
    }
    Scene scene(cells, Side, Side);
    return scene.render();
  };
  const auto composed = [&](bool flagged)
  {
    Image near = block(
      front, [](double, double, double z) { return z > 0.25; }, flagged);
    const Image far = block([](double, double, double z) { return z < 0.5; },
      [](double, double, double z) { return z < 0.75; }, flagged);
    for (std::size_t i = 0; i < near.Rgba.size(); ++i)
    {
      near.Rgba[i] += (1.0f - near.Rgba[i - i % 4 + 3]) * far.Rgba[i];
    }
    return near;
  };
  // The camera looks from above the border: what is before it comes first on each ray.
  const Difference once = compare(composed(true), whole);
  EXPECT_LE(once.Rms, 0.3 / 255.0) << once.text();
  EXPECT_LE(once.Max, 2.0 / 255.0) << once.text();
  EXPECT_GT(compare(composed(false), whole).Max, 0.1);
}

// Hidden cells absorb no light, and when others are hidden only the light is made anew.
TEST(HiddenCells, AbsorbNoLight)
{
  LitScene scene(jitteredLattice(8, 0.15, 1, constantField(0.5)), Side, Side);
  setPlainFunctions(scene.property(), { 1.0, 1.0, 1.0 }, 0.9);
  scene.property()->SetAmbient(0.0);
  scene.Sun->SetPosition(0.5, 9.0, 0.5);
  const Place roof = [](double, double y, double) { return y > 0.5; };
  const Grid low = restOf(scene.Data, roof);
  scene.Mapper->SetShadowMethodToAtVertices();
  scene.Mapper->SetVolumetricScatteringBlending(2.0f);
  scene.render();
  EXPECT_EQ(scene.Mapper->GetVertexLightBuilds(), 1);
  const vtkTypeInt64 bytes = scene.Mapper->GetUploadedBytes();
  hide(scene.Data, roof);
  const Image hidden = scene.render();
  EXPECT_EQ(scene.Mapper->GetVertexLightBuilds(), 2);
  EXPECT_EQ(scene.Mapper->GetMeshBuilds(), 1);
  EXPECT_EQ(scene.Mapper->GetGradientsBuilds(), 1);
  // A bit for each tetrahedron is uploaded, and what rays enter the visible ones by; no mesh.
  EXPECT_LT(scene.Mapper->GetUploadedBytes() - bytes, 4 * scene.Mapper->GetNumberOfTetrahedra());
  scene.render();
  EXPECT_EQ(scene.Mapper->GetVertexLightBuilds(), 2);

  LitScene rest(low, Side, Side);
  setPlainFunctions(rest.property(), { 1.0, 1.0, 1.0 }, 0.9);
  rest.property()->SetAmbient(0.0);
  rest.Sun->SetPosition(0.5, 9.0, 0.5);
  rest.Mapper->SetShadowMethodToAtVertices();
  rest.Mapper->SetVolumetricScatteringBlending(2.0f);
  const Difference difference = compare(hidden, rest.render());
  EXPECT_LE(difference.Rms, 1.0 / 255.0) << difference.text();
  std::cout << "[ MEASURED ] " << difference.text() << '\n';
}

TEST(HiddenCells, ShowTheBoundaryOfAll)
{
  Scene scene(jitteredLattice(6, 0.15, 1, sineField()), Side, Side);
  scene.Mapper->SetViewModeToBoundaryFaces();
  scene.Window->Render();
  const Image boundary = scene.frame();
  hide(scene.Data, All);
  scene.Window->Render();
  EXPECT_EQ(compare(scene.frame(), boundary).Max, 0.0);
}
} // namespace
