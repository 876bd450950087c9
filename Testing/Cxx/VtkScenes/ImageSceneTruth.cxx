// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageSceneTruth.h"

#include "ComponentFields.h"

#include "vtkContourValues.h"
#include "vtkPlane.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace tetmarch::testing
{
namespace
{
using Rgba = std::array<double, 4>;

Rgba over(const Rgba& front, const Rgba& back)
{
  Rgba both;
  for (int c = 0; c < 4; ++c)
  {
    both[c] = front[c] + (1.0 - front[3]) * back[c];
  }
  return both;
}

Rgba gray(double value) { return { value, value, value, 1.0 }; }

double logarithmic(double opacity)
{
  return -std::log1p(-std::min(opacity, OpticalModel().MostOpacity));
}

OpticalModel modelOf(vtkVolumeProperty* property)
{
  OpticalModel model;
  if (property->GetColorChannels() == 3)
  {
    model.Colour = property->GetRGBTransferFunction();
  }
  else
  {
    model.Gray = property->GetGrayTransferFunction();
  }
  model.Opacity = property->GetScalarOpacity();
  model.UnitDistance = property->GetScalarOpacityUnitDistance();
  model.Law = OpacityLaw::Logarithmic;
  return model;
}
} // namespace

ImageSceneTruth::ImageSceneTruth(const ImageStage& stage, vtkDataSet* data, int width, int height)
  : Stage(stage)
  , Rays(stage, width, height)
  , Model(modelOf(stage.Property))
  , Optics(Model)
{
  this->readScalars(data);
}

Rgba ImageSceneTruth::at(int x, int y) const
{
  const PixelRay ray = this->Rays.at(x, y);
  Rgba seen{};
  switch (this->Stage.Mapper->GetBlendMode())
  {
    case vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND:
      seen = this->extreme(ray, true);
      break;
    case vtkVolumeMapper::MINIMUM_INTENSITY_BLEND:
      seen = this->extreme(ray, false);
      break;
    case vtkVolumeMapper::AVERAGE_INTENSITY_BLEND:
      seen = this->sum(ray, true);
      break;
    case vtkVolumeMapper::ADDITIVE_BLEND:
      seen = this->sum(ray, false);
      break;
    case vtkVolumeMapper::ISOSURFACE_BLEND:
      seen = this->surfaces(ray);
      break;
    case vtkVolumeMapper::SLICE_BLEND:
      seen = this->slice(ray);
      break;
    default:
      seen = this->Truths.size() > 1 ? this->components(ray) : this->composite(ray);
      break;
  }
  const double window = this->Stage.Mapper->GetFinalColorWindow();
  const double level = this->Stage.Mapper->GetFinalColorLevel();
  for (int c = 0; c < 3; ++c)
  {
    seen[c] = seen[c] / window + seen[3] * (0.5 - level / window);
  }
  return seen;
}

Rgba ImageSceneTruth::coloured(double scalar) const
{
  const Vec3 colour = this->Model.colour(scalar);
  const double opacity = this->Model.Opacity->GetValue(scalar);
  return { opacity * colour[0], opacity * colour[1], opacity * colour[2], opacity };
}

Rgba ImageSceneTruth::composite(const PixelRay& ray) const
{
  SegmentResult all;
  for (const auto& [from, to] : ray.Parts)
  {
    for (const ScalarSegment& segment :
      this->Truths[0]->segments(ray.Origin, ray.Direction, from, to))
    {
      const double length = segment.T1 - segment.T0;
      all = composed(all, this->Optics.integrate(segment.Scalar, length));
    }
  }
  return { all.Colour[0], all.Colour[1], all.Colour[2], -std::expm1(-all.Depth) };
}

Rgba ImageSceneTruth::components(const PixelRay& ray) const
{
  constexpr int Steps = 256;
  const std::size_t count = this->Truths.size();
  const double unit = this->Model.UnitDistance;
  Rgba seen{};
  for (const auto& [from, to] : ray.Parts)
  {
    std::vector<std::vector<ScalarSegment>> segments;
    for (const auto& truth : this->Truths)
    {
      segments.push_back(truth->segments(ray.Origin, ray.Direction, from, to));
    }
    for (std::size_t s = 0; s < segments[0].size(); ++s)
    {
      const double step = (segments[0][s].T1 - segments[0][s].T0) / Steps;
      for (int i = 0; i < Steps; ++i)
      {
        std::vector<double> scalars;
        for (std::size_t c = 0; c < count; ++c)
        {
          scalars.push_back(segments[c][s].Scalar.at((i + 0.5) / Steps));
        }
        if (count == 4 && !this->Stage.Property->GetIndependentComponents())
        {
          // Of bytes.
          std::for_each(scalars.begin(), scalars.begin() + 3, [](double& x) { x /= 255.0; });
        }
        const Rgba medium = mediumAt(this->Stage.Property, scalars, logarithmic);
        const double alpha = -std::expm1(-medium[3] / unit * step);
        const double share = medium[3] > 0.0 ? alpha / medium[3] : 0.0;
        seen = over(seen, { share * medium[0], share * medium[1], share * medium[2], alpha });
      }
    }
  }
  return seen;
}

Rgba ImageSceneTruth::extreme(const PixelRay& ray, bool greatest) const
{
  std::optional<double> found;
  for (const auto& [from, to] : ray.Parts)
  {
    if (const auto both = this->Truths[0]->extremes(ray.Origin, ray.Direction, from, to))
    {
      found = !found     ? (*both)[greatest]
              : greatest ? std::max(*found, (*both)[1])
                         : std::min(*found, (*both)[0]);
    }
  }
  return found ? this->coloured(*found) : Rgba{};
}

// Intensity is where a scalar is in the range of the data.
Rgba ImageSceneTruth::sum(const PixelRay& ray, bool averages) const
{
  const double* range = this->Stage.Mapper->GetAverageIPScalarRange();
  const double infinity = LatticeTruth::Infinity;
  OpacitySums sums;
  for (const auto& [from, to] : ray.Parts)
  {
    sums =
      composed(sums, this->Truths[0]->opacitySums(ray.Origin, ray.Direction,
                       averages ? range[0] : -infinity, averages ? range[1] : infinity, from, to));
  }
  if (!(sums.Length > 0.0))
  {
    return {};
  }
  const double sum =
    (sums.OpacityTimesScalar - this->Range[0] * sums.Opacity) / (this->Range[1] - this->Range[0]);
  const double unit = this->Model.UnitDistance;
  return gray(std::min(sum / (averages ? sums.Length : unit), 1.0));
}

// The plane is one of the world.
Rgba ImageSceneTruth::slice(const PixelRay& ray) const
{
  auto* plane = vtkPlane::SafeDownCast(this->Stage.Property->GetSliceFunction());
  double values[2];
  for (int end = 0; end < 2; ++end)
  {
    double p[4] = { 0.0, 0.0, 0.0, 1.0 };
    for (int a = 0; a < 3; ++a)
    {
      p[a] = ray.Origin[a] + end * ray.Direction[a];
    }
    this->Stage.Volume->GetMatrix()->MultiplyPoint(p, p);
    values[end] = plane->EvaluateFunction(p);
  }
  const double t = values[0] / (values[0] - values[1]);
  for (const auto& [from, to] : ray.Parts)
  {
    for (const ScalarSegment& segment :
      this->Truths[0]->segments(ray.Origin, ray.Direction, from, to))
    {
      if (t >= segment.T0 && t < segment.T1)
      {
        return this->coloured(segment.Scalar.at((t - segment.T0) / (segment.T1 - segment.T0)));
      }
    }
  }
  return {};
}

Rgba ImageSceneTruth::surfaces(const PixelRay& ray) const
{
  vtkContourValues* contours = this->Stage.Property->GetIsoSurfaceValues();
  const std::vector<double> values(
    contours->GetValues(), contours->GetValues() + contours->GetNumberOfContours());
  Rgba seen{};
  for (const auto& [from, to] : ray.Parts)
  {
    seen = over(seen, this->Truths[0]->isosurfaces(ray.Origin, ray.Direction, values, from, to));
  }
  return seen;
}

Difference differenceFrom(const ImageSceneTruth& truth, const Image& picture, int every)
{
  Image expected(picture.Width, picture.Height);
  Mask seen(expected.Rgba.size() / 4, false);
  for (int y = every / 2; y < picture.Height; y += every)
  {
    for (int x = every / 2; x < picture.Width; x += every)
    {
      const Rgba rgba = truth.at(x, y);
      const float* drawn = picture.pixel(x, y);
      std::copy(rgba.begin(), rgba.end(), expected.pixel(x, y));
      seen[y * picture.Width + x] =
        rgba[3] > 0.0 || std::max({ drawn[0], drawn[1], drawn[2] }) > 0.0f;
    }
  }
  return compare(picture, expected, seen, 2.0 / 255.0, Channels::Rgb);
}
} // namespace tetmarch::testing
