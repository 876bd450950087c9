// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/ContextWatch.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <utility>

namespace tetmarch
{

// A window tells its textures when its context ends. The class through which it does
// (vtkOpenGLResourceFreeCallback) is not installed before VTK 9.6, and buffers and vertex arrays
// don't use it. So a texture is used to be told.
class ContextWatch::Sentinel : public vtkTextureObject
{
public:
  static Sentinel* New();
  vtkTypeMacro(Sentinel, vtkTextureObject);

  std::function<void(vtkWindow*)> AtEnd;

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Superclass::ReleaseGraphicsResources(window); // may come back here
    const auto atEnd = std::exchange(this->AtEnd, nullptr);
    if (atEnd)
    {
      atEnd(window);
    }
  }
};

vtkStandardNewMacro(ContextWatch::Sentinel);

ContextWatch::~ContextWatch() { this->end(nullptr); }

void ContextWatch::begin(
  vtkOpenGLRenderWindow* window, const std::function<void(vtkWindow*)>& atEnd)
{
  this->end(window);
  this->Watching = vtkSmartPointer<Sentinel>::New();
  this->Watching->SetContext(window);
  this->Watching->Allocate2D(1, 1, 4, VTK_UNSIGNED_CHAR); // which makes it known to the window
  this->Watching->AtEnd = atEnd;
}

void ContextWatch::end(vtkWindow* window)
{
  if (this->Watching)
  {
    this->Watching->AtEnd = nullptr;
    this->Watching->ReleaseGraphicsResources(window);
  }
}

} // namespace tetmarch
