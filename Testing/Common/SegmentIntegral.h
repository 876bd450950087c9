// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The integrals over one segment on which the scalar is linear or a cubic
 *
 * VTK's transfer functions are evaluated themselves, in double, at every quadrature point; there is
 * no table. A segment is cut where the scalar meets a node of a function or the midpoint between
 * two; each part goes to Gauss-Legendre quadrature of 10 points, halved until one part and its
 * two halves agree to 1e-12 in colour and opacity. What is left to the halving are the kinks of
 * HSV, Lab and the like between nodes.
 */
#ifndef tetmarch_testing_SegmentIntegral_h
#define tetmarch_testing_SegmentIntegral_h

#include "Cubic.h"
#include "GridBuilder.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

#include <array>
#include <functional>
#include <vector>

namespace tetmarch::testing
{
enum class OpacityLaw
{
  Linear,     ///< extinction = opacity / unit distance, VTK's unstructured mappers
  Logarithmic ///< extinction = -ln(1 - opacity) / unit distance, VTK's structured mappers
};

/// What turns a scalar into colour and extinction. Gray is used if there is no Colour.
struct OpticalModel
{
  vtkSmartPointer<vtkColorTransferFunction> Colour;
  vtkSmartPointer<vtkPiecewiseFunction> Opacity;
  vtkSmartPointer<vtkPiecewiseFunction> Gray;
  double UnitDistance = 1.0;
  OpacityLaw Law = OpacityLaw::Linear;
  /// The logarithmic law takes greater opacities for this one: at 1 it would give infinity.
  double MostOpacity = 1.0 - 1e-6;

  Vec3 colour(double scalar) const;
  double extinction(double scalar) const;
};
/// Of nodes: scalar, red, green and blue; scalar and opacity.
OpticalModel opticalModelOf(const std::vector<std::array<double, 4>>& colours,
  const std::vector<std::array<double, 2>>& opacities);

/// The integral of the extinction over a segment, and the colour that leaves its near end.
struct SegmentResult
{
  double Depth = 0.0;
  Vec3 Colour = { 0.0, 0.0, 0.0 };
};

/// What sums and averages along a ray are made of: integrals over the part of it whose scalar is in
/// a range.
struct OpacitySums
{
  double Length = 0.0;
  double Opacity = 0.0;
  double OpacityTimesScalar = 0.0;
};

class SegmentIntegral
{
public:
  explicit SegmentIntegral(const OpticalModel& model);

  /// The scalar goes from f0 at the near end to f1 at the far end. Not for several threads at once,
  /// since VTK's functions aren't.
  SegmentResult integrate(double f0, double f1, double length) const;
  /// The same of a scalar that goes as a cubic from the near end (0) to the far one (1).
  SegmentResult integrate(const Cubic& scalar, double length) const;

  /// Multiplies the emission of each point by brightness(share), where the share, 0 to 1, is that
  /// of the segment behind the point. Parts that aren't smooth are halved until they agree to the
  /// tolerance.
  SegmentResult integrateLit(const Cubic& scalar, double length,
    const std::function<double(double)>& brightness, double tolerance) const;

  /// The opacity is that of the function, whatever the law and the unit distance.
  OpacitySums opacitySums(const Cubic& scalar, double length, double low, double high) const;

private:
  template <typename Brightness>
  SegmentResult quadratureOf(
    const Cubic& scalar, double u0, double u1, double length, const Brightness& brightness) const;
  OpacitySums sumsOf(const Cubic& scalar, double u0, double u1, double length) const;

  OpticalModel Model;
  std::vector<double> Breaks; // scalars where a function isn't smooth, sorted
};

/// Two segments as one.
SegmentResult composed(const SegmentResult& near, const SegmentResult& far);
OpacitySums composed(const OpacitySums& near, const OpacitySums& far);
} // namespace tetmarch::testing

#endif
