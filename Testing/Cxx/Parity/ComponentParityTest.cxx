// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws of several components, pixel by pixel against the CPU reference.
#include "ComponentScene.h"
#include "CpuReference.h"

#include "vtkActor.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 80;

Grid lattice() { return jitteredLattice(10, 0.15, 1, sineField()); }

class ComponentParity : public ::testing::TestWithParam<Mix>
{
};

TEST_P(ComponentParity, StructuredLawBeforeOpaqueGeometry)
{
  ComponentScene scene(lattice(), GetParam(), Side, Side);
  scene.Mapper->SetOpacityLawToStructured();
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 1.0, 1.0 }));
  expectParityWithOpaque(scene);
}

TEST_P(ComponentParity, CameraInside)
{
  ComponentScene scene(lattice(), GetParam(), Side, Side);
  scene.camera()->SetPosition(0.31, 0.42, 0.57);
  scene.camera()->SetFocalPoint(1.0, 0.6, 0.4);
  scene.camera()->SetClippingRange(0.01, 5.0);
  expectParity(scene);
}

TEST_P(ComponentParity, RaysThatComeAgain)
{
  ComponentScene scene(latticeWithHole(9, 0.15, 1, sineField()), GetParam(), Side, Side);
  expectParity(scene);
}

INSTANTIATE_TEST_SUITE_P(
  Of, ComponentParity, ::testing::ValuesIn(Mixes), [](const auto& of) { return of.param.Name; });
} // namespace
