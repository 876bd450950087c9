// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shot.h"

#include "CutLine.h"

#include "vtkCellData.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkVolume.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tetmarch::testing
{
namespace
{
OpticalModel bumpyModel()
{
  return opticalModelOf({ { { 0.0, 0.1, 0.2, 1.0 } }, { { 0.45, 0.1, 1.0, 0.3 } },
                          { { 0.55, 1.0, 0.9, 0.0 } }, { { 1.0, 1.0, 0.1, 0.1 } } },
    { { { 0.0, 0.6 } }, { { 0.4, 0.1 } }, { { 0.5, 0.9 } }, { { 0.6, 0.0 } }, { { 1.0, 0.8 } } });
}

OpticalModel modelOf(const Shot& shot)
{
  OpticalModel model = shot.Optics;
  model.UnitDistance = shot.UnitDistance;
  return model;
}

// The same grid with its points in world coordinates.
Grid inWorld(const Shot& shot)
{
  const Grid world = withOffsetAndScale(shot.Data, { 0.0, 0.0, 0.0 }, 1.0);
  for (vtkIdType i = 0; i < world->GetNumberOfPoints(); ++i)
  {
    double p[3];
    world->GetPoint(i, p);
    shot.Transform->TransformPoint(p, p);
    world->GetPoints()->SetPoint(i, p);
  }
  return world;
}

// The parts of a line that are left, composited front to back.
std::array<double, 4> integrateLeft(
  const GroundTruthScene& groundTruth, const Shot& shot, const Vec3& from, const Vec3& to)
{
  const auto inData = [&shot](const Vec3& world)
  {
    Vec3 data;
    shot.Transform->GetInverse()->TransformPoint(world.data(), data.data());
    return data;
  };
  const Vec3 d{ to[0] - from[0], to[1] - from[1], to[2] - from[2] };
  const double far = std::hypot(d[0], d[1], d[2]);
  std::array<double, 4> seen{};
  for (const auto& part : partsLeft(shot.Cut, { from, inData(from) }, { to, inData(to) }))
  {
    const auto rgba = groundTruth.integrate(from, d, part[0] * far, part[1] * far);
    const double through = 1.0 - seen[3];
    for (int k = 0; k < 4; ++k)
    {
      seen[k] += through * rgba[k];
    }
  }
  return seen;
}

std::unique_ptr<FreshFrame> frameOf(const Shot& shot, vtkRenderer* renderer, vtkVolume* volume)
{
  const bool ofCells = shot.Scalars != ScalarsOf::Points;
  vtkDataArray* array =
    ofCells ? shot.Data->GetCellData()->GetScalars() : shot.Data->GetPointData()->GetScalars();
  const OpticalModel model = modelOf(shot);
  vtkVolumeProperty* property = volume->GetProperty();
  property->SetColor(model.Colour);
  property->SetScalarOpacity(model.Opacity);
  property->SetScalarOpacityUnitDistance(model.UnitDistance);
  if (shot.Adjust)
  {
    shot.Adjust(property);
  }
  renderer->SetActiveCamera(shot.Camera);
  volume->SetUserTransform(shot.Transform);
  FrameInput input{ { { shot.Data }, { array, ofCells }, shot.Vector, shot.Blend, shot.Cut },
    renderer, volume };
  input.Effects.Blend = static_cast<BlendMode>(shot.Blend.Mode);
  return std::make_unique<FreshFrame>(input);
}
} // namespace

vtkStandardNewMacro(WindowlessRenderer);

Shot::Shot()
  : Optics(bumpyModel())
{
  this->Camera->SetPosition(2.1, 1.4, 2.9);
  this->Camera->SetFocalPoint(0.5, 0.45, 0.5);
  this->Camera->SetViewUp(0.1, 1.0, 0.0);
  this->Camera->SetClippingRange(0.1, 20.0);
}

std::array<Vec3, 2> lineOf(const Shot& shot, int x, int y, double depth)
{
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(shot.Camera->GetCompositeProjectionTransformMatrix(1.0, -1.0, 1.0), inverse);
  const auto unproject = [&](double z)
  {
    const double in[4] = { (x + 0.5) / Shot::Size * 2.0 - 1.0, (y + 0.5) / Shot::Size * 2.0 - 1.0,
      z, 1.0 };
    double out[4];
    inverse->MultiplyPoint(in, out);
    return Vec3{ out[0] / out[3], out[1] / out[3], out[2] / out[3] };
  };
  return { unproject(-1.0), unproject(2.0 * depth - 1.0) };
}

Image byGroundTruth(const Shot& shot)
{
  constexpr int Size = Shot::Size;
  const GroundTruthScene groundTruth(inWorld(shot), modelOf(shot), shot.Scalars);
  Image image(Size, Size);
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const auto [from, to] =
        lineOf(shot, x, y, shot.Depths.empty() ? 1.0 : double(shot.Depths[y * Size + x]));
      const auto rgba =
        from != to ? integrateLeft(groundTruth, shot, from, to) : std::array<double, 4>{};
      for (int k = 0; k < 4; ++k)
      {
        image.pixel(x, y)[k] = static_cast<float>(rgba[k]);
      }
    }
  }
  return image;
}

MarchedShot::MarchedShot(const Shot& shot, const AccuracyLevel& level)
  : Frame(frameOf(shot, this->Renderer, this->Volume))
  , Made(Frame->at(level, Shot::Size, Shot::Size))
  , Mesh(Frame->volume().mesh())
  , Scalars(Frame->volume().scalars())
  , Scene(Made->scene())
{
  this->Scene.WindowDepths = shot.Depths.empty() ? nullptr : shot.Depths.data();
}

template <typename Real>
ReferenceImage byMarch(const Shot& shot, const AccuracyLevel& level)
{
  const MarchedShot marched(shot, level);
  return renderReference<Real>(marched.Scene, level);
}

template <typename Real>
Image byReference(const Shot& shot, const AccuracyLevel& level, MarchCounters& counters)
{
  const ReferenceImage image = byMarch<Real>(shot, level);
  counters = image.Counters;
  return Image::fromFloats(Shot::Size, Shot::Size, image.Pixels.data());
}

template ReferenceImage byMarch<float>(const Shot&, const AccuracyLevel&);
template ReferenceImage byMarch<double>(const Shot&, const AccuracyLevel&);

template Image byReference<float>(const Shot&, const AccuracyLevel&, MarchCounters&);
template Image byReference<double>(const Shot&, const AccuracyLevel&, MarchCounters&);
} // namespace tetmarch::testing
