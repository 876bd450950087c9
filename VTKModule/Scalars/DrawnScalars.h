// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What is drawn of a data array: one component, a magnitude, or several components together.
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

/** As the arrays in Shaders/tables/table_buffers.glsl. */
constexpr int MostComponents = 4;

/** With the numbers of vtkTetMarchVolumeMapper::VectorModeType. */
enum class VectorMode
{
  Disabled = -1, // the colour function decides
  Magnitude = 0,
  Component = 1,
  AllComponents = 2
};

/** What a user asks for. */
struct VectorOptions
{
  VectorMode Mode = VectorMode::Disabled;
  int Component = 0;
};

/** Which components are drawn, and how they are drawn together. */
using ComponentMix = ComponentGroup;

struct DrawnScalars
{
  vtkDataArray* Array = nullptr;
  bool OfCells = false; // else of points
  ComponentMix Mix = ComponentMix::Single;
  /**
   * The first scalar. Of dependent components it is the last one, which the opacity comes from, so
   * that whatever asks for extinction alone need not know of the others.
   */
  TupleScalar First{};
  std::vector<int>
    Further{}; // other components that are drawn with it, at most three; colours first
  /** Above 0: further values are divided by it and clamped to 0..1. 0: each further component is
   * brought to 0..1 by its own range. */
  double FurtherUnit = 0;
  /** The ranges of the first and of further scalars, if other processes have parts of them; empty:
   * those of the array. */
  std::vector<FiniteRange> Whole{};
};

/** Returns an empty string if the array has one tuple for each point or cell of the data, or else
 * what is wrong. */
std::string checkScalars(vtkDataSet* data, vtkDataArray* array, bool ofCells);

/**
 * Check the array and decide what is drawn of it, by the vector mode and by
 * vtkVolumeProperty::GetIndependentComponents() (see vtkTetMarchVolumeMapper::VectorModeType). The
 * array has at least one component. Returns an empty string, or what is wrong and what to do.
 *
 * The magnitude of a single component is that component itself, its sign included, as
 * vtkSmartVolumeMapper has it: ParaView asks for magnitudes unless told otherwise.
 */
std::string chooseScalars(vtkDataSet* data, vtkDataArray* array, bool ofCells,
  const VectorOptions& options, vtkVolumeProperty* property, DrawnScalars& drawn);

/** Equal if the same values are drawn. */
Fingerprint versionOf(const DrawnScalars& drawn);

} // namespace tetmarch

#endif
