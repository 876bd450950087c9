// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The right answer for one ray through several components of an image or a rectilinear grid
 *
 * Brute force, as LatticeTruth: each component is a cubic in each box. What a point of the ray is
 * follows from VTK's functions by definition (ComponentFields.h), and is integrated by adaptive
 * Gauss-Legendre quadrature between the places where a scalar meets a node of its functions.
 */
#ifndef tetmarch_testing_ComponentTruth_h
#define tetmarch_testing_ComponentTruth_h

#include "LatticeTruth.h"

class vtkVolumeProperty;

namespace tetmarch::testing
{
class ComponentTruth
{
public:
  /// All components of the active scalars. The property is read for each ray; lengths are in units
  /// of its first scalar opacity unit distance.
  ComponentTruth(
    vtkDataSet* data, vtkVolumeProperty* property, LatticeValues values, OpacityLaw law);

  /// Premultiplied RGBA of what the ray sees between two lengths from its origin.
  std::array<double, 4> integrate(
    const Vec3& origin, const Vec3& direction, double tMin, double tMax) const;

  /// Where all of it is drawn, with the first component.
  const LatticeTruth& first() const { return this->Truths.front(); }

private:
  using Scalars = std::vector<Cubic>; // one a component
  struct Part
  {
    double From;
    double To; // of a segment, 0..1
    double Length;
  };

  std::array<double, 4> mediumAt(const Scalars& scalars, double u) const;
  SegmentResult quadratureOf(const Scalars& scalars, const Part& part) const;
  SegmentResult halved(const Scalars& scalars, const Part& part, int times) const;
  SegmentResult integrate(const Scalars& scalars, double length) const;

  vtkVolumeProperty* Property;
  OpacityLaw Law;
  std::vector<LatticeTruth> Truths;
  std::vector<std::vector<double>> Breaks; // of each component
};
} // namespace tetmarch::testing

#endif
