// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Cameras by name, and the view that one has of a mesh
 */
#ifndef tetmarch_testing_NamedCamera_h
#define tetmarch_testing_NamedCamera_h

#include "View/View.h"

#include "Shot.h"

#include "vtkVolume.h"

#include <functional>
#include <gtest/gtest.h>

namespace tetmarch::testing
{
struct NamedCamera
{
  const char* Name;
  std::function<void(vtkCamera*, vtkTransform*)> Set; ///< places it, and the volume
};

inline View viewOf(const Shot& shot, const TetMesh& mesh)
{
  vtkNew<WindowlessRenderer> renderer;
  vtkNew<vtkVolume> volume;
  volume->SetUserTransform(shot.Transform);
  renderer->SetActiveCamera(shot.Camera);
  View view;
  EXPECT_TRUE(
    makeView(renderer, volume, mesh.Frame, 1.0, tetmarch::OpacityLaw::Unstructured, view));
  return view;
}
} // namespace tetmarch::testing

#endif
