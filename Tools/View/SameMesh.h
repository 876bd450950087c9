// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_SameMesh_h
#define tetmarch_SameMesh_h

class vtkDataObject;

namespace tetmarch
{

/// Whether two unstructured grids have the same points and cells, as time steps often do. False if
/// one is null or another kind of data, and, unless it is the same object, if it has polyhedra.
bool HasSameMesh(vtkDataObject* a, vtkDataObject* b);

} // namespace tetmarch

#endif
