// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentIntegral.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace tetmarch::testing
{
namespace
{
constexpr int Order = 10;
constexpr double Tolerance = 1e-12;
// Halving so often, a step between two nodes is found to within 2^-44 of its segment.
constexpr int DeepestLevel = 44;

// Nodes and weights on [0, 1], and the integrals of the Lagrange polynomials from 0 to each node:
// exact for the polynomial through the nodes, hence the depth at each of them.
struct Quadrature
{
  double Node[Order];
  double Weight[Order];
  double UpTo[Order][Order];

  Quadrature()
  {
    for (int i = 0; i < Order; ++i)
    {
      // Newton's iteration on the Legendre polynomial from the usual guess (Abramowitz and
      // Stegun 22.16.6).
      double x = std::cos(vtkMath::Pi() * (i + 0.75) / (Order + 0.5));
      double slope = 0.0;
      for (int iteration = 0; iteration < 50; ++iteration)
      {
        double p = 1.0;
        double before = 0.0;
        for (int k = 1; k <= Order; ++k)
        {
          const double next = ((2.0 * k - 1.0) * x * p - (k - 1.0) * before) / k;
          before = p;
          p = next;
        }
        slope = Order * (x * p - before) / (x * x - 1.0);
        x -= p / slope;
      }
      this->Node[i] = 0.5 * (1.0 - x);
      this->Weight[i] = 1.0 / ((1.0 - x * x) * slope * slope);
    }
    for (int i = 0; i < Order; ++i)
    {
      for (int j = 0; j < Order; ++j)
      {
        this->UpTo[i][j] = 0.0;
        for (int k = 0; k < Order; ++k)
        {
          this->UpTo[i][j] +=
            this->Node[i] * this->Weight[k] * this->lagrange(j, this->Node[i] * this->Node[k]);
        }
      }
    }
  }

  double lagrange(int j, double x) const
  {
    double product = 1.0;
    for (int k = 0; k < Order; ++k)
    {
      product *= k == j ? 1.0 : (x - this->Node[k]) / (this->Node[j] - this->Node[k]);
    }
    return product;
  }
};

const Quadrature& quadrature()
{
  static const Quadrature instance;
  return instance;
}

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
} // namespace

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
  std::vector<double> values = { f0 };
  for (const double value : this->Breaks)
  {
    if (value > std::min(f0, f1) && value < std::max(f0, f1))
    {
      values.push_back(value);
    }
  }
  if (f1 < f0)
  {
    std::reverse(values.begin() + 1, values.end());
  }
  values.push_back(f1);

  SegmentResult result;
  for (std::size_t i = 1; i < values.size(); ++i)
  {
    const double fraction = f1 == f0 ? 1.0 : (values[i] - values[i - 1]) / (f1 - f0);
    if (fraction > 0.0)
    {
      const double part = fraction * length;
      const SegmentResult whole = this->quadratureOf(values[i - 1], values[i], part);
      result = composed(result, this->refined(values[i - 1], values[i], part, whole, 0));
    }
  }
  return result;
}

SegmentResult SegmentIntegral::quadratureOf(double f0, double f1, double length) const
{
  const Quadrature& q = quadrature();
  double extinction[Order];
  SegmentResult result;
  for (int i = 0; i < Order; ++i)
  {
    extinction[i] = this->Model.extinction(f0 + q.Node[i] * (f1 - f0));
    result.Depth += length * q.Weight[i] * extinction[i];
  }
  for (int i = 0; i < Order; ++i)
  {
    double depth = 0.0;
    for (int j = 0; j < Order; ++j)
    {
      depth += length * q.UpTo[i][j] * extinction[j];
    }
    const double weight = length * q.Weight[i] * extinction[i] * std::exp(-depth);
    const Vec3 colour = this->Model.colour(f0 + q.Node[i] * (f1 - f0));
    for (int c = 0; c < 3; ++c)
    {
      result.Colour[c] += weight * colour[c];
    }
  }
  return result;
}

SegmentResult SegmentIntegral::refined(
  double f0, double f1, double length, const SegmentResult& whole, int level) const
{
  const double middle = 0.5 * (f0 + f1);
  const SegmentResult near = this->quadratureOf(f0, middle, 0.5 * length);
  const SegmentResult far = this->quadratureOf(middle, f1, 0.5 * length);
  const SegmentResult both = composed(near, far);
  double error = std::abs(std::exp(-both.Depth) - std::exp(-whole.Depth));
  for (int c = 0; c < 3; ++c)
  {
    error = std::max(error, std::abs(both.Colour[c] - whole.Colour[c]));
  }
  if (error <= Tolerance || level == DeepestLevel)
  {
    return both;
  }
  return composed(this->refined(f0, middle, 0.5 * length, near, level + 1),
    this->refined(middle, f1, 0.5 * length, far, level + 1));
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
} // namespace tetmarch::testing
