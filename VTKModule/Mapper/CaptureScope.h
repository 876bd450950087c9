// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// While a capture is in scope, our mappers give what their frames would draw in a window, instead
// of drawing it.
#ifndef TetMarchMapperCaptureScope_h
#define TetMarchMapperCaptureScope_h

#include "GL/VolumeCapture.h"
#include "Optics/TransferFunctions.h"

#include <list>
#include <string>

class vtkRenderWindow;
class vtkVolume;

namespace tetmarch
{

class CaptureScope
{
public:
  struct Captured
  {
    vtkVolume* Volume = nullptr;
    std::string Name; // of the array
    OpacityLaw Law = OpacityLaw::Unstructured;
    CapturedVolume Data;
  };

  explicit CaptureScope(vtkRenderWindow* window);
  ~CaptureScope();
  CaptureScope(const CaptureScope&) = delete;
  CaptureScope& operator=(const CaptureScope&) = delete;

  /** The scope of the window, or nullptr. */
  static CaptureScope* of(vtkRenderWindow* window);

  /** In the order in which they would be drawn: one for each block of images. */
  std::list<Captured> Volumes;

private:
  vtkRenderWindow* Window;
  CaptureScope* Outer;
  static CaptureScope* Inner;
};

} // namespace tetmarch

#endif
