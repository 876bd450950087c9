// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Hard cases of grids that aren't lists of cells: leaves whose levels differ, poles, layers of
// ghosts, curved cells that fold. The truth is brute force over their cells as tetrahedra, which
// are made without the mapper.
#include "CurvilinearGrids.h"
#include "GroundTruthPicture.h"
#include "LeafTrees.h"
#include "StoredCells.h"

#include "vtkHyperTreeGrid.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTetMarchDualGrid.h"
#include "vtkTetMarchTessellator.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 49; // odd: a pixel's centre is that of the picture
constexpr double CurvedTolerance = 0.01;
constexpr Vec3 Middle = { 0.5, 0.5, 0.5 };

struct HardGrid
{
  vtkSmartPointer<vtkDataObject> Data;
  Grid Tetrahedra; // that fill it, with its cell scalars "c"
};
using Look = std::function<void(vtkCamera*)>;

// The eye at a point in the volume.
Look from(const Vec3& eye, const Vec3& direction)
{
  return [=](vtkCamera* camera)
  {
    camera->SetPosition(eye.data());
    camera->SetFocalPoint(eye[0] + direction[0], eye[1] + direction[1], eye[2] + direction[2]);
    camera->SetViewUp(0.3, 0.2, 0.9);
    camera->SetViewAngle(100.0);
    camera->SetClippingRange(1e-4, 3.0);
  };
}

void alongZ(vtkCamera* camera) { lookDownZ(camera, 0.6); }

HardGrid asCells(const LeafTrees& made) { return { made.Trees, inTetrahedra(made.Leaves) }; }

// Beside roots on one side of x = 1/2, leaves that many levels finer on the other.
LeafTrees levelJump(int levels, const Field& field)
{
  return leafTrees(
    2, field, [=](const Node& node) { return node.Low[0] >= 0.5 && node.Level < levels; });
}

// In the middle of the cube, the corners of leaves of eight levels meet.
LeafTrees eightLevels(const Field& field)
{
  return leafTrees(1, field,
    [](const Node& node)
    {
      const Vec3 middle = node.middle();
      const int octant = (middle[0] > 0.5) + 2 * (middle[1] > 0.5) + 4 * (middle[2] > 0.5);
      bool touches = true;
      for (int a = 0; a < 3; ++a)
      {
        touches = touches && node.Low[a] <= 0.5 && node.Low[a] + node.Width >= 0.5;
      }
      return node.Level == 0 || (touches && node.Level <= octant);
    });
}

LeafTrees maskedLeaves()
{
  return leafTrees(
    4, noiseField(3), [](const Node& node) { return node.Low[1] < 0.4 && node.Level < 2; },
    [](const Node& node)
    { return noiseField(5, 64)(node.Low[0], node.Low[1], node.Low[2]) < 0.3; });
}

// By the distances from the axis and from the middle: equal in all cells around an edge of the
// axis, along which rays go.
double roundField(double x, double y, double z)
{
  const double across = std::hypot(x - 0.5, y - 0.5);
  return 0.5 + 0.25 * std::sin(9.0 * z) + 0.25 * std::cos(12.0 * std::hypot(across, z - 0.5));
}

// Cells meet in the poles, along the axis and, all of them, in the middle; they have plane faces.
HardGrid ball()
{
  const auto inBall = [](const Vec3& p) -> Vec3
  {
    const double angle = vtkMath::Pi() * p[2],
                 turn = 2.0 * vtkMath::Pi() * (p[1] - std::floor(p[1]));
    const double across = 0.5 * p[0] * std::sin(angle);
    return { 0.5 + across * std::cos(turn), 0.5 + across * std::sin(turn),
      0.5 - 0.5 * p[0] * std::cos(angle) };
  };
  const auto grid = curvilinearGrid({ 4, 12, 8 }, inBall, roundField);
  return { grid, inTetrahedra(withStoredCells(grid)) };
}

// Eight layers across x in two blocks. The first has the fifth layer as the second's ghosts; in the
// second, a layer and a corner are blanked.
HardGrid layersOfGhosts()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  Grid tetrahedra;
  for (const int first : { 0, 4 })
  {
    const int count = first == 0 ? 5 : 4;
    const auto sheared = [=](const Vec3& p) -> Vec3
    {
      const double x = (first + count * p[0]) / 8.0;
      return { x * x, p[1], p[2] + 0.2 * x };
    };
    const auto grid = curvilinearGrid({ count, 6, 5 }, sheared, noiseField(2));
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    for (int cell = 0; cell < count * 6 * 5; ++cell)
    {
      const int i = cell % count, j = cell / count % 6, k = cell / count / 6;
      const bool blanked = first == 4 && (j == 2 || (i == 3 && k == 4));
      const bool duplicate = first == 0 && i == 4;
      ghosts->InsertNextValue(
        static_cast<unsigned char>((duplicate ? vtkDataSetAttributes::DUPLICATECELL : 0) |
                                   (blanked ? vtkDataSetAttributes::HIDDENCELL : 0)));
    }
    grid->GetCellData()->AddArray(ghosts);
    blocks->SetBlock(first, grid);
    const Grid part = inTetrahedra(withStoredCells(grid));
    tetrahedra = tetrahedra ? joined(tetrahedra, part) : part;
  }
  return { blocks, tetrahedra };
}

