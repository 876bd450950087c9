// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ExactPicture.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetmarch::bench
{
namespace
{
using Point = std::array<double, 3>;

constexpr int Steps = 2000;

/// Functions of VTK are slow to ask and not safe to ask in parallel.
class Samples
{
public:
  explicit Samples(vtkVolumeProperty* property)
  {
    for (int i = 0; i <= Count; ++i)
    {
      const double s = static_cast<double>(i) / Count;
      std::array<double, 4>& sample = this->Values[i];
      property->GetRGBTransferFunction()->GetColor(s, sample.data());
      sample[3] = property->GetScalarOpacity()->GetValue(s);
    }
  }
  /// Colour and opacity at a scalar of 0..1.
  std::array<double, 4> operator()(double scalar) const
  {
    const double x = std::clamp(scalar, 0.0, 1.0) * Count;
    const int i = std::min(static_cast<int>(x), Count - 1);
    std::array<double, 4> value{};
    for (int k = 0; k < 4; ++k)
    {
      value[k] = this->Values[i][k] + (x - i) * (this->Values[i + 1][k] - this->Values[i][k]);
    }
    return value;
  }

private:
  static constexpr int Count = 1 << 16;
  std::vector<std::array<double, 4>> Values = std::vector<std::array<double, 4>>(Count + 1);
};

/// Where the line from a to b is within the unit cube, as shares of it; first > second: nowhere.
std::array<double, 2> withinCube(const Point& a, const Point& b)
{
  std::array<double, 2> range{ { 0.0, 1.0 } };
  for (int k = 0; k < 3; ++k)
  {
    const double at0 = (0.0 - a[k]) / (b[k] - a[k]);
    const double at1 = (1.0 - a[k]) / (b[k] - a[k]);
    range[0] = std::max(range[0], std::min(at0, at1));
    range[1] = std::min(range[1], std::max(at0, at1));
  }
  return range;
}

class Integrator
{
public:
  Integrator(const ExactField& field, vtkVolumeProperty* property)
    : Field(field)
    , Functions(property)
    , UnitDistance(property->GetScalarOpacityUnitDistance())
  {
  }

  void integrate(const Point& a, const Point& b, float* rgba) const
  {
    const auto [first, last] = withinCube(a, b);
    if (!(first < last))
    {
      return;
    }
    const double step = (last - first) / Steps;
    const double length = step * std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    std::array<double, 3> color{};
    double transmittance = 1.0;
    for (int i = 0; i < Steps; ++i)
    {
      const double t = first + (i + 0.5) * step;
      const auto sample = this->Functions(
        this->Field(a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])));
      const double left = transmittance * std::exp(-sample[3] / this->UnitDistance * length);
      for (int k = 0; k < 3; ++k)
      {
        color[k] += (transmittance - left) * sample[k];
      }
      transmittance = left;
    }
    std::copy(color.begin(), color.end(), rgba);
    rgba[3] = static_cast<float>(1.0 - transmittance);
  }

private:
  const ExactField& Field;
  Samples Functions;
  double UnitDistance;
};

Point unproject(vtkMatrix4x4* clipToWorld, double x, double y, double z)
{
  const double in[4] = { x, y, z, 1.0 };
  double out[4];
  clipToWorld->MultiplyPoint(in, out);
  return { { out[0] / out[3], out[1] / out[3], out[2] / out[3] } };
}
} // namespace

testing::Image exactPicture(
  const ExactField& field, vtkVolumeProperty* property, vtkRenderer* renderer)
{
  const int* size = renderer->GetSize();
  testing::Image picture(size[0], size[1]);
  vtkNew<vtkMatrix4x4> clipToWorld;
  vtkMatrix4x4::Invert(renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
                         renderer->GetTiledAspectRatio(), -1.0, 1.0),
    clipToWorld);
  const Integrator integrator(field, property);
  vtkSMPTools::For(0, picture.Height, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (int row = static_cast<int>(first); row < last; ++row)
      {
        for (int column = 0; column < picture.Width; ++column)
        {
          const double x = (column + 0.5) / picture.Width * 2.0 - 1.0;
          const double y = (row + 0.5) / picture.Height * 2.0 - 1.0;
          integrator.integrate(unproject(clipToWorld, x, y, -1.0),
            unproject(clipToWorld, x, y, 1.0), picture.pixel(column, row));
        }
      }
    });
  return picture;
}
} // namespace tetmarch::bench
