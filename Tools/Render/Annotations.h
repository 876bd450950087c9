// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What is drawn beside the volume: a scalar bar, the outline of the data, axes with coordinates.
 */
#ifndef tetmarch_Annotations_h
#define tetmarch_Annotations_h

#include "BoxAxes.h"
#include "CommandLine.h"
#include "Overlay.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <array>
#include <string>

class vtkColorTransferFunction;
class vtkRenderer;

namespace tetmarch
{

/// How far labels of axes reach away from the box, in pixels.
double GetWidthOfLabels(const CommandLine& commandLine);

/// The scalar bar's share of the picture's width, 0 without one.
double GetScalarBarShare(const CommandLine& commandLine);

class Annotations
{
public:
  /// Has the renderer draw what the command line asks for.
  Annotations(const CommandLine& commandLine, vtkRenderer* renderer);

  /// The box of the data, which outline and axes show.
  void SetBounds(const std::array<double, 6>& bounds);

  /// Before each frame: axes go where the camera sees the silhouette of the box.
  void FollowCamera();

  /// What a scalar bar tells.
  void AddScalarBar(
    vtkColorTransferFunction* colors, const std::array<double, 2>& range, const std::string& title);

private:
  void AddOutline();

  const CommandLine& Options;
  vtkRenderer* Renderer;
  vtkNew<vtkPolyData> Outline;
  std::array<double, 6> Bounds{};
  Overlay AxesOverlay;
  Overlay BarOverlay;
  BoxAxes Axes;
};

} // namespace tetmarch

#endif