// Inner nodes are moved so far that cells turn inside out in places.
HardGrid foldedCells()
{
  const Grid grid = quadraticHexLattice(2, 0.8, constantField(0.5));
  vtkNew<vtkTetMarchTessellator> tessellator;
  tessellator->SetInputData(grid);
  tessellator->SetGeometryTolerance(CurvedTolerance);
  tessellator->SetScalarTolerance(CurvedTolerance);
  tessellator->Update();
  return { grid, tessellator->GetOutput() };
}

struct Case
{
  const char* Name;
  std::function<HardGrid()> Make;
  Look Set;
};

const Case Cases[] = {
  { "LevelsDifferBy1", [] { return asCells(levelJump(1, noiseField())); }, lookAtUnitCube },
  { "LevelsDifferBy2", [] { return asCells(levelJump(2, noiseField())); }, lookAtUnitCube },
  { "LevelsDifferBy4", [] { return asCells(levelJump(4, noiseField())); }, lookAtUnitCube },
  { "EyeBetweenLevels", [] { return asCells(levelJump(4, noiseField())); },
    from({ 0.5, 0.3, 0.6 }, { 0.5, 0.6, -0.4 }) },
  { "EyeInACornerOfEightLevels", [] { return asCells(eightLevels(noiseField())); },
    from(Middle, { 1.0, 0.9, 0.8 }) },
  { "EyeInThatCornerLookingBack", [] { return asCells(eightLevels(noiseField())); },
    from(Middle, { -0.7, 0.2, -0.3 }) },
  { "MaskedLeaves", [] { return asCells(maskedLeaves()); }, lookAtUnitCube },
  { "BallAlongItsAxis", ball, alongZ },
  { "EyeInAPole", ball, from({ 0.5, 0.5, 1.0 }, { 0.1, 0.2, -1.0 }) },
  { "EyeInTheMiddleOfABall", ball, from(Middle, { 0.3, 0.5, 0.4 }) },
  { "LayersOfGhosts", layersOfGhosts, lookAtUnitCube },
};

class GridHardCases : public testing::TestWithParam<Case>
{
};

// Draws the scene, which must show something.
void expectTruth(Scene& scene, const Image& truth, const char* name)
{
  const Image drawn = scene.render();
  const Difference difference = compare(drawn, truth, {}, 1.0 / 255.0);
  std::cout << "[ MEASURED ] " << name << ": " << difference.text() << '\n';
  EXPECT_LE(difference.Rms, 0.1 / 255.0);
  EXPECT_LE(difference.Max, 1.0 / 255.0);
  EXPECT_EQ(scene.Mapper->GetNumberOfLostRays(), 0);
  EXPECT_GT(compare(truth, Image(Side, Side)).Rms, 0.1);
}

TEST_P(GridHardCases, LookLikeTheirCells)
{
  const HardGrid grid = this->GetParam().Make();
  Scene scene(grid.Tetrahedra, Side, Side);
  scene.Mapper->SetInputDataObject(grid.Data);
  scene.drawCellScalars();
  this->GetParam().Set(scene.camera());
  expectTruth(scene, groundTruthPicture(scene, grid.Tetrahedra, ScalarsOf::Cells, Side),
    this->GetParam().Name);
}

// Cells between the centres of leaves fill the same space.
TEST(GridHardCases, CellsBetweenLeavesHaveNoGaps)
{
  for (const auto& [name, made] : { std::pair{ "4 levels", levelJump(4, constantField(0.5)) },
         std::pair{ "8 levels", eightLevels(constantField(0.5)) } })
  {
    const Grid tetrahedra = inTetrahedra(made.Leaves);
    vtkNew<vtkTetMarchDualGrid> dual;
    dual->SetInputData(made.Trees);
    dual->Update();
    for (const Look& look : { Look(lookAtUnitCube), from(Middle, { -0.4, 0.6, -0.5 }) })
    {
      Scene scene(dual->GetOutput(), Side, Side);
      look(scene.camera());
      expectTruth(scene, groundTruthPicture(scene, tetrahedra, ScalarsOf::Cells, Side), name);
    }
  }
}

TEST(GridHardCases, FoldedCurvedCells)
{
  const HardGrid grid = foldedCells();
  Scene scene(grid.Tetrahedra, Side, Side);
  scene.Mapper->SetInputDataObject(grid.Data);
  scene.Mapper->SetGeometryTolerance(CurvedTolerance);
  expectTruth(scene, groundTruthPicture(scene, grid.Tetrahedra, ScalarsOf::Points, Side), "folded");
}

INSTANTIATE_TEST_SUITE_P(With, GridHardCases, testing::ValuesIn(Cases),
  [](const auto& of) { return std::string(of.param.Name); });
} // namespace
