// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws of several components of a volume of each kind, pixel by pixel against the CPU
// reference.
#include "ParityScenes.h"

#include "vtkActor.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

template <typename Kind>
class ComponentParity : public ::testing::Test
{
protected:
  static void expectParityOfMixes(Shape shape, void (*change)(Kind& scene))
  {
    for (const Mix& mix : Mixes)
    {
      Kind scene(shape);
      drawMix(scene, mix);
      change(scene);
      scene.expectParity(mix.Name);
    }
  }
};
TYPED_TEST_SUITE(ComponentParity, ParityKinds, ParityKindNames);

TYPED_TEST(ComponentParity, HardData)
{
  this->expectParityOfMixes(Shape::Hard, [](TypeParam&) {});
}

TYPED_TEST(ComponentParity, EachLawBeforeOpaqueGeometry)
{
  this->expectParityOfMixes(Shape::Plain,
    [](TypeParam& scene)
    {
      scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 1.0, 1.0 }));
      scene.Mapper->SetOpacityLawToUnstructured();
      scene.expectParity("the unstructured law");
      scene.Mapper->SetOpacityLawToStructured();
    });
}

TYPED_TEST(ComponentParity, CameraInside)
{
  this->expectParityOfMixes(Shape::Plain, [](TypeParam& scene) { lookFromInside(scene.camera()); });
}
} // namespace
