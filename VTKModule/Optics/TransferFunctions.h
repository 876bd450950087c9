// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Colour and extinction of a vtkVolumeProperty as functions of the scalar.
#ifndef TetMarchOpticsTransferFunctions_h
#define TetMarchOpticsTransferFunctions_h

#include <array>
#include <vector>

class vtkVolumeProperty;

namespace tetmarch
{

/**
 * The extinction (in 1 / scalar opacity unit distance) as a function of the opacity alpha:
 * Unstructured: alpha (vtkProjectedTetrahedraMapper and similar mappers); Structured: -ln(1 -
 * alpha) (vtkGPUVolumeRayCastMapper), with alpha at most 1 - 2^-24.
 */
enum class OpacityLaw
{
  Unstructured,
  Structured
};

double extinctionOf(double opacity, OpacityLaw law);

/**
 * Colour r, g, b in 0..1 and extinction at equal steps from scalar Begin to scalar End; Before and
 * After are the values below and above.
 */
struct SampledFunctions
{
  double Begin = 0;
  double End = 1;
  std::array<double, 4> Before{};
  std::array<double, 4> After{};
  std::vector<std::array<double, 4>> Samples;
  /**
   * The maximum difference between the functions and the lines between their samples: in
   * extinction, relative to the maximum extinction, or in a colour with extinction. 0 if it was not
   * measured.
   */
  double Deviation = 0;
};

/**
 * Sample the functions of component 0, evaluated by VTK itself (every colour space, midpoint,
 * sharpness, clamping, scale). Only the part of low..high in which one of them has nodes is
 * sampled, since a function is constant beyond its nodes. The colour function is a
 * vtkColorTransferFunction, or for one colour channel a gray vtkPiecewiseFunction.
 */
SampledFunctions sampleFunctions(
  vtkVolumeProperty* property, OpacityLaw law, double low, double high, int count);

/** Colour r, g, b and extinction of scalars that are not finite, by the colour function's NaN
 * colour and opacity. Extinction 0 for a gray function, which has no NaN colour. */
std::array<float, 4> nanColorOf(vtkVolumeProperty* property, OpacityLaw law);

/** `factor` times as many samples. The extinction is evaluated again; the colour, which is
 * expensive to evaluate, is interpolated. */
SampledFunctions refined(
  vtkVolumeProperty* property, OpacityLaw law, const SampledFunctions& coarse, int factor);

/** Every perBin-th of the samples, with the areas between them kept, so that no narrow feature is
 * missed (keepBinAreas()). The number of samples is a multiple of perBin plus 1. */
SampledFunctions keepAreas(const SampledFunctions& fine, int perBin);

} // namespace tetmarch

#endif
