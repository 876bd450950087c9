// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Adaptive meshes: trees, and images of several levels.
 */
#ifndef tetmarch_AdaptiveData_h
#define tetmarch_AdaptiveData_h

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

namespace tetmarch
{

bool IsAdaptive(vtkDataObject* data);

/**
 * The data, with adaptive meshes in it as a mapper takes them: a vtkHyperTreeGrid as an
 * unstructured grid of its leaves, AMR as it is, so that each value of cells is constant in its
 * leaf. With continuous set both are cells between the centres of leaves, see vtkTetMarchDualGrid;
 * throws Failure that says why that can't be.
 */
vtkSmartPointer<vtkDataObject> ConvertAdaptive(vtkDataObject* data, bool continuous);

} // namespace tetmarch

#endif
