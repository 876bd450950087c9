// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scene, and planes that cut its volume
 */
#ifndef tetmarch_testing_CutScene_h
#define tetmarch_testing_CutScene_h

#include "LitScene.h"

#include "vtkPlane.h"

namespace tetmarch::testing
{
template <typename AnyScene>
vtkSmartPointer<vtkPlane> addClippingPlane(AnyScene& scene, const Vec3& origin, const Vec3& normal)
{
  auto plane = vtkSmartPointer<vtkPlane>::New();
  plane->SetOrigin(origin[0], origin[1], origin[2]);
  plane->SetNormal(normal[0], normal[1], normal[2]);
  scene.Mapper->AddClippingPlane(plane);
  return plane;
}

/// Clips through the middle of the unit cube; what lies behind, as lookAtUnitCube() sees it, is
/// left.
template <typename AnyScene>
vtkSmartPointer<vtkPlane> clipObliquely(AnyScene& scene)
{
  return addClippingPlane(scene, { 0.5, 0.45, 0.4 }, { -0.6, 0.3, -1.0 });
}

/// Crops by planes within the unit cube, none of them in the middle.
template <typename AnyScene>
void crop(AnyScene& scene, int flags)
{
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(0.237, 0.711, 0.313, 0.564, 0.159, 0.823);
  scene.Mapper->SetCroppingRegionFlags(flags);
}
} // namespace tetmarch::testing

#endif
