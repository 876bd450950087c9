// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Scalars of which none is finite show nothing, which is said once.
#include "ErrorScene.h"
#include "SmartScene.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch::testing;

template <typename Data>
Data madeNotFinite(Data data)
{
  vtkDataArray* scalars = data->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    scalars->SetTuple1(i, i % 2 ? std::nan("") : std::numeric_limits<double>::infinity());
  }
  return data;
}

Grid tetrahedra() { return jitteredLattice(4, 0.1, 1, sineField()); }
auto lattice() { return imageOf(sineField(), unitCube(6)); }

template <typename SceneType, typename Data>
void expectOneWarning(const Data& sound)
{
  SceneType scene(madeNotFinite(sound), 64, 64);
  const ErrorWatch watch(scene.Mapper);
  const auto render = [&] { scene.Window->Render(); };
  render();
  render();
  ASSERT_EQ(watch.Warnings.size(), 1U);
  for (const char* word : { "finite", "nothing is drawn", "another array", "SetDrawNanCells" })
  {
    EXPECT_NE(watch.Warnings[0].find(word), std::string::npos) << watch.Warnings[0];
  }
  scene.Mapper->DrawNanCellsOn(); // but the colour function's NaN colour is transparent
  scene.property()->GetRGBTransferFunction()->SetNanColorRGBA(1.0, 0.0, 0.0, 0.0);
  render();
  EXPECT_EQ(watch.Warnings.size(), 1U);
  scene.property()->GetRGBTransferFunction()->SetNanColorRGBA(1.0, 0.0, 0.0, 0.5);
  render();
  EXPECT_EQ(watch.Warnings.size(), 1U) << "they are drawn";
  scene.Mapper->DrawNanCellsOff();
  render();
  EXPECT_EQ(watch.Warnings.size(), 2U) << "it is so again";
  scene.Data->GetPointData()->GetScalars()->SetTuple1(0, 0.5);
  scene.Data->GetPointData()->GetScalars()->Modified();
  scene.Data->Modified();
  render();
  EXPECT_EQ(watch.Warnings.size(), 2U) << "one is finite, so it is the data that has holes";
  EXPECT_EQ(watch.Errors, Words());
}

struct LatticeScene : SmartScene
{
  LatticeScene(const vtkSmartPointer<vtkImageData>& image, int width, int height)
    : SmartScene(image, width, height)
    , Data(image)
  {
  }
  vtkSmartPointer<vtkImageData> Data;
};

TEST(NothingFinite, InAMesh) { expectOneWarning<Scene>(tetrahedra()); }

TEST(NothingFinite, InAnImage) { expectOneWarning<LatticeScene>(lattice()); }

TEST(NothingFinite, InOneOfTwoBlocksIsNotWorthAWord)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, lattice());
  auto other = madeNotFinite(lattice());
  other->SetOrigin(1.0, 0.0, 0.0);
  blocks->SetBlock(1, other);
  SmartScene scene(blocks, 64, 64);
  const ErrorWatch watch(scene.Mapper);
  scene.Window->Render();
  EXPECT_EQ(watch.Warnings, Words());
  madeNotFinite(vtkSmartPointer<vtkImageData>(vtkImageData::SafeDownCast(blocks->GetBlock(0))));
  blocks->GetBlock(0)->Modified();
  vtkImageData::SafeDownCast(blocks->GetBlock(0))->GetPointData()->GetScalars()->Modified();
  scene.Window->Render();
  EXPECT_EQ(watch.Warnings.size(), 1U);
  EXPECT_EQ(watch.Errors, Words());
}
} // namespace
