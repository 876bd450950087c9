// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Several components that can't be drawn together: one error says why, and none is left when it is
// put right.
#include "ComponentScene.h"
#include "ErrorScene.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;
using Mapper = vtkTetMarchVolumeMapper;

struct ThreeComponents : ComponentScene
{
  ThreeComponents(const Grid& grid, int width, int height)
    : ComponentScene(grid, { "", 3, true }, width, height)
  {
  }
};

class ComponentErrors : public ErrorsIn<ThreeComponents>
{
protected:
  ComponentErrors()
    : ErrorsIn(jitteredLattice(6, 0.15, 1, sineField()))
  {
  }
};

TEST_F(ComponentErrors, ComeOnceAndLeaveNoTrace)
{
  Mapper* mapper = this->Shown.Mapper;
  vtkVolumeProperty* property = this->Shown.property();
  const auto mend = [=]
  {
    mapper->SetBlendModeToComposite();
    mapper->SetViewModeToPicture();
    property->ShadeOff();
    property->DisableGradientOpacityOn();
    property->IndependentComponentsOn();
    property->SetScalarOpacityUnitDistance(1, 0.375);
  };
  const auto addGradientOpacity = [=]
  {
    property->DisableGradientOpacityOff();
    property->GetGradientOpacity()->AddSegment(0.0, 0.0, 5.0, 1.0);
  };
  const struct
  {
    std::function<void()> Spoil;
    Words Said;
  } cases[] = {
    { [=] { mapper->SetBlendModeToMaximumIntensity(); }, { "composite blending alone" } },
    { [=] { mapper->SetBlendModeToAdditive(); }, { "composite blending alone" } },
    { [=] { mapper->SetBlendModeToIsoSurface(); }, { "composite blending alone" } },
    { [=] { mapper->SetViewModeToGradients(); }, { "no views of gradients" } },
    { [=] { mapper->SetViewModeToIllumination(); }, { "no views of gradients" } },
    { [=] { property->IndependentComponentsOff(); }, { "\"components\" has 3 components" } },
    { [=] { property->SetScalarOpacityUnitDistance(1, -1.0); }, { "of component 1 is -1" } },
    { addGradientOpacity, { "gradient opacity" } },
  };
  for (const auto& each : cases)
  {
    this->expectError(each.Spoil, mend, each.Said);
  }
}
} // namespace
