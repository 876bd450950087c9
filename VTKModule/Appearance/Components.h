// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Several components of an array, drawn together.
#ifndef TetMarchAppearanceComponents_h
#define TetMarchAppearanceComponents_h

#include "Appearance/VectorOptions.h"
#include "Caching/Fingerprint.h"
#include "Mesh/FurtherScalars.h"
#include "Mesh/ResourceLimits.h"
#include "Optics/FittingTable.h"
#include "Variants/VariantKey.h"

#include <array>
#include <string>
#include <vector>

namespace tetmarch
{

using ComponentMix = ComponentGroup;

/** What is drawn of a tuple. */
struct DrawnComponents
{
  ComponentMix Mix = ComponentMix::Single;
  /** That which vertices have: of dependent components the last one, which the opacity comes from,
   * so that whatever asks for extinction alone need not know of the others; of independent ones the
   * first. */
  TupleScalar Scalar;
  FurtherController Further; // the others: colours first
};

/**
 * By vtkVolumeProperty::GetIndependentComponents() and the vector mode, see
 * vtkTetMarchVolumeMapper::VectorModeType. `error` is empty, or says what is wrong and what to do.
 */
DrawnComponents drawnComponents(const VectorOptions& choice, vtkVolumeProperty* property,
  vtkDataArray* array, std::string& error);

/** Where a table is among those that lie behind each other, as in
 * Shaders/tables/integral_table.glsl. */
struct TablePlace
{
  int First;
  int Size;
  std::array<double, 4> IntegralUnit;
  double Scale;
  double Offset;
};

struct Components
{
  ComponentMix Mix = ComponentMix::Single;
  FurtherScalars Further;
  /** Behind the table of the first scalar: one each of further independent ones; of ColorAndOpacity
   * that of the colours, whose extinction is 1; of DirectColor none. */
  std::vector<IntegralTable> Tables;
  /** What extinctions of independent components are multiplied by: their weights, and how much
   * shorter their unit distances are than that of the first. */
  std::array<double, MostComponents> Factors{ { 1, 1, 1, 1 } };

  bool isSingle() const { return this->Mix == ComponentMix::Single; }
  bool isIndependent() const { return this->Mix == ComponentMix::Independent; }
  int count() const { return static_cast<int>(this->Further.count()) + 1; }
  void setBits(VariantKey& key) const;
  /** Of the table of the first scalar, which has that range, and of those behind it. */
  std::vector<TablePlace> places(const IntegralTable& first, const ScalarRange& range) const;
  /** Whether something has extinction in a table behind the first. */
  bool isFurtherVisible() const;
};

/** Sets the scalars of the mesh or of its cells and those beside them, of an array of points or
 * cells. Returns the range of the former. */
ScalarRange readComponents(vtkUnstructuredGrid* grid, vtkDataArray* array, bool ofCells,
  const DrawnComponents& drawn, TetMesh& mesh, std::vector<float>& cellScalars,
  Components& components);

/** Identities and times of change of the functions that the tables are made of, but for those of
 * the first component. */
void addFunctions(
  Fingerprint& fingerprint, const Components& components, vtkVolumeProperty* property);

/** Sets Factors. Returns an empty string, or which unit distance is wrong. */
std::string setFactors(vtkVolumeProperty* property, Components& components);

/** What several components, with that table of the first, need on the GPU beside one scalar. */
void addBufferSizes(
  std::vector<BufferSize>& sizes, const Components& components, const IntegralTable& first);

/** Sets the Tables of several components, and returns that of the first scalar, which has that
 * range. */
IntegralTable componentTables(vtkVolumeProperty* property, OpacityLaw law, const ScalarRange& range,
  const AccuracyLevel& level, Components& components);

} // namespace tetmarch

#endif
