// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The same picture as vtkProjectedTetrahedraMapper within that mapper's own error, so that whoever
// swaps mappers isn't surprised. The ground truth is brute force in world coordinates, which has
// nothing in common with either.
#include "GroundTruthPicture.h"

#include "vtkAutoInit.h"
#include "vtkMatrix4x4.h"
#include "vtkProjectedTetrahedraMapper.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <iostream>

VTK_MODULE_INIT(vtkRenderingVolumeOpenGL2);

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 96;

// The grid with its points in world coordinates.
Grid inWorld(Scene& scene)
{
  const Grid world = withOffsetAndScale(scene.Data, { 0.0, 0.0, 0.0 }, 1.0);
  for (vtkIdType i = 0; i < world->GetNumberOfPoints(); ++i)
  {
    double p[4] = { 0.0, 0.0, 0.0, 1.0 };
    world->GetPoint(i, p);
    scene.Volume->GetMatrix()->MultiplyPoint(p, p);
    world->GetPoints()->SetPoint(i, p);
  }
  return world;
}

// The scene as vtkProjectedTetrahedraMapper draws it, in the same window.
Image byRival(Scene& scene)
{
  vtkNew<vtkProjectedTetrahedraMapper> mapper;
  mapper->SetInputData(scene.Data);
  mapper->SetScalarMode(scene.Mapper->GetScalarMode());
  scene.Volume->SetMapper(mapper);
  scene.Window->Render();
  const Image frame = scene.frame();
  scene.Volume->SetMapper(scene.Mapper);
  return frame;
}

// What the image would be if it were moved, mirrored or had its colours in another order.
Image disturbed(const Image& image, const std::function<std::array<int, 3>(int, int, int)>& source)
{
  Image result(Side, Side);
  for (int y = 0; y < Side; ++y)
  {
    for (int x = 0; x < Side; ++x)
    {
      for (int k = 0; k < 3; ++k)
      {
        const auto [u, v, channel] = source(x, y, k);
        if (u >= 0 && u < Side && v >= 0 && v < Side)
        {
          result.pixel(x, y)[k] = image.pixel(u, v)[channel];
        }
      }
    }
  }
  return result;
}

double rms(const Image& a, const Image& b, const Mask& mask)
{
  return compare(a, b, mask, 0.0, Channels::Rgb).Rms;
}

// rivalRms: how far, in 1/255, the rival may be from the truth and from us.
void expectSamePicture(Scene& scene, double rivalRms)
{
  const bool ofCells = scene.Mapper->GetScalarMode() == VTK_SCALAR_MODE_USE_CELL_DATA;
  const Image truth =
    groundTruthPicture(scene, inWorld(scene), ofCells ? ScalarsOf::Cells : ScalarsOf::Points, Side);
  const Image ours = scene.render();
  const Image frame = scene.frame();
  const Image rival = byRival(scene);
  const Mask seen = silhouette(truth, truth);
  const Difference ourError = compare(ours, truth, seen);
  const double rivalError = rms(rival, truth, seen);
  const double apart = rms(rival, frame, seen);
  std::cout << "[ MEASURED ] ours against the ground truth: " << ourError.text()
            << "\n[ MEASURED ] rival against the ground truth: RMS " << 255.0 * rivalError
            << "/255; frames apart: RMS " << 255.0 * apart << "/255\n";
  EXPECT_LE(ourError.Max, 1.0 / 255.0);
  EXPECT_LE(20.0 * ourError.Rms, rivalError);
  EXPECT_LE(rivalError, rivalRms / 255.0);
  EXPECT_LE(apart, rivalRms / 255.0);

  // Any other place, orientation or order of colours would fit worse.
  for (int dy = -1; dy <= 1; ++dy)
  {
    for (int dx = -1; dx <= 1; ++dx)
    {
      const Image moved = disturbed(frame,
        [=](int x, int y, int k) {
          return std::array<int, 3>{ x + dx, y + dy, k };
        });
      EXPECT_GE(rms(rival, moved, seen), apart) << dx << ' ' << dy;
    }
  }
  const Image mirrored = disturbed(frame,
    [](int x, int y, int k) {
      return std::array<int, 3>{ Side - 1 - x, y, k };
    });
  const Image upsideDown = disturbed(frame,
    [](int x, int y, int k) {
      return std::array<int, 3>{ x, Side - 1 - y, k };
    });
  const Image recoloured = disturbed(frame,
    [](int x, int y, int k) {
      return std::array<int, 3>{ x, y, 2 - k };
    });
  for (const Image& other : { mirrored, upsideDown, recoloured })
  {
    EXPECT_GE(rms(rival, other, {}), 3.0 * rms(rival, frame, {}));
  }
}

Grid lattice() { return jitteredLattice(10, 0.15, 1, sineField(0.5)); }

TEST(RivalPicture, Perspective)
{
  Scene scene(lattice(), Side, Side);
  expectSamePicture(scene, 12.0);
}

TEST(RivalPicture, Parallel)
{
  Scene scene(lattice(), Side, Side);
  scene.camera()->ParallelProjectionOn();
  scene.camera()->SetParallelScale(0.8);
  expectSamePicture(scene, 6.0);
}

TEST(RivalPicture, Thin)
{
  Scene scene(lattice(), Side, Side);
  scene.property()->SetScalarOpacityUnitDistance(2.0);
  expectSamePicture(scene, 3.0);
}

TEST(RivalPicture, UnitDistanceIsOfTheWorld)
{
  // Not by a matrix of the volume, with which the rival's thicknesses are wrong in VTK 9.1.
  Scene scene(withOffsetAndScale(lattice(), { 0.0, 0.0, 0.0 }, 2.0), Side, Side);
  scene.camera()->SetPosition(5.2, 2.8, 5.8);
  scene.camera()->SetFocalPoint(1.2, 0.8, 1.0);
  scene.camera()->SetClippingRange(1.0, 20.0);
  scene.property()->SetScalarOpacityUnitDistance(1.0);
  expectSamePicture(scene, 12.0);
}

TEST(RivalPicture, CellScalars)
{
  Scene scene(lattice(), Side, Side);
  scene.Mapper->SetScalarModeToUseCellData();
  expectSamePicture(scene, 9.0);
}
} // namespace
