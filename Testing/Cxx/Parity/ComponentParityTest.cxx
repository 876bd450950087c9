// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws of several components, pixel by pixel against the CPU reference.
#include "ComponentScene.h"
#include "CpuReference.h"
#include "CutScene.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch::testing;

Grid lattice() { return jitteredLattice(10, 0.15, 1, sineField()); }

class ComponentParity : public ::testing::TestWithParam<Mix>
{
};

TEST_P(ComponentParity, Points)
{
  ComponentScene scene(lattice(), GetParam());
  expectParity(scene);
}

TEST_P(ComponentParity, Cells)
{
  ComponentScene scene(lattice(), GetParam());
  scene.drawCells();
  expectParity(scene);
}

TEST_P(ComponentParity, TakenAsTheyAre)
{
  ComponentScene scene(lattice(), GetParam());
  scene.Mapper->SetAccuracyLevelToFast();
  expectParity(scene);
}

TEST_P(ComponentParity, StructuredLawBeforeOpaqueGeometry)
{
  ComponentScene scene(lattice(), GetParam());
  scene.Mapper->SetOpacityLawToStructured();
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 1.0, 1.0 }));
  expectParityWithOpaque(scene);
}

TEST_P(ComponentParity, CameraInside)
{
  ComponentScene scene(lattice(), GetParam());
  scene.camera()->SetPosition(0.31, 0.42, 0.57);
  scene.camera()->SetFocalPoint(1.0, 0.6, 0.4);
  scene.camera()->SetClippingRange(0.01, 5.0);
  expectParity(scene);
}

TEST_P(ComponentParity, RaysThatComeAgain)
{
  ComponentScene scene(latticeWithHole(9, 0.15, 1, sineField()), GetParam());
  expectParity(scene);
}

TEST_P(ComponentParity, ClippedAndCropped)
{
  ComponentScene scene(lattice(), GetParam());
  clipAndCropToFence(scene);
  const Image cut = scene.render();
  const Image reference = referenceOf(scene).Picture;
  const Mask inside = regionsOf(scene).Inside;
  const Difference difference = compare(cut, reference, inside);
  EXPECT_LE(difference.Percentile999, 2.0 / 255.0) << difference.text();
  EXPECT_LE(difference.Rms, 0.3 / 255.0) << difference.text();
  scene.Mapper->RemoveAllClippingPlanes();
  scene.Mapper->CroppingOff();
  EXPECT_GT(compare(cut, scene.render()).Rms, 10.0 / 255.0);
}

TEST_P(ComponentParity, WhatIsNotFiniteAndHiddenCells)
{
  for (const bool cells : { false, true })
  {
    const Grid grid = lattice();
    ComponentScene scene(grid, GetParam());
    vtkDataSetAttributes* data = grid->GetPointData();
    if (cells)
    {
      scene.drawCells();
      data = grid->GetCellData();
    }
    vtkDataArray* scalars = data->GetScalars();
    const int last = scalars->GetNumberOfComponents() - 1;
    for (vtkIdType i = 5; i < scalars->GetNumberOfTuples(); i += 97)
    {
      scalars->SetComponent(i, i % 2 ? 0 : last, std::numeric_limits<double>::quiet_NaN());
    }
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfTuples(grid->GetNumberOfCells());
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    {
      ghosts->SetValue(i, i % 7 == 0 ? vtkDataSetAttributes::HIDDENCELL : 0);
    }
    grid->GetCellData()->AddArray(ghosts);
    const Image holes = scene.render();
    for (const bool shown : { false, true })
    {
      scene.Mapper->SetDrawNanCells(shown);
      scene.property()->GetRGBTransferFunction()->SetNanColor(1.0, 0.0, 1.0);
      scene.property()->GetRGBTransferFunction()->SetNanOpacity(0.9);
      const Image drawn = scene.render();
      const Difference difference =
        compare(drawn, referenceOf(scene).Picture, regionsOf(scene).Inside);
      EXPECT_LE(difference.Rms, 0.3 / 255.0) << difference.text();
      EXPECT_LE(difference.Percentile999, 4.0 / 255.0) << difference.text();
      EXPECT_EQ(compare(drawn, holes).Max > 0.05, shown);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
  Of, ComponentParity, ::testing::ValuesIn(Mixes), [](const auto& of) { return of.param.Name; });
} // namespace
