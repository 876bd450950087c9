// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The stage of effects with all that it is asked about, and how often it has run
 */
#ifndef tetmarch_testing_StagedEffects_h
#define tetmarch_testing_StagedEffects_h

#include "Light/EffectStage.h"

#include "Volume/TetVolume.h"

#include "Shot.h"

#include "vtkCellData.h"
#include "vtkLight.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <gtest/gtest.h>

namespace tetmarch::testing
{
/// A lattice that nothing shines on yet.
class StagedEffects : public ::testing::Test
{
protected:
  StagedEffects()
  {
    this->Renderer->SetActiveCamera(vtkNew<vtkCamera>());
    this->readData();
  }

  vtkVolumeProperty* property() { return this->Volume->GetProperty(); }

  vtkSmartPointer<vtkLight> addLight(double x, double y, double z)
  {
    auto light = vtkSmartPointer<vtkLight>::New();
    light->SetPosition(x, y, z);
    this->Renderer->AddLight(light);
    return light;
  }
  void addHeadlight() { this->addLight(0.0, 0.0, 1.0)->SetLightTypeToHeadlight(); }
  void addSun() { this->addLight(3.0, 4.0, 1.0); }

  vtkPiecewiseFunction* addGradientOpacity()
  {
    vtkNew<vtkPiecewiseFunction> function;
    function->AddPoint(0.0, 0.1);
    function->AddPoint(0.5, 0.9);
    this->property()->SetGradientOpacity(function);
    return this->property()->GetGradientOpacity();
  }

  // The volume of the data, whose scalars are drawn.
  void readData(bool ofCells = false)
  {
    vtkDataArray* array =
      ofCells ? this->Data->GetCellData()->GetScalars() : this->Data->GetPointData()->GetScalars();
    EXPECT_EQ(this->Source.updateGeometry({ this->Data }, {}, {}), "");
    EXPECT_EQ(this->Source.updateScalars({ this->Data }, { array, ofCells }), "");
  }
  // Another version of the same scalars, and of the same mesh.
  void touchScalars()
  {
    this->Data->GetPointData()->GetScalars()->Modified();
    this->readData();
  }
  void touchMesh()
  {
    const Grid none = Grid::New();
    EXPECT_EQ(this->Source.updateGeometry({ none }, {}, {}), "");
    this->readData();
  }

  std::string update()
  {
    return this->Stage.update(this->Renderer, this->Volume, this->Options, { &this->Source });
  }

  // So often in all after one more update.
  void expectRuns(int gradients, int gradientOpacity, int starts)
  {
    EXPECT_EQ(this->update(), "");
    EXPECT_EQ(this->Stage.gradientsRecord().Runs, gradients);
    EXPECT_EQ(this->Stage.gradientOpacityRecord().Runs, gradientOpacity);
    EXPECT_EQ(this->Stage.startsRecord().Runs, starts);
  }

  // Nothing of it is left, and no variant has it.
  void expectNothing() const
  {
    EXPECT_EQ(this->Stage.data().Gradients.capacity(), 0u);
    EXPECT_EQ(this->Stage.data().VertexStarts.capacity(), 0u);
    EXPECT_TRUE(this->Stage.data().empty());
    EXPECT_TRUE(this->Stage.gradientsVersion().empty());
    EXPECT_TRUE(this->Stage.gradientOpacityVersion().empty());
    EXPECT_TRUE(this->Stage.startsVersion().empty());
    EXPECT_TRUE(this->key() == VariantKey().filtered());
  }

  VariantKey key(double pixels = 1e4) const
  {
    VariantKey key;
    this->Stage.setBits(key, pixels);
    return key.filtered();
  }

  Grid Data = jitteredLattice(3, 0.15, 1, sineField());
  TetVolume Source;
  const TetMesh& Mesh = Source.mesh();
  vtkNew<WindowlessRenderer> Renderer;
  vtkNew<vtkVolume> Volume;
  EffectOptions Options;
  EffectStage Stage;
};
} // namespace tetmarch::testing

#endif
