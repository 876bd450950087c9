// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which tetrahedra ghost arrays hide, and what a ray sees of the others.
#include "Mesh/HiddenCells.h"
#include "Mesh/HiddenCellStage.h"
#include "Mesh/MeshScalars.h"
#include "Reference/CellKernel.h"
#include "Reference/FastPointKernel.h"
#include "Reference/PointKernel.h"

#include "ClosedForms.h"
#include "UnitMeshes.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;
using Ghosts = vtkDataSetAttributes;

bool isHidden(const HiddenCells& hidden, std::size_t t)
{
  return !hidden.empty() && (hidden[t / 32] >> t % 32 & 1u) != 0;
}

std::vector<std::uint8_t> flagsOf(const HiddenCells& hidden, const TetMesh& mesh)
{
  std::vector<std::uint8_t> flags(mesh.Tets.size());
  for (std::size_t t = 0; t < flags.size(); ++t)
  {
    flags[t] = isHidden(hidden, t) ? 1 : 0;
  }
  return flags;
}

TEST(HiddenCells, ByTheBitsOfTheirGhostType)
{
  const Grid grid = singleTet();
  const TetMesh mesh = built(grid);
  vtkUnsignedCharArray* ghosts = grid->AllocateCellGhostArray();
  for (int type = 0; type < 256; ++type)
  {
    ghosts->SetValue(0, static_cast<unsigned char>(type));
    const bool hidden =
      (type & (Ghosts::HIDDENCELL | Ghosts::DUPLICATECELL | Ghosts::REFINEDCELL)) != 0;
    EXPECT_EQ(hiddenCells(grid, mesh), hidden ? HiddenCells{ 1u } : HiddenCells()) << type;
  }
}

TEST(HiddenCells, ByTheBitsOfTheirPoints)
{
  const Grid grid = singleTet();
  const TetMesh mesh = built(grid);
  vtkUnsignedCharArray* ghosts = grid->AllocatePointGhostArray();
  for (vtkIdType point = 0; point < 4; ++point)
  {
    for (int type = 0; type < 256; ++type)
    {
      ghosts->FillValue(0);
      ghosts->SetValue(point, static_cast<unsigned char>(type));
      EXPECT_EQ(hiddenCells(grid, mesh).empty(), (type & Ghosts::HIDDENPOINT) == 0) << type;
    }
  }
}

// All tetrahedra that a cell is cut into, also where none of theirs is the hidden point.
TEST(HiddenCells, AreCellsOfTheGrid)
{
  for (const NamedGrid& named : everyGrid())
  {
    SCOPED_TRACE(named.Name);
    const Grid grid = named.Make();
    const TetMesh mesh = built(grid);
    const vtkIdType last = grid->GetNumberOfCells() - 1;
    const auto cell = static_cast<vtkIdType>(mesh.TetCells[mesh.TetCells.size() / 2]);
    grid->AllocateCellGhostArray()->SetValue(last, Ghosts::EXTERIORCELL);
    grid->GetCellGhostArray()->SetValue(cell, Ghosts::DUPLICATECELL);
    std::vector<std::uint8_t> expected(mesh.Tets.size());
    for (std::size_t t = 0; t < expected.size(); ++t)
    {
      expected[t] = static_cast<vtkIdType>(mesh.TetCells[t]) == cell ? 1 : 0;
    }
    EXPECT_EQ(flagsOf(hiddenCells(grid, mesh), mesh), expected);

    grid->GetCellData()->RemoveArray(Ghosts::GhostArrayName());
    vtkNew<vtkIdList> points;
    grid->GetCellPoints(cell, points);
    const vtkIdType point = points->GetId(points->GetNumberOfIds() - 1);
    grid->AllocatePointGhostArray()->SetValue(point, Ghosts::HIDDENPOINT);
    for (std::size_t t = 0; t < expected.size(); ++t)
    {
      grid->GetCellPoints(static_cast<vtkIdType>(mesh.TetCells[t]), points);
      expected[t] = points->IsId(point) >= 0 ? 1 : 0;
    }
    EXPECT_EQ(flagsOf(hiddenCells(grid, mesh), mesh), expected);
  }
}

