// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Lights reach the march in its own coordinates, wherever the volume is and however it is turned.
#include "LitVolume.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <cmath>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

Triple times(const std::array<double, 9>& m, const Triple& v)
{
  return { { m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[3] * v[0] + m[4] * v[1] + m[5] * v[2],
    m[6] * v[0] + m[7] * v[1] + m[8] * v[2] } };
}

double dot(const Triple& a, const Triple& b) { return vtkMath::Dot(a.data(), b.data()); }
double length(const Triple& a) { return std::sqrt(dot(a, a)); }
Triple minus(const Triple& a, const Triple& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}
Triple firstThree(const std::array<double, 4>& v) { return { { v[0], v[1], v[2] } }; }

class LightTransforms : public LitVolume
{
protected:
  // A point, or the difference of two, of the mesh's normalised frame in the world.
  Triple toWorld(const Triple& p, double w = 1.0)
  {
    double q[4] = { 0.0, 0.0, 0.0, w };
    for (int k = 0; k < 3; ++k)
    {
      q[k] = w * this->Mesh.Frame.Center[k] + this->Mesh.Frame.Radius * p[k];
    }
    this->Volume->GetMatrix()->MultiplyPoint(q, q);
    return { { q[0], q[1], q[2] } };
  }

  void expectTransforms();
  void expectAngles();
};

// Lights are placed in the world by the volume's own matrix, and must be found again in the frame.
// Far away, positions in the world are known only to `lost` of the mesh's size.
void LightTransforms::expectTransforms()
{
  const Triple a{ { 0.3, -0.7, 0.2 } };
  const Triple b{ { -0.5, 0.1, 3.0 } };
  const Triple direction{ { 2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0 } };
  const Triple worldA = this->toWorld(a);
  const Triple worldB = this->toWorld(b);
  this->Answers.Lights = { pointLight(worldA), pointLight(worldB), sunlight(direction) };
  const LightUniforms lights = this->lights();
  ASSERT_EQ(lights.Sources.size(), 3u);
  ASSERT_EQ(lights.ShadowSources.size(), 3u);
  const double size = length(minus(worldA, worldB));
  const double lost = 1e-12 + 1e-14 * length(this->toWorld({})) / size;

  // Positions: those of the normalised frame, and in the shader's world those that the march has.
  expectNear(firstThree(lights.ShadowSources[0]), a, 10.0 * lost);
  expectNear(firstThree(lights.ShadowSources[1]), b, 10.0 * lost);
  EXPECT_EQ(lights.ShadowSources[0][3], 1.0);
  const Triple placeA = firstThree(lights.Sources[0].Place);
  const Triple placeB = firstThree(lights.Sources[1].Place);
  expectNear(placeA, times(lights.WorldMatrix, a), 10.0 * lost);
  expectNear(placeB, times(lights.WorldMatrix, b), 10.0 * lost);
  EXPECT_EQ(lights.Sources[0].Place[3], 1.0);

  // Attenuation by distances of the shader's world is that of the world.
  const double distance = length(minus(placeA, placeB));
  const auto& fading = lights.Sources[0].Attenuation;
  EXPECT_EQ(fading[0], 0.5);
  EXPECT_NEAR(fading[1] * distance, 0.25 * size, 1e-12 * size + lost * size);
  EXPECT_NEAR(
    fading[2] * distance * distance, 0.125 * size * size, (1e-12 + 2.0 * lost) * size * size);
  EXPECT_EQ(fading[3], 3.0);
  EXPECT_EQ(lights.Sources[0].Cone[3], 0.75);

  // Directions towards the light: in the world as they are, in the normalised frame of unit length.
  expectNear(firstThree(lights.Sources[2].Place), minus({}, direction), 1e-15);
  EXPECT_EQ(lights.Sources[2].Place[3], 0.0);
  expectNear(firstThree(lights.Sources[2].Cone), direction, 1e-15);
  const Triple toLight = firstThree(lights.ShadowSources[2]);
  EXPECT_EQ(lights.ShadowSources[2][3], 0.0);
  EXPECT_NEAR(length(toLight), 1.0, 1e-12);
  const Triple worldToLight = this->toWorld(toLight, 0.0);
  EXPECT_NEAR(dot(worldToLight, direction), -length(worldToLight), 1e-12 * length(worldToLight));

  // Normals: across every surface, and up the slope however the volume is mirrored.
  const Triple slope{ { 0.6, -0.2, 0.9 } };
  const Triple normal = times(lights.NormalMatrix, slope);
  for (const Triple& along : { Triple{ { 0.2, 0.6, 0.0 } }, Triple{ { 0.0, 0.9, 0.2 } } })
  {
    ASSERT_NEAR(dot(along, slope), 0.0, 1e-15);
    const Triple surface = times(lights.WorldMatrix, along);
    EXPECT_NEAR(dot(surface, normal), 0.0, 1e-12 * length(surface) * length(normal));
  }
  EXPECT_GT(dot(times(lights.WorldMatrix, slope), normal), 0.0);

  // Neither is lost in float, however small or large the volume.
  for (const auto& matrix : { lights.WorldMatrix, lights.NormalMatrix })
  {
    const auto [least, most] = std::minmax_element(matrix.begin(), matrix.end());
    EXPECT_NEAR(std::max(-*least, *most), 1.0, 1e-12);
  }
}

