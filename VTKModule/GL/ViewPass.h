// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws in colours what was measured of each pixel.
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
   * Draw opaque, in the colours, range and scale of the view's table. Pixels whose ray met nothing
   * stay as they are. `measures` has one texel for each pixel of the area. Returns an empty string,
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