TEST(HiddenCells, ArraysThatDontFitAreIgnored)
{
  const Grid grid = jitteredLattice(2);
  const TetMesh mesh = built(grid);
  const auto expectIgnored = [&](vtkDataArray* ghosts, vtkIdType cells, int components)
  {
    ghosts->SetName(Ghosts::GhostArrayName());
    ghosts->SetNumberOfComponents(components);
    ghosts->SetNumberOfTuples(cells);
    ghosts->Fill(Ghosts::HIDDENCELL | Ghosts::HIDDENPOINT);
    for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(grid->GetCellData()),
           static_cast<vtkDataSetAttributes*>(grid->GetPointData()) })
    {
      data->AddArray(ghosts);
      EXPECT_TRUE(hiddenCells(grid, mesh).empty());
      data->RemoveArray(Ghosts::GhostArrayName());
    }
  };
  const vtkIdType cells = grid->GetNumberOfCells();
  ASSERT_NE(cells, grid->GetNumberOfPoints());
  expectIgnored(vtkNew<vtkIntArray>(), cells, 1);
  expectIgnored(vtkNew<vtkUnsignedCharArray>(), cells + 1, 1);
  expectIgnored(vtkNew<vtkUnsignedCharArray>(), 3, 1);
  expectIgnored(vtkNew<vtkUnsignedCharArray>(), cells, 2);
}

TEST(HiddenCells, AreLookedAtAnewWhenGhostsOrMeshChange)
{
  const Grid grid = jitteredLattice(2);
  const TetMesh mesh = built(grid);
  HiddenCellStage stage;
  EXPECT_FALSE(stage.update(grid, mesh, 1));
  EXPECT_FALSE(stage.update(grid, mesh, 2));
  EXPECT_EQ(stage.record().Runs, 0);
  vtkUnsignedCharArray* ghosts = grid->AllocateCellGhostArray();
  EXPECT_TRUE(stage.update(grid, mesh, 2));
  EXPECT_FALSE(stage.update(grid, mesh, 2));
  EXPECT_TRUE(stage.cells().empty());
  ghosts->SetValue(3, Ghosts::HIDDENCELL);
  EXPECT_FALSE(stage.update(grid, mesh, 2)); // Modified() wasn't called
  ghosts->Modified();
  EXPECT_TRUE(stage.update(grid, mesh, 2));
  EXPECT_FALSE(stage.cells().empty());
  EXPECT_TRUE(stage.update(grid, mesh, 3));
  EXPECT_EQ(stage.record().Runs, 3);
  grid->GetCellData()->RemoveArray(Ghosts::GhostArrayName());
  EXPECT_TRUE(stage.update(grid, mesh, 3));
  EXPECT_TRUE(stage.cells().empty());
  EXPECT_EQ(stage.record().Runs, 3);
}

// Along x through a unit cube of layers a quarter thick, of which some are hidden.
struct Layers
{
  explicit Layers(const std::function<bool(int)>& hide)
    : Mesh(builtWithHierarchy(Data))
    , Scalars(Mesh.Tets.size(), 0.0f)
  {
    vtkUnsignedCharArray* ghosts = this->Data->AllocateCellGhostArray();
    for (vtkIdType cell = 0; cell < this->Data->GetNumberOfCells(); ++cell)
    {
      double bounds[6];
      this->Data->GetCellBounds(cell, bounds);
      const int layer = static_cast<int>(2.0 * (bounds[0] + bounds[1]));
      ghosts->SetValue(cell, hide(layer) ? Ghosts::HIDDENCELL : 0);
    }
    readScalars(this->Data, { this->Data->GetPointData()->GetScalars() }, this->Mesh);
    this->Hidden = hiddenCells(this->Data, this->Mesh);
  }

