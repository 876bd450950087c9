// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a page shows of a renderer at one time.
#ifndef TetMarchWebPageCapture_h
#define TetMarchWebPageCapture_h

#include "Mapper/CaptureScope.h"
#include "WebPage/SceneSurfaces.h"

#include <list>
#include <string>
#include <vector>

class vtkRenderer;

namespace tetmarch
{

struct Capture
{
  std::list<CaptureScope::Captured> Volumes;
  std::vector<Surface> Surfaces;
  std::vector<std::string> Omissions; // what the page does not show, a sentence each
};

/** Render the window of the renderer, and take what its mappers would have drawn; the picture that
 * the window shows stays. */
Capture captureScene(vtkRenderer* renderer);

} // namespace tetmarch

#endif
