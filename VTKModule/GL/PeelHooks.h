// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The shader code and uniforms of a vtkDualDepthPeelingPass that draws a volume.
#ifndef TetMarchGLPeelHooks_h
#define TetMarchGLPeelHooks_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkAbstractMapper;
class vtkOpenGLRenderPass;
class vtkShaderProgram;
class vtkVolume;

namespace tetmarch
{

/**
 * Translucent geometry is peeled off layer by layer. Between two layers the pass draws the
 * volumes, several times a frame and into targets of its own, and asks for the part between depths
 * that it knows.
 */
class PeelHooks
{
public:
  /** The hooks of the pass that draws the volume now; none if there is no such pass. */
  PeelHooks(vtkVolume* volume, vtkAbstractMapper* mapper);

  bool isPeeling() const { return !this->Passes.empty(); }
  /** Replace the tags of the shaders. */
  void edit(std::string& vertexShader, std::string& fragmentShader) const;
  /** Set the uniforms of the inserted code. */
  void bind(vtkShaderProgram* program) const;

private:
  std::vector<vtkSmartPointer<vtkOpenGLRenderPass>>
    Passes; // passes that change shaders, the peeling one included
  vtkVolume* Volume;
  vtkAbstractMapper* Mapper;
};

} // namespace tetmarch

#endif
