// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ComponentTruth.h"

#include "ComponentFields.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tetmarch::testing
{
namespace
{
constexpr int MostHalvings = 12;
constexpr double Agreement = 1e-9;

// Gauss-Legendre quadrature on [0, 1].
constexpr int Nodes = 5;
constexpr double Places[Nodes] = { 0.046910077030668004, 0.23076534494715845, 0.5,
  0.76923465505284155, 0.953089922969332 };
constexpr double Weights[Nodes] = { 0.11846344252809454, 0.23931433524968323, 0.28444444444444444,
  0.23931433524968323, 0.11846344252809454 };

// Whose functions component k has.
int functionsOf(vtkVolumeProperty* property, int k)
{
  return property->GetIndependentComponents() ? k : 0;
}

std::vector<double> nodesOf(vtkVolumeProperty* property, int k)
{
  std::vector<double> nodes;
  const int functions = functionsOf(property, k);
  vtkColorTransferFunction* colours = property->GetRGBTransferFunction(functions);
  for (int i = 0; i < colours->GetSize(); ++i)
  {
    double node[6];
    colours->GetNodeValue(i, node);
    nodes.push_back(node[0]);
  }
  vtkPiecewiseFunction* opacities = property->GetScalarOpacity(functions);
  for (int i = 0; i < opacities->GetSize(); ++i)
  {
    double node[4];
    opacities->GetNodeValue(i, node);
    nodes.push_back(node[0]);
  }
  return nodes;
}
} // namespace

ComponentTruth::ComponentTruth(
  vtkDataSet* data, vtkVolumeProperty* property, LatticeValues values, OpacityLaw law)
  : Property(property)
  , Law(law)
{
  const int count = data->GetPointData()->GetScalars()->GetNumberOfComponents();
  for (int k = 0; k < count; ++k)
  {
    OpticalModel model;
    model.Colour = property->GetRGBTransferFunction(functionsOf(property, k));
    model.Opacity = property->GetScalarOpacity(functionsOf(property, k));
    this->Truths.emplace_back(data, model, values, k);
    this->Breaks.push_back(nodesOf(property, k));
  }
}

std::array<double, 4> ComponentTruth::mediumAt(const Scalars& scalars, double u) const
{
  std::vector<double> tuple;
  for (const Cubic& scalar : scalars)
  {
    tuple.push_back(scalar.at(u));
  }
  const bool linear = this->Law == OpacityLaw::Linear;
  return testing::mediumAt(this->Property, tuple,
    [linear](double opacity)
    { return linear ? opacity : -std::log1p(-std::min(opacity, 1.0 - 1e-6)); });
}

// The optical depth up to each place is a quadrature, too.
SegmentResult ComponentTruth::quadratureOf(const Scalars& scalars, const Part& part) const
{
  const double unit = this->Property->GetScalarOpacityUnitDistance();
  const double width = part.To - part.From;
  const double thickness = part.Length * width / unit;
  SegmentResult result;
  for (int i = 0; i < Nodes; ++i)
  {
    const std::array<double, 4> medium =
      this->mediumAt(scalars, part.From + width * Places[i]); // C tau, tau
    double before = 0.0;
    for (int j = 0; j < Nodes; ++j)
    {
      before += Weights[j] * Places[i] *
                this->mediumAt(scalars, part.From + width * Places[i] * Places[j])[3];
    }
    for (int c = 0; c < 3; ++c)
    {
      result.Colour[c] += Weights[i] * thickness * medium[c] * std::exp(-before * thickness);
    }
    result.Depth += Weights[i] * thickness * medium[3];
  }
  return result;
}

SegmentResult ComponentTruth::halved(const Scalars& scalars, const Part& part, int times) const
{
  const double middle = 0.5 * (part.From + part.To);
  const Part near{ part.From, middle, part.Length };
  const Part far{ middle, part.To, part.Length };
  const SegmentResult whole = this->quadratureOf(scalars, part);
  const SegmentResult both =
    composed(this->quadratureOf(scalars, near), this->quadratureOf(scalars, far));
  double apart = std::abs(std::exp(-whole.Depth) - std::exp(-both.Depth));
  for (int c = 0; c < 3; ++c)
  {
    apart = std::max(apart, std::abs(whole.Colour[c] - both.Colour[c]));
  }
  return apart < Agreement || times == 0 ? both
                                         : composed(this->halved(scalars, near, times - 1),
                                             this->halved(scalars, far, times - 1));
}

SegmentResult ComponentTruth::integrate(const Scalars& scalars, double length) const
{
  std::vector<double> cuts{ 0.0, 1.0 };
  for (std::size_t k = 0; k < scalars.size(); ++k)
  {
    for (const double node : this->Breaks[k])
    {
      const std::vector<double> met = scalars[k].crossingsOf(node);
      cuts.insert(cuts.end(), met.begin(), met.end());
    }
  }
  std::sort(cuts.begin(), cuts.end());
  SegmentResult all;
  for (std::size_t i = 1; i < cuts.size(); ++i)
  {
    if (cuts[i] > cuts[i - 1])
    {
      all = composed(all, this->halved(scalars, { cuts[i - 1], cuts[i], length }, MostHalvings));
    }
  }
  return all;
}

std::array<double, 4> ComponentTruth::integrate(
  const Vec3& origin, const Vec3& direction, double tMin, double tMax) const
{
  std::vector<std::vector<ScalarSegment>> segments;
  for (const LatticeTruth& truth : this->Truths)
  {
    segments.push_back(truth.segments(origin, direction, tMin, tMax));
    if (segments.back().size() != segments.front().size())
    {
      throw std::invalid_argument("ComponentTruth needs components that are finite together");
    }
  }
  SegmentResult all;
  for (std::size_t i = 0; i < segments.front().size(); ++i)
  {
    Scalars scalars;
    for (const auto& ofComponent : segments)
    {
      scalars.push_back(ofComponent[i].Scalar);
    }
    all = composed(all, this->integrate(scalars, segments[0][i].T1 - segments[0][i].T0));
  }
  return { all.Colour[0], all.Colour[1], all.Colour[2], -std::expm1(-all.Depth) };
}
} // namespace tetmarch::testing
