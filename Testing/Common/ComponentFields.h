// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Arrays of several components on a grid, transfer functions for them, and what a point of
 * the volume is by these
 */
#ifndef tetmarch_testing_ComponentFields_h
#define tetmarch_testing_ComponentFields_h

#include "GridBuilder.h"

#include <functional>

class vtkDataArray;
class vtkDataSet;
class vtkVolumeProperty;

namespace tetmarch::testing
{
/// 1 to 4 fields that are linear in space, of different directions, with values 0..1 in the unit
/// cube.
std::vector<Field> componentFields(int count);

/// The grid itself, with the active scalars of points and cells made of fields, one a component, in
/// arrays of that type of VTK, named "components". In arrays of integers they are times 255.
Grid withComponents(const Grid& grid, const std::vector<Field>& fields, int type);
/// The same of a data set of any kind.
void setComponents(vtkDataSet* data, const std::vector<Field>& fields, int type);

/// For 1 to 4 components: colour and opacity functions over 0..1, different for each and none
/// linear, unit distances and weights.
void setComponentFunctions(vtkVolumeProperty* property, int components);

/// Colour times extinction, and extinction, of a point with those scalars: by definition, with
/// VTK's functions; extinction is in unit distances of component 0. `extinctionOf` an opacity in a
/// unit distance is that opacity itself, unless another law is given.
std::array<double, 4> mediumAt(
  vtkVolumeProperty* property, const std::vector<double>& scalars,
  const std::function<double(double)>& extinctionOf = [](double opacity) { return opacity; });
} // namespace tetmarch::testing

#endif
