// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws what was measured of each pixel in colours.
#ifndef TetMarchGLViewPass_h
#define TetMarchGLViewPass_h

#include "Diagnostics/MeasureView.h"
#include "GL/ShaderDraw.h"
#include "GL/Viewport.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkTextureObject;

namespace tetmarch
{

class ViewPass
{
public:
  /**
   * Opaque, in the colours, range and scale that the table of the view has; pixels whose ray met
   * nothing stay as they are. `measures` has a texel a pixel of the area. Returns an empty string,
   * or what is wrong.
   */
  std::string draw(vtkOpenGLRenderWindow* window, const Viewport& area, vtkTextureObject* measures,
    const MeasureView& view);
  void release(vtkWindow* window);
  std::size_t bytes() const { return this->Uploaded.size(); }

private:
  std::string upload(vtkOpenGLRenderWindow* window, vtkLookupTable* table);

  ShaderDraw Draw;
  vtkSmartPointer<vtkTextureObject> Colors; // one row
  std::vector<unsigned char> Uploaded;
};

} // namespace tetmarch

#endif
