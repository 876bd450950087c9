// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Files of adaptive meshes: as leaves, and as what is between their centres.
#include "AdaptiveMeshes.h"
#include "Fields.h"
#include "ReaderCase.h"

#include "vtkCompositeDataIterator.h"
#include "vtkHyperTreeGrid.h"
#include "vtkOverlappingAMR.h"
#include "vtkPointData.h"
#include "vtkRandomHyperTreeGridSource.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLHyperTreeGridWriter.h"
#include "vtkXMLUniformGridAMRWriter.h"

#include <numeric>

namespace
{
using tetmarch::ReadVolume;
const tetmarch::WantedArray AnyConstant;
const tetmarch::WantedArray AnyContinuous{ {}, -1, true };

vtkSmartPointer<vtkHyperTreeGrid> MakeTree(unsigned int slices)
{
  vtkNew<vtkRandomHyperTreeGridSource> source;
  source->SetDimensions(3, 3, slices);
  source->SetMaxDepth(3);
  source->SetSeed(5);
  source->Update();
  return source->GetHyperTreeGridOutput();
}

class AdaptiveReader : public ReaderCase
{
protected:
  /// What is read of the file; points have values only if it is continuous.
  template <typename Data>
  vtkSmartPointer<Data> Read(
    const std::string& path, const tetmarch::WantedArray& wanted, std::size_t blocks)
  {
    const auto volume = ReadVolume(path, std::nullopt, {}, wanted);
    EXPECT_TRUE(volume.Adaptive);
    EXPECT_FALSE(volume.Structured);
    EXPECT_EQ(volume.Blocks.size(), blocks);
    for (vtkDataSet* block : volume.Blocks)
    {
      EXPECT_EQ(block->GetPointData()->GetNumberOfArrays() > 0, wanted.Continuous);
    }
    return Data::SafeDownCast(volume.Input);
  }
};
} // namespace

TEST_F(AdaptiveReader, LeavesOfTrees)
{
  const auto tree = MakeTree(3);
  const std::string path = this->Write<vtkXMLHyperTreeGridWriter>("tree.htg", tree);
  const auto leaves = this->Read<vtkUnstructuredGrid>(path, AnyConstant, 1);
  ASSERT_TRUE(leaves);
  EXPECT_EQ(leaves->GetNumberOfCells(), tree->GetNumberOfLeaves());
  const auto between = this->Read<vtkUnstructuredGrid>(path, AnyContinuous, 1);
  ASSERT_TRUE(between);
  EXPECT_GT(between->GetNumberOfPoints(), tree->GetNumberOfLeaves());
  // Mappers march through the leaves of the tree itself.
  const auto constant = ReadVolume(path, std::nullopt, {}, AnyConstant);
  EXPECT_TRUE(vtkHyperTreeGrid::SafeDownCast(constant.GetMapperInput()));
  const auto continuous = ReadVolume(path, std::nullopt, {}, AnyContinuous);
  EXPECT_EQ(continuous.GetMapperInput(), continuous.Input.Get());
  EXPECT_TRUE(tetmarch::ListFaults(path, std::nullopt).empty());
}

TEST_F(AdaptiveReader, TreesOfOneTimeAreBlocks)
{
  const auto tree = MakeTree(3);
  this->Write<vtkXMLHyperTreeGridWriter>("a.htg", tree);
  const auto list = this->WriteText(
    "both.series", R"({"files": [{"name": "a.htg", "time": 1}, {"name": "a.htg", "time": 1}]})");
  EXPECT_EQ(
    ReadVolume(list, std::nullopt).Blocks[0]->GetNumberOfCells(), 2 * tree->GetNumberOfLeaves());
}

TEST_F(AdaptiveReader, AllLevelsOfBlocks)
{
  const auto mesh = tetmarch::testing::adaptiveMesh(tetmarch::testing::linearField());
  const std::string path = this->Write<vtkXMLUniformGridAMRWriter>("mesh.vthb", mesh);
  const auto at = vtk::TakeSmartPointer(mesh->NewIterator());
  std::size_t blocks = 0;
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    ++blocks;
  }
  const auto read = this->Read<vtkOverlappingAMR>(path, AnyConstant, blocks);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->GetNumberOfLevels(), 3u);
  const auto between = this->Read<vtkUnstructuredGrid>(path, AnyContinuous, 1);
  ASSERT_TRUE(between);
  const auto& leaves = tetmarch::testing::LeavesOfAdaptiveMesh;
  EXPECT_GT(between->GetNumberOfPoints(), std::accumulate(leaves.begin(), leaves.end(), 0));
}

TEST_F(AdaptiveReader, WhatIsNoVolume)
{
  const std::string flat = this->Write<vtkXMLHyperTreeGridWriter>("flat.htg", MakeTree(1));
  EXPECT_NE(GetError(flat).find("has no 3D cells"), std::string::npos) << GetError(flat);
  try
  {
    ReadVolume(flat, std::nullopt, {}, AnyContinuous);
    ADD_FAILURE() << "a tree of two dimensions has no cells between its leaves";
  }
  catch (const tetmarch::Failure& failure)
  {
    EXPECT_NE(
      std::string(failure.what()).find("only trees in three have an inside"), std::string::npos)
      << failure.what();
  }
  for (const char* name : { "cut.htg", "cut.vthb" })
  {
    const std::string path = this->WriteText(name, "<VTKFile type=");
    EXPECT_NE(GetError(path).find("cannot read"), std::string::npos) << GetError(path);
  }
}
