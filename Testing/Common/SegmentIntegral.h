// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The emission-absorption integral over one segment on which the scalar is linear
 *
 * VTK's transfer functions are evaluated themselves, in double, at every quadrature point; there is
 * no table. A segment is cut where the scalar meets a node of a function or the midpoint between
 * two; each part goes to Gauss-Legendre quadrature of 10 points, halved until one part and its
 * two halves agree to 1e-12 in colour and opacity. What is left to the halving are the kinks of
 * HSV, Lab and the like between nodes.
 */
#ifndef tetmarch_testing_SegmentIntegral_h
#define tetmarch_testing_SegmentIntegral_h

#include "GridBuilder.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

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

/// The integral of the extinction over a segment, and the colour that leaves its near end.
struct SegmentResult
{
  double Depth = 0.0;
  Vec3 Colour = { 0.0, 0.0, 0.0 };
};

class SegmentIntegral
{
public:
  explicit SegmentIntegral(const OpticalModel& model);

  /// The scalar goes from f0 at the near end to f1 at the far end. Not for several threads at once,
  /// since VTK's functions aren't.
  SegmentResult integrate(double f0, double f1, double length) const;

private:
  SegmentResult quadratureOf(double f0, double f1, double length) const;
  SegmentResult refined(
    double f0, double f1, double length, const SegmentResult& whole, int level) const;

  OpticalModel Model;
  std::vector<double> Breaks; // scalars where a function isn't smooth, sorted
};

/// Two segments as one.
SegmentResult composed(const SegmentResult& near, const SegmentResult& far);
} // namespace tetmarch::testing

#endif
