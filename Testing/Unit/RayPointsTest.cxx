// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Points of rays in the arithmetic of the GPU, against lines in double.
#include "View/RayPoints.h"

#include "NamedCamera.h"
#include "Shot.h"
#include "UnitMeshes.h"

#include "vtkMath.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// The point of a ray as the shader computes it.
Vec3 pointOf(const std::array<double, 16>& matrix, double x, double y)
{
  float p[4];
  for (int r = 0; r < 4; ++r)
  {
    const auto m = [&](int c) { return static_cast<float>(matrix[4 * r + c]); };
    p[r] = m(0) * static_cast<float>(x) + m(1) * static_cast<float>(y) + m(3);
  }
  return { double(p[0] / p[3]), double(p[1] / p[3]), double(p[2] / p[3]) };
}

// The distance of a point from the line through q and the eye.
double distanceFromRay(const View& view, const Vec3& q, const Vec3& point)
{
  Vec3 along, to;
  for (int k = 0; k < 3; ++k)
  {
    along[k] = q[k] * view.Eye[3] - view.Eye[k];
    to[k] = point[k] - q[k];
  }
  Vec3 across;
  vtkMath::Cross(along.data(), to.data(), across.data());
  return vtkMath::Norm(across.data()) / vtkMath::Norm(along.data());
}

const NamedCamera Cameras[] = {
  { "near", [](vtkCamera* camera, vtkTransform*) { camera->SetPosition(2.1, 1.4, 2.9); } },
  { "beside the mesh",
    [](vtkCamera* camera, vtkTransform*)
    {
      camera->SetPosition(0.8, 0.9, 1.1);
      camera->SetViewAngle(120.0);
    } },
  { "at a million times its size",
    [](vtkCamera* camera, vtkTransform*)
    {
      camera->SetPosition(1e6, 2e6, 3e6);
      camera->SetViewAngle(1e-5);
    } },
  { "parallel", [](vtkCamera* camera, vtkTransform*) { camera->ParallelProjectionOn(); } },
  { "sheared, as for an eye of a stereo picture",
    [](vtkCamera* camera, vtkTransform*) { camera->SetViewShear(0.2, -0.1, 1.0); } },
  { "parallel, sheared",
    [](vtkCamera* camera, vtkTransform*)
    {
      camera->SetViewShear(0.2, -0.1, 1.0);
      camera->ParallelProjectionOn();
    } },
  { "turned and mirrored",
    [](vtkCamera*, vtkTransform* transform)
    {
      transform->RotateWXYZ(50.0, 0.3, 1.0, -0.2);
      transform->Scale(1.0, -2.0, 3.0);
    } },
  { "parallel, stretched askew",
    [](vtkCamera* camera, vtkTransform* transform)
    {
      transform->Scale(1e-6, 1.0, 1e6);
      camera->SetFocalPoint(0.0, 0.5, 5e5);
      camera->SetPosition(3e-7, 1.5, 5e5 - 0.2);
      camera->SetViewUp(1.0, 0.0, 0.0);
      camera->ParallelProjectionOn();
      camera->SetParallelScale(1e-6);
    } },
  { "far, stretched askew",
    [](vtkCamera* camera, vtkTransform* transform)
    {
      transform->Scale(1e-3, 1.0, 1e3);
      camera->SetFocalPoint(0.0, 0.5, 500.0);
      camera->SetPosition(3.0, 1e6, -1e5);
      camera->SetViewUp(1.0, 0.0, 0.0);
    } },
};

TEST(RayPoints, LieOnTheirRaysNearTheMesh)
{
  const TetMesh mesh = built(jitteredLattice(3));
  for (const NamedCamera& camera : Cameras)
  {
    Shot shot;
    camera.Set(shot.Camera, shot.Transform);
    shot.Camera->SetClippingRange(1e-3, 1e9);
    View view = viewOf(shot, mesh);
    view.CutsNearPlane = false; // of the clipping range nothing is used
    const std::array<double, 16> matrix = rayPoints(view, mesh.Frame);
    std::mt19937 random(5);
    for (int i = 0; i < 1000; ++i)
    {
      Vec3 q;
      for (int k = 0; k < 3; ++k)
      {
        q[k] = (2.0 * uniform(random) - 1.0) * mesh.Frame.HalfExtent[k];
      }
      double clip[4];
      for (int r = 0; r < 4; ++r)
      {
        const double* m = &view.NormalizedToClip[4 * r];
        clip[r] = m[0] * q[0] + m[1] * q[1] + m[2] * q[2] + m[3];
      }
      if (std::max(std::abs(clip[0]), std::abs(clip[1])) > clip[3])
      {
        continue; // beside the picture
      }
      const Vec3 point = pointOf(matrix, clip[0] / clip[3], clip[1] / clip[3]);
      EXPECT_LE(vtkMath::Norm(point.data()), 2.0) << camera.Name;
      EXPECT_LT(distanceFromRay(view, q, point), 1e-6) << camera.Name;
    }
  }
}

// Of an eye in the mesh the direction has digits, also if the near plane is almost there.
TEST(RayPoints, AreFarFromAnEyeInTheMesh)
{
  const TetMesh mesh = built(jitteredLattice(3));
  Shot shot;
  shot.Camera->SetPosition(0.3, 0.4, 0.2);
  shot.Camera->SetFocalPoint(0.9, 0.6, 0.8);
  shot.Camera->SetClippingRange(1e-6, 10.0);
  const View view = viewOf(shot, mesh);
  ASSERT_TRUE(view.CutsNearPlane);
  const std::array<double, 16> matrix = rayPoints(view, mesh.Frame);
  for (const double x : { -0.8, 0.0, 0.7 })
  {
    const Vec3 point = pointOf(matrix, x, 0.2);
    EXPECT_LT(distanceFromRay(view, view.unproject(x, 0.2, 0.0), point), 1e-6);
    double square = 0;
    for (int k = 0; k < 3; ++k)
    {
      square += (point[k] - view.Eye[k]) * (point[k] - view.Eye[k]);
    }
    EXPECT_GT(square, 0.25);
  }
}

TEST(RayPoints, BeginAtANearPlaneThatCutsTheMesh)
{
  const TetMesh mesh = built(jitteredLattice(3));
  for (const bool parallel : { false, true })
  {
    Shot shot;
    shot.Camera->SetParallelProjection(parallel);
    shot.Camera->SetClippingRange(2.5, 10.0);
    const View view = viewOf(shot, mesh);
    ASSERT_TRUE(view.CutsNearPlane);
    const std::array<double, 4> plane = view.nearPlane();
    const auto distance = [&](double depth)
    {
      const std::array<double, 3> at = view.unproject(-0.8, 0.2, depth);
      return plane[0] * at[0] + plane[1] * at[1] + plane[2] * at[2] + plane[3];
    };
    EXPECT_NEAR(distance(-1.0), 0.0, 1e-12);
    EXPECT_NEAR(distance(1.0), 7.5 / mesh.Frame.Radius, 1e-9);
    shot.Camera->SetClippingRange(1e-3, 10.0);
    EXPECT_EQ(viewOf(shot, mesh).nearPlane(), (std::array<double, 4>()));
  }
}
} // namespace
