// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What is picked of several components: points against closed forms.
#include "ComponentScene.h"
#include "PickScene.h"

#include "vtkDataArray.h"

#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 64;

Grid lattice() { return jitteredLattice(6, 0.15, 1, sineField()); }

// The component of the opacity decides where a ray is picked, with its gradient opacity.
TEST(ComponentPick, GoesByTheGradientOfTheOpacity)
{
  for (const Mix& mix : { Mixes[3], Mixes[4] })
  {
    PickScene scene(withComponents(lattice(), wavyFields(mix.Components), VTK_DOUBLE), Side, Side);
    drawComponents(scene, mix);
    const int at = Side / 2;
    const auto pick = [&]
    {
      scene.render();
      EXPECT_TRUE(scene.pick(at, at)) << mix.Name;
      return scene.pickedPosition();
    };
    scene.property()->SetScalarOpacityUnitDistance(0.01);
    const Vec3 even = pick();
    setGradientOpacity(scene.property());
    const Vec3 together = pick();
    scene.Mapper->SetVectorModeToComponent();
    scene.Mapper->SetVectorComponent(mix.Components - 1);
    const Vec3 alone = pick();
    EXPECT_EQ(together, alone) << mix.Name;
    EXPECT_NE(together, even) << mix.Name;
  }
}

// Scalars are the same everywhere, so that the point has a closed form: there the extinctions of
// all components together have taken half of the light.
TEST(ComponentPick, GoesByAllComponents)
{
  for (const Mix& mix : Mixes)
  {
    std::vector<Field> fields;
    for (int k = 0; k < mix.Components; ++k)
    {
      fields.push_back(constantField(0.3 + 0.1 * k));
    }
    const Grid grid = withComponents(lattice(), fields, VTK_DOUBLE);
    for (const bool cells : { false, true })
    {
      PickScene scene(grid, Side, Side);
      setComponentFunctions(scene.property(), mix.Components);
      scene.property()->SetIndependentComponents(mix.Independent);
      scene.Mapper->SetVectorModeToAllComponents();
      if (cells)
      {
        scene.Mapper->SetScalarModeToUseCellData();
      }
      std::vector<double> scalars(mix.Components);
      grid->GetPointData()->GetScalars()->GetTuple(0, scalars.data());
      const double extinction = mediumAt(scene.property(), scalars)[3] / 0.25;
      scene.render();
      const int at = Side / 2;
      ASSERT_TRUE(scene.pick(at, at)) << mix.Name;
      const auto line = scene.lineOf(at, at);
      const Vec3 picked = scene.pickedPosition();
      double distance = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        distance += (picked[k] - line.Near[k]) * line.Direction[k];
      }
      const double inside =
        boxChord(line.at(distance), { -line.Direction[0], -line.Direction[1], -line.Direction[2] },
          { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, 0.0);
      EXPECT_NEAR(inside, std::log(2.0) / extinction, 1e-5) << mix.Name;
      EXPECT_NEAR(
        scene.Mapper->GetPickedScalar(), mix.Independent ? scalars[0] : scalars.back(), 1e-6);
    }
  }
}
} // namespace
