// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageSceneRays.h"

#include "vtkCamera.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"

#include <algorithm>
#include <cmath>

namespace tetmarch::testing
{
ImageSceneRays::ImageSceneRays(const ImageStage& stage, int width, int height)
  : Stage(stage)
  , Width(width)
  , Height(height)
  , ToWorld(stage.Renderer->GetActiveCamera(), static_cast<double>(width) / height)
{
  vtkMatrix4x4::Invert(stage.Volume->GetMatrix(), this->ToData);
}

PixelRay ImageSceneRays::at(int x, int y) const
{
  const double cx = (2.0 * x + 1.0) / this->Width - 1.0;
  const double cy = (2.0 * y + 1.0) / this->Height - 1.0;
  const Vec3 ends[2] = { this->ToWorld(cx, cy, -1.0), this->ToWorld(cx, cy, 1.0) };
  // By shares of what is between the near and the far plane.
  double from = 0.0;
  double to = 1.0;
  vtkPlaneCollection* planes = this->Stage.Mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    double point[2][3];
    std::copy(ends[0].begin(), ends[0].end(), point[0]);
    std::copy(ends[1].begin(), ends[1].end(), point[1]);
    const double a = planes->GetItem(i)->EvaluateFunction(point[0]);
    const double b = planes->GetItem(i)->EvaluateFunction(point[1]);
    if (a < 0.0 && b < 0.0)
    {
      to = from;
    }
    else if (a < 0.0)
    {
      from = std::max(from, a / (a - b));
    }
    else if (b < 0.0)
    {
      to = std::min(to, a / (a - b));
    }
  }
  Vec3 inData[2];
  for (int end = 0; end < 2; ++end)
  {
    const double p[4] = { ends[end][0], ends[end][1], ends[end][2], 1.0 };
    double q[4];
    this->ToData->MultiplyPoint(p, q);
    inData[end] = { q[0] / q[3], q[1] / q[3], q[2] / q[3] };
  }
  PixelRay ray;
  ray.Origin = inData[0];
  double length = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    ray.Direction[a] = inData[1][a] - inData[0][a];
    length = std::hypot(length, ray.Direction[a]);
  }
  for (double& d : ray.Direction)
  {
    d /= length;
  }
  if (from < to)
  {
    ray.Parts.push_back({ from * length, to * length });
  }
  this->crop(ray);
  return ray;
}

// Cuts at all six planes of cropping and keeps the parts whose region has its bit.
void ImageSceneRays::crop(PixelRay& ray) const
{
  if (!this->Stage.Mapper->GetCropping() || ray.Parts.empty())
  {
    return;
  }
  const double* planes = this->Stage.Mapper->GetCroppingRegionPlanes();
  const auto [begin, end] = ray.Parts.front();
  std::vector<double> cuts = { begin, end };
  for (int i = 0; i < 6; ++i)
  {
    const double t = (planes[i] - ray.Origin[i / 2]) / ray.Direction[i / 2];
    if (t > begin && t < end)
    {
      cuts.push_back(t);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  ray.Parts.clear();
  for (std::size_t i = 1; i < cuts.size(); ++i)
  {
    int region = 0;
    for (int a = 2; a >= 0; --a)
    {
      const double x = ray.Origin[a] + 0.5 * (cuts[i - 1] + cuts[i]) * ray.Direction[a];
      region = 3 * region + (x < planes[2 * a] ? 0 : x < planes[2 * a + 1] ? 1 : 2);
    }
    if ((this->Stage.Mapper->GetCroppingRegionFlags() >> region & 1) != 0)
    {
      ray.Parts.push_back({ cuts[i - 1], cuts[i] });
    }
  }
}
} // namespace tetmarch::testing
