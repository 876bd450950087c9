// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Colour and extinction as functions of the scalar, as a vtkVolumeProperty has them.
#ifndef TetMarchOpticsTransferFunctions_h
#define TetMarchOpticsTransferFunctions_h

#include <array>
#include <vector>

class vtkVolumeProperty;

namespace tetmarch
{

/**
 * How extinction (in 1 / scalar opacity unit distance) follows from the opacity alpha:
 * Unstructured: alpha (vtkProjectedTetrahedraMapper and its kin); Structured: -ln(1 - alpha)
 * (vtkGPUVolumeRayCastMapper), with alpha at most 1 - 2^-24.
 */
enum class OpacityLaw
{
  Unstructured,
  Structured
};

double extinctionOf(double opacity, OpacityLaw law);

/**
 * Colour r, g, b in 0..1 and extinction at equal steps from scalar Begin to scalar End; what holds
 * below and above is in Before and After.
 */
struct SampledFunctions
{
  double Begin = 0;
  double End = 1;
  std::array<double, 4> Before{};
  std::array<double, 4> After{};
  std::vector<std::array<double, 4>> Samples;
  /** How far lines between the samples are from what lies between them, at most: of extinction, as
   * a share of the greatest, or of a colour that meets some. 0 if it was not looked at. */
  double Deviation = 0;
};

/**
 * Sample the functions of component 0, evaluated by VTK itself (every colour space, midpoint,
 * sharpness, clamping, scale). Only the part of low..high in which one of them has nodes is
 * sampled: beyond its nodes a function is constant, and the samples are spent where something
 * happens. Structure of the colour function: vtkColorTransferFunction, or for one colour channel a
 * gray vtkPiecewiseFunction.
 */
SampledFunctions sampleFunctions(
  vtkVolumeProperty* property, OpacityLaw law, double low, double high, int count);

/** Colour r, g, b and extinction of scalars that are not finite: the colour function's, with its
 * opacity for them. A gray function has none: no extinction. */
std::array<float, 4> nanColorOf(vtkVolumeProperty* property, OpacityLaw law);

/** `factor` times as many samples, of the extinction looked at anew, of the colour, which is dear
 * to evaluate, from those at hand. */
SampledFunctions refined(
  vtkVolumeProperty* property, OpacityLaw law, const SampledFunctions& coarse, int factor);

/** Every perBin-th of the samples, which keep the areas between them: what is narrower than their
 * distance is not missed (keepBinAreas()). Their number is a multiple of perBin plus 1. */
SampledFunctions keepAreas(const SampledFunctions& fine, int perBin);

} // namespace tetmarch

#endif
