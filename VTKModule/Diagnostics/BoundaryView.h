// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The faces by which rays enter the mesh, shown instead of the picture.
#ifndef TetMarchDiagnosticsBoundaryView_h
#define TetMarchDiagnosticsBoundaryView_h

namespace tetmarch
{

enum class BoundaryView
{
  None,
  Faces,      // each in a colour of its own
  Coordinates // barycentric, of the entry in its face
};

} // namespace tetmarch

#endif