// In the frame of the mesh, the angle between light and surface is that of the world.
void LightTransforms::expectAngles()
{
  const Triple direction{ { 2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0 } };
  this->Answers.Lights = { sunlight(direction) };
  const LightUniforms lights = this->lights();
  ASSERT_FALSE(lights.InWorld);
  const Triple toLight = firstThree(lights.Sources[0].Place);
  EXPECT_NEAR(length(toLight), 1.0, 1e-12);
  EXPECT_EQ(lights.Sources[0].Place[3], 0.0);
  const Triple slope{ { 0.6, -0.2, 0.9 } };
  const Triple worldSlope = this->toWorld(slope, 0.0);
  EXPECT_NEAR(
    dot(toLight, slope) / length(slope), -dot(direction, worldSlope) / length(worldSlope), 1e-12);
  for (const auto& matrix : { lights.WorldMatrix, lights.NormalMatrix })
  {
    EXPECT_EQ(times(matrix, slope), slope);
  }
}

TEST_F(LightTransforms, AVolumeAsItIs) { this->expectTransforms(); }

TEST_F(LightTransforms, ATurnedVolume)
{
  this->Transform->Translate(1.0, 2.0, -3.0);
  this->Transform->RotateWXYZ(40.0, 1.0, 2.0, 3.0);
  this->expectTransforms();
  this->expectAngles();
}

TEST_F(LightTransforms, AStretchedVolume)
{
  this->Transform->RotateWXYZ(40.0, 1.0, 2.0, 3.0);
  this->Transform->Scale(0.1, 3.0, 1.5);
  this->Transform->RotateX(20.0); // which with the stretch is a shear
  this->expectTransforms();
}

TEST_F(LightTransforms, AMirroredVolume)
{
  this->Transform->RotateWXYZ(-70.0, 1.0, 0.0, 3.0);
  this->Transform->Scale(1.0, -2.0, 1.0);
  this->expectTransforms();
  this->Transform->Scale(-1.0, -1.0, -1.0);
  this->expectTransforms();
  this->Transform->Scale(1.0, 0.5, 1.0);
  this->expectAngles();
}

TEST_F(LightTransforms, AVolumeFarAway)
{
  this->Transform->Translate(1e6, -2e6, 3e6);
  this->Transform->RotateY(10.0);
  this->expectTransforms();
  this->expectAngles();
}

TEST_F(LightTransforms, VolumesOfAnySize)
{
  for (const double size : { 1e-9, 1e9 })
  {
    SCOPED_TRACE(size);
    this->Mesh.Frame.Radius = 2.5 * size;
    this->Transform->RotateZ(30.0);
    this->expectTransforms();
    this->Mesh.Frame.Radius = 2.5;
    this->Transform->Scale(size, size, size);
    this->expectTransforms();
    this->Transform->Identity();
  }
}

// Of the mapper's place, scale and orientation as well, not only of a user's transform.
TEST_F(LightTransforms, AVolumeWithItsOwnPosition)
{
  this->Volume->SetPosition(3.0, 4.0, 5.0);
  this->Volume->SetScale(2.0);
  this->Volume->RotateY(25.0);
  this->expectTransforms();
  this->expectAngles();
}
} // namespace
