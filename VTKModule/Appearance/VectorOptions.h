// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What is drawn of an array with several components.
#ifndef TetMarchAppearanceVectorOptions_h
#define TetMarchAppearanceVectorOptions_h

#include "Mesh/TupleScalar.h"

#include <string>

class vtkDataArray;
class vtkVolumeProperty;

namespace tetmarch
{

/** With the numbers of vtkTetMarchVolumeMapper::VectorModeType. */
enum class VectorMode
{
  Disabled = -1, // the colour function decides
  Magnitude = 0,
  Component = 1,
  AllComponents = 2 // several of them, if there are: see Components.h
};

struct VectorOptions
{
  VectorMode Mode = VectorMode::Disabled;
  int Component = 0;
};

/**
 * Of the tuples of an array that has at least one component. A magnitude of a single one is that
 * component itself, its sign included, as vtkSmartVolumeMapper has it: ParaView asks for magnitudes
 * unless told otherwise. `error` is empty, or says which component the array doesn't have.
 */
TupleScalar tupleScalarOf(const VectorOptions& choice, vtkVolumeProperty* property,
  vtkDataArray* array, std::string& error);

} // namespace tetmarch

#endif
