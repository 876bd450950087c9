// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which prop and block a picked cell belongs to: volumes inside other props, two volumes of one
// mapper, blocks.
#include "GridBlocks.h"
#include "PickScene.h"

#include "vtkCell.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"

#include <gtest/gtest.h>
#include <set>

namespace
{
using namespace tetmarch::testing;

// As ParaView's volumes, which choose a level of detail and have another volume draw it.
class DelegatingVolume : public vtkVolume
{
public:
  static DelegatingVolume* New();
  vtkTypeMacro(DelegatingVolume, vtkVolume);

  int RenderVolumetricGeometry(vtkViewport* viewport) override
  {
    this->Delegate->SetMapper(this->GetMapper());
    this->Delegate->SetProperty(this->GetProperty());
    this->Delegate->SetUserMatrix(this->GetMatrix());
    return this->Delegate->RenderVolumetricGeometry(viewport);
  }

private:
  vtkNew<vtkVolume> Delegate;
};
vtkStandardNewMacro(DelegatingVolume);

TEST(Picking, AVolumeThatAnotherOneDraws)
{
  auto scene = evenScene(jitteredLattice(5));
  scene->Volume->SetPosition(0.02, -0.03, 0.01);
  ASSERT_TRUE(scene->pick(70, 85));
  const Vec3 position = scene->pickedPosition();
  const double scalar = scene->Mapper->GetPickedScalar();
  ASSERT_TRUE(scene->pick(90, 60)); // as if there had been no pick before
  vtkNew<DelegatingVolume> volume;
  volume->SetMapper(scene->Mapper);
  volume->SetProperty(scene->property());
  volume->SetPosition(scene->Volume->GetPosition());
  scene->Renderer->RemoveVolume(scene->Volume);
  scene->Renderer->AddVolume(volume);
  ASSERT_TRUE(scene->Mapper->Pick(scene->Renderer, volume, 70, 85));
  EXPECT_EQ(scene->pickedPosition(), position);
  EXPECT_EQ(scene->Mapper->GetPickedScalar(), scalar);
}

// Where one mapper draws two volumes, the point is of the one that is asked for.
TEST(Picking, OneMapperOfTwoVolumes)
{
  auto scene = evenScene(jitteredLattice(5));
  ASSERT_TRUE(scene->pick(70, 85));
  const Vec3 position = scene->pickedPosition();
  const auto line = scene->lineOf(70, 85);
  vtkNew<vtkVolume> behind;
  behind->SetMapper(scene->Mapper);
  behind->SetProperty(scene->property());
  behind->SetPosition(line.Direction[0], line.Direction[1], line.Direction[2]);
  scene->Renderer->AddVolume(behind);
  ASSERT_TRUE(scene->pick(70, 85));
  EXPECT_EQ(scene->pickedPosition(), position);
  EXPECT_FALSE(scene->Mapper->Pick(scene->Renderer, behind, 70, 85));
}

// Cells are told by block, and are those of the whole.
TEST(Picking, CellsOfBlocks)
{
  const Grid grid = jitteredLattice(5, 0.15, 1, sineField());
  PickScene whole(grid);
  whole.property()->SetScalarOpacityUnitDistance(0.1);
  const auto parts = cutIntoBlocks(grid, partsOfUnitCube(8));
  PickScene scene(grid);
  scene.property()->SetScalarOpacityUnitDistance(0.1);
  // One level deeper than a single one, between others that hold nothing.
  vtkNew<vtkMultiBlockDataSet> tree;
  tree->SetBlock(1, blocks(parts));
  tree->SetNumberOfBlocks(3);
  scene.Mapper->SetInputDataObject(tree);
  constexpr unsigned int FirstBlock = 3; // the root is 0, its empty child 1, the inner tree 2

  const auto centreOf = [](vtkUnstructuredGrid* of, vtkIdType cell)
  {
    const double* box = of->GetCell(cell)->GetBounds();
    return Vec3{ box[0] + box[1], box[2] + box[3], box[4] + box[5] };
  };
  std::set<unsigned int> picked;
  for (int y = 3; y < SceneSize; y += 9)
  {
    for (int x = 4; x < SceneSize; x += 11)
    {
      const bool hit = whole.pick(x, y);
      ASSERT_EQ(scene.pick(x, y), hit);
      EXPECT_EQ(whole.Mapper->GetPickedBlock(), 0u);
      if (hit)
      {
        const unsigned int block = scene.Mapper->GetPickedBlock() - FirstBlock;
        ASSERT_LT(block, parts.size());
        picked.insert(block);
        ASSERT_LT(scene.Mapper->GetPickedCellId(), parts[block]->GetNumberOfCells());
        EXPECT_EQ(centreOf(parts[block], scene.Mapper->GetPickedCellId()),
          centreOf(grid, whole.Mapper->GetPickedCellId()));
      }
    }
  }
  EXPECT_GT(picked.size(), 3u);

  std::multiset<Vec3> expected;
  const auto selected = whole.selectAll();
  for (const vtkIdType cell : selected.at(whole.Volume))
  {
    expected.insert(centreOf(grid, cell));
  }
  std::multiset<Vec3> found;
  for (const auto& [block, cells] : scene.selectAllInBlocks())
  {
    for (const vtkIdType cell : cells)
    {
      found.insert(centreOf(parts.at(block - FirstBlock), cell));
    }
  }
  EXPECT_EQ(found, expected);

  // Blocks that move to another place in the tree keep their cells, not their number.
  tree->SetBlock(0, tree->GetBlock(1));
  tree->SetBlock(1, nullptr);
  ASSERT_TRUE(scene.pick(70, 85));
  const unsigned int moved = scene.Mapper->GetPickedBlock();
  scene.Mapper->SetInputDataObject(blocks(parts));
  ASSERT_TRUE(scene.pick(70, 85));
  EXPECT_EQ(scene.Mapper->GetPickedBlock() + 1, moved);
}
} // namespace
