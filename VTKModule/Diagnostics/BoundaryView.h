// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Views of the faces through which rays enter the mesh.
#ifndef TetMarchDiagnosticsBoundaryView_h
#define TetMarchDiagnosticsBoundaryView_h

namespace tetmarch
{

enum class BoundaryView
{
  None,
  Faces,      // each in its own colour
  Coordinates // barycentric, of the entry in its face
};

} // namespace tetmarch

#endif
