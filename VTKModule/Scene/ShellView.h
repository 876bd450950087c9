// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The faces by which rays enter the mesh, shown instead of the picture.
#ifndef TetMarchSceneShellView_h
#define TetMarchSceneShellView_h

namespace tetmarch
{

enum class ShellView
{
  None,
  Faces,      // each in a colour of its own
  Coordinates // barycentric, of the entry in its face
};

} // namespace tetmarch

#endif
