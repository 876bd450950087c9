// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The leaves of a vtkHyperTreeGrid as an unstructured grid.
#ifndef TetMarchInputTreeLeafCells_h
#define TetMarchInputTreeLeafCells_h

#include "Caching/Fingerprint.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;
class vtkUnstructuredGrid;

namespace tetmarch
{

Fingerprint versionOfTree(vtkDataObject* tree);

/** A hexahedron for each leaf that is not masked, with its values. Returns an empty string, or an
 * error if the tree isn't sound. */
std::string makeLeafCells(vtkDataObject* tree, vtkSmartPointer<vtkUnstructuredGrid>& leaves);

} // namespace tetmarch

#endif
