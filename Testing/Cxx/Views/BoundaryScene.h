// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A window for the view modes of the boundary
 */
#ifndef tetmarch_testing_BoundaryScene_h
#define tetmarch_testing_BoundaryScene_h

#include "Scene.h"

namespace tetmarch::testing
{
/// On a blue background, without diagnostics.
class BoundaryScene : public Scene
{
public:
  explicit BoundaryScene(vtkUnstructuredGrid* grid, int width = SceneSize, int height = SceneSize)
    : Scene(grid, width, height)
  {
    this->Mapper->CollectDiagnosticsOff();
    this->Renderer->SetBackground(0.2, 0.4, 0.6);
  }
  Image view(int mode)
  {
    this->Mapper->SetViewMode(mode);
    this->Window->Render();
    return this->frame();
  }
};

/// Convex.
inline Grid boundaryLattice() { return jitteredLattice(6, 0.15, 5, sineField()); }
} // namespace tetmarch::testing

#endif
