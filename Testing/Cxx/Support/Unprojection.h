// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief From the picture into the world, by VTK's own camera matrix
 */
#ifndef tetmarch_testing_Unprojection_h
#define tetmarch_testing_Unprojection_h

#include "GridBuilder.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

namespace tetmarch::testing
{
/// Has no code in common with the mapper's view. The camera is read once.
class Unprojection
{
public:
  explicit Unprojection(vtkCamera* camera, double aspect = 1.0)
  {
    // Not the camera's composite matrix, which is never that of an eye.
    vtkMatrix4x4::Multiply4x4(camera->GetProjectionTransformMatrix(aspect, -1.0, 1.0),
      camera->GetModelViewTransformMatrix(), this->ToWorld);
    this->ToWorld->Invert();
  }
  /// Of clip coordinates, each -1..1.
  Vec3 operator()(double x, double y, double z) const
  {
    const double clip[4] = { x, y, z, 1.0 };
    double p[4];
    this->ToWorld->MultiplyPoint(clip, p);
    return { p[0] / p[3], p[1] / p[3], p[2] / p[3] };
  }

private:
  vtkNew<vtkMatrix4x4> ToWorld;
};
} // namespace tetmarch::testing

#endif
