// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentIntegral.h"

#include "GaussLegendre.h"

#include <algorithm>
#include <cmath>

namespace tetmarch::testing
{
namespace
{
constexpr int Order = GaussLegendre::Order;
constexpr double Tolerance = 1e-12;
// Halving so often, a step between two nodes is found to within 2^-44 of its segment.
constexpr int DeepestLevel = 44;

// Nodes of a function as VTK gives them: position first, midpoint and sharpness last.
template <std::size_t Size, typename Function>
void addBreaks(Function* function, bool isLog, std::vector<double>& breaks)
{
  double before[Size] = {};
  for (int i = 0; function && i < function->GetSize(); ++i)
  {
    double node[Size];
    function->GetNodeValue(i, node);
    breaks.push_back(node[0]);
    if (i > 0)
    {
      const double a = before[0];
      const double b = node[0];
      const double middle = before[Size - 2];
      breaks.push_back(isLog && a > 0.0 ? a * std::pow(b / a, middle) : a + middle * (b - a));
    }
    std::copy(node, node + Size, before);
  }
}

// From 0 to 1, cut where the scalar goes through one of the values.
std::vector<double> smoothParts(const Cubic& scalar, const std::vector<double>& breaks)
{
  std::vector<double> cuts = { 0.0, 1.0 };
  const double least = scalar.least();
  const double greatest = scalar.greatest();
  for (const double value : breaks)
  {
    if (value > least && value < greatest)
    {
      const std::vector<double> crossings = scalar.crossingsOf(value);
      cuts.insert(cuts.end(), crossings.begin(), crossings.end());
    }
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

double apart(const SegmentResult& a, const SegmentResult& b)
{
  double most = std::abs(std::exp(-a.Depth) - std::exp(-b.Depth));
  for (int c = 0; c < 3; ++c)
  {
    most = std::max(most, std::abs(a.Colour[c] - b.Colour[c]));
  }
  return most;
}

double apart(const OpacitySums& a, const OpacitySums& b)
{
  // Scalars may be of any size.
  const double apart = std::abs(a.OpacityTimesScalar - b.OpacityTimesScalar);
  return std::max(std::abs(a.Opacity - b.Opacity), apart / (1.0 + std::abs(a.OpacityTimesScalar)));
}

// An integral over [u0, u1], halved until a part and its halves agree.
template <typename Integral, typename Result>
Result refined(
  const Integral& over, double u0, double u1, const Result& whole, double tolerance, int level)
{
  const double middle = 0.5 * (u0 + u1);
  const Result near = over(u0, middle);
  const Result far = over(middle, u1);
  const Result both = composed(near, far);
  if (apart(both, whole) <= tolerance || level == DeepestLevel)
  {
    return both;
  }
  return composed(refined(over, u0, middle, near, tolerance, level + 1),
    refined(over, middle, u1, far, tolerance, level + 1));
}

template <typename Integral>
auto refined(const Integral& over, double u0, double u1, double tolerance = Tolerance)
{
  return refined(over, u0, u1, over(u0, u1), tolerance, 0);
}

double unlit(double) { return 1.0; }
} // namespace

OpticalModel opticalModelOf(const std::vector<std::array<double, 4>>& colours,
  const std::vector<std::array<double, 2>>& opacities)
{
  OpticalModel model;
  model.Colour = vtkSmartPointer<vtkColorTransferFunction>::New();
  model.Opacity = vtkSmartPointer<vtkPiecewiseFunction>::New();
  for (const auto& c : colours)
  {
    model.Colour->AddRGBPoint(c[0], c[1], c[2], c[3]);
  }
  for (const auto& o : opacities)
  {
    model.Opacity->AddPoint(o[0], o[1]);
  }
  return model;
}

Vec3 OpticalModel::colour(double scalar) const
{
  Vec3 rgb;
  if (this->Colour)
  {
    this->Colour->GetColor(scalar, rgb.data());
  }
  else
  {
    rgb.fill(this->Gray->GetValue(scalar));
  }
  return rgb;
}

double OpticalModel::extinction(double scalar) const
{
  const double opacity = this->Opacity->GetValue(scalar);
  return (this->Law == OpacityLaw::Linear ? opacity
                                          : -std::log1p(-std::min(opacity, this->MostOpacity))) /
         this->UnitDistance;
}

SegmentIntegral::SegmentIntegral(const OpticalModel& model)
  : Model(model)
{
  const bool isLog = model.Colour && model.Colour->GetScale() == VTK_CTF_LOG10;
  addBreaks<6>(model.Colour.Get(), isLog, this->Breaks);
  addBreaks<4>(model.Gray.Get(), model.Gray && model.Gray->GetUseLogScale(), this->Breaks);
  addBreaks<4>(model.Opacity.Get(), model.Opacity->GetUseLogScale(), this->Breaks);
  if (model.Law == OpacityLaw::Logarithmic)
  {
    // Where a ramp passes MostOpacity the extinction has a kink too.
    for (int i = 1; i < model.Opacity->GetSize(); ++i)
    {
      double a[4];
      double b[4];
      model.Opacity->GetNodeValue(i - 1, a);
      model.Opacity->GetNodeValue(i, b);
      const double s = (model.MostOpacity - a[1]) / (b[1] - a[1]);
      if (s > 0.0 && s < 1.0)
      {
        this->Breaks.push_back(a[0] + s * (b[0] - a[0]));
      }
    }
  }
  std::sort(this->Breaks.begin(), this->Breaks.end());
}

SegmentResult SegmentIntegral::integrate(double f0, double f1, double length) const
{
  return this->integrate(Cubic::linear(f0, f1), length);
}

SegmentResult SegmentIntegral::integrate(const Cubic& scalar, double length) const
{
  const std::vector<double> cuts = smoothParts(scalar, this->Breaks);
  SegmentResult result;
  for (std::size_t i = 1; i < cuts.size(); ++i)
  {
    result = composed(result, refined([&](double u0, double u1)
                                { return this->quadratureOf(scalar, u0, u1, length, unlit); },
                                cuts[i - 1], cuts[i]));
  }
  return result;
}

SegmentResult SegmentIntegral::integrateLit(const Cubic& scalar, double length,
  const std::function<double(double)>& brightness, double tolerance) const
{
  const std::vector<double> cuts = smoothParts(scalar, this->Breaks);
  SegmentResult result;
  for (std::size_t i = 1; i < cuts.size(); ++i)
  {
    result = composed(result, refined([&](double u0, double u1)
                                { return this->quadratureOf(scalar, u0, u1, length, brightness); },
                                cuts[i - 1], cuts[i], tolerance));
  }
  return result;
}

OpacitySums SegmentIntegral::opacitySums(
  const Cubic& scalar, double length, double low, double high) const
{
  std::vector<double> breaks = this->Breaks;
  breaks.push_back(low);
  breaks.push_back(high);
  const std::vector<double> cuts = smoothParts(scalar, breaks);
  OpacitySums sums;
  for (std::size_t i = 1; i < cuts.size(); ++i)
  {
    const double within = scalar.at(0.5 * (cuts[i - 1] + cuts[i]));
    if (within >= low && within <= high)
    {
      sums = composed(
        sums, refined([&](double u0, double u1) { return this->sumsOf(scalar, u0, u1, length); },
                cuts[i - 1], cuts[i]));
    }
  }
  return sums;
}

template <typename Brightness>
SegmentResult SegmentIntegral::quadratureOf(
  const Cubic& scalar, double u0, double u1, double length, const Brightness& brightness) const
{
  const GaussLegendre& q = GaussLegendre::instance();
  const double part = (u1 - u0) * length;
  double values[Order];
  double extinction[Order];
  SegmentResult result;
  for (int i = 0; i < Order; ++i)
  {
    values[i] = scalar.at(u0 + q.Node[i] * (u1 - u0));
    extinction[i] = this->Model.extinction(values[i]);
    result.Depth += part * q.Weight[i] * extinction[i];
  }
  for (int i = 0; i < Order; ++i)
  {
    double depth = 0.0;
    for (int j = 0; j < Order; ++j)
    {
      depth += part * q.UpTo[i][j] * extinction[j];
    }
    const double weight = part * q.Weight[i] * extinction[i] * std::exp(-depth) *
                          brightness(u0 + q.Node[i] * (u1 - u0));
    const Vec3 colour = this->Model.colour(values[i]);
    for (int c = 0; c < 3; ++c)
    {
      result.Colour[c] += weight * colour[c];
    }
  }
  return result;
}

OpacitySums SegmentIntegral::sumsOf(const Cubic& scalar, double u0, double u1, double length) const
{
  const GaussLegendre& q = GaussLegendre::instance();
  OpacitySums sums;
  sums.Length = (u1 - u0) * length;
  for (int i = 0; i < Order; ++i)
  {
    const double value = scalar.at(u0 + q.Node[i] * (u1 - u0));
    const double opacity = sums.Length * q.Weight[i] * this->Model.Opacity->GetValue(value);
    sums.Opacity += opacity;
    sums.OpacityTimesScalar += opacity * value;
  }
  return sums;
}

SegmentResult composed(const SegmentResult& near, const SegmentResult& far)
{
  SegmentResult result = near;
  result.Depth += far.Depth;
  for (int c = 0; c < 3; ++c)
  {
    result.Colour[c] += std::exp(-near.Depth) * far.Colour[c];
  }
  return result;
}

OpacitySums composed(const OpacitySums& near, const OpacitySums& far)
{
  return { near.Length + far.Length, near.Opacity + far.Opacity,
    near.OpacityTimesScalar + far.OpacityTimesScalar };
}
} // namespace tetmarch::testing