  template <typename Kernel>
  typename Kernel::March cast(double thickness, bool hide = true) const
  {
    auto kernel = kernelOf<Kernel, double>(this->Mesh, whiteTable());
    kernel.CellScalars = this->Scalars.data();
    kernel.HiddenCells = hide && !this->Hidden.empty() ? this->Hidden.data() : nullptr;
    kernel.errorTolerance = 0.0;
    return kernel.castPlainRay(kernel.rayThrough({ 0.0, 0.0123, -0.0071 }, { 1.0, 0.0, 0.0 }),
      thickness * this->Mesh.Frame.Radius, -1e30, 1e30);
  }

  const Grid Data = jitteredLattice(4, 0.0, 1, constantField(0.5));
  TetMesh Mesh;
  std::vector<float> Scalars;
  HiddenCells Hidden;
};

template <typename Kernel>
void expectOpacities()
{
  const struct
  {
    std::function<bool(int)> Hide;
    double Seen;
  } cases[] = { { [](int) { return false; }, 1.0 }, { [](int i) { return i == 0; }, 0.75 },
    { [](int i) { return i == 3; }, 0.75 }, { [](int i) { return i == 1 || i == 2; }, 0.5 },
    { [](int i) { return i != 2; }, 0.25 }, { [](int) { return true; }, 0.0 } };
  for (const auto& c : cases)
  {
    const Layers layers(c.Hide);
    for (const double thickness : { 0.1, 1.0, 5.0 })
    {
      const auto march = layers.cast<Kernel>(thickness);
      EXPECT_NEAR(1.0 - march.radiance.transmittance, slabOpacity(thickness, c.Seen), 2e-7);
      EXPECT_NEAR(march.radiance.color.y, slabOpacity(thickness, c.Seen), 2e-7);
      const auto all = layers.cast<Kernel>(thickness, false);
      EXPECT_EQ(march.cells, all.cells);
      EXPECT_EQ(march.refused + march.lost + march.guarded, 0);
      EXPECT_EQ(march.done, all.done);
    }
  }
}

TEST(HiddenCells, AreNotSeenButWhatLiesBehindThemIs)
{
  expectOpacities<PointKernel<double>>();
  expectOpacities<FastPointKernel<double>>();
  expectOpacities<CellKernel<double>>();
}

// With its own opacity a cell that isn't finite is seen, unless it is hidden.
TEST(HiddenCells, MayBeOfScalarsThatAreNotFinite)
{
  Layers layers([](int i) { return i == 1; });
  layers.Scalars.assign(layers.Scalars.size(), UndrawnScalar);
  auto kernel = kernelOf<CellKernel<double>, double>(layers.Mesh, whiteTable());
  kernel.CellScalars = layers.Scalars.data();
  const auto ray = kernel.rayThrough({ 0.0, 0.0123, -0.0071 }, { 1.0, 0.0, 0.0 });
  const double length = layers.Mesh.Frame.Radius;
  const auto cast = [&] { return kernel.castPlainRay(ray, length, -1e30, 1e30).radiance; };
  EXPECT_EQ(cast().transmittance, 1.0);
  kernel.nanColor = { 0.2, 0.5, 0.9, 0.6 };
  EXPECT_NEAR(1.0 - cast().transmittance, slabOpacity(0.6, 1.0), 2e-7);
  EXPECT_NEAR(cast().color.y, 0.5 * slabOpacity(0.6, 1.0), 2e-7);
  kernel.HiddenCells = layers.Hidden.data();
  EXPECT_NEAR(1.0 - cast().transmittance, slabOpacity(0.6, 0.75), 2e-7);
  EXPECT_NEAR(cast().color.z, 0.9 * slabOpacity(0.6, 0.75), 2e-7);
}
} // namespace
