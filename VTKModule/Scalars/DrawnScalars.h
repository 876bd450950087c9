// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The drawn part of a data array: one component, a magnitude, or several components together.
#ifndef TetMarchScalarsDrawnScalars_h
#define TetMarchScalarsDrawnScalars_h

#include "Caching/Fingerprint.h"
#include "Scalars/StoredScalar.h"
#include "Scalars/TupleScalar.h"
#include "Variants/VariantKey.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkVolumeProperty;

namespace tetmarch
{

/** The size of the arrays in Shaders/tables/table_buffers.glsl. */
constexpr int MostComponents = 4;

/** With the numbers of vtkTetMarchVolumeMapper::VectorModeType. */
enum class VectorMode
{
  Disabled = -1, // determined by the colour function
  Magnitude = 0,
  Component = 1,
  AllComponents = 2
};

/** The user's settings. */
struct VectorOptions
{
  VectorMode Mode = VectorMode::Disabled;
  int Component = 0;
};

/** The drawn components and their combination. */
using ComponentMix = ComponentGroup;

struct DrawnScalars
{
  vtkDataArray* Array = nullptr;
  bool OfCells = false; // else of points
  ComponentMix Mix = ComponentMix::Single;
  /**
   * The first scalar. For dependent components it is the last one, which determines the opacity, so
   * that code that needs only the extinction can ignore the others.
   */
  TupleScalar First{};
  std::vector<int> Extra{}; // extra drawn components, at most three; colours first
  /** Above 0: extra values are divided by it and clamped to 0..1. 0: each extra component is
   * normalised to 0..1 by its own range. */
  double ExtraUnit = 0;
  /** The ranges of the first and of extra scalars, if other processes have parts of them; empty:
   * those of the array. */
  std::vector<FiniteRange> Whole{};
};

/** Returns an empty string if the array has one tuple for each point or cell of the data, or else
 * an error. */
std::string checkScalars(vtkDataSet* data, vtkDataArray* array, bool ofCells);

/**
 * Check the array and choose the drawn components, by the vector mode and by
 * vtkVolumeProperty::GetIndependentComponents() (see vtkTetMarchVolumeMapper::VectorModeType). The
 * array has at least one component. Returns an empty string, or an error with its remedy.
 *
 * The magnitude of a single component is that component itself, with its sign, as in
 * vtkSmartVolumeMapper: ParaView's default is the magnitude.
 */
std::string chooseScalars(vtkDataSet* data, vtkDataArray* array, bool ofCells,
  const VectorOptions& options, vtkVolumeProperty* property, DrawnScalars& drawn);

/** Equal if the same values are drawn. */
Fingerprint versionOf(const DrawnScalars& drawn);

} // namespace tetmarch

#endif
