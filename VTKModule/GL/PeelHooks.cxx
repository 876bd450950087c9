// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/PeelHooks.h"

#include "vtkDualDepthPeelingPass.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkVolume.h"

namespace tetmarch
{

PeelHooks::PeelHooks(vtkVolume* volume, vtkAbstractMapper* mapper)
  : Volume(volume)
  , Mapper(mapper)
{
  vtkInformation* keys = volume->GetPropertyKeys();
  if (!keys || !keys->Has(vtkOpenGLRenderPass::RenderPasses()))
  {
    return;
  }
  bool peeling = false;
  const int count = keys->Length(vtkOpenGLRenderPass::RenderPasses());
  for (int i = 0; i < count; ++i)
  {
    vtkObjectBase* pass = keys->Get(vtkOpenGLRenderPass::RenderPasses(), i);
    peeling = peeling || vtkDualDepthPeelingPass::SafeDownCast(pass);
    this->Passes.emplace_back(vtkOpenGLRenderPass::SafeDownCast(pass));
  }
  if (!peeling)
  {
    this->Passes.clear();
  }
}

void PeelHooks::edit(std::string& vertexShader, std::string& fragmentShader) const
{
  std::string geometryShader;
  for (vtkOpenGLRenderPass* pass : this->Passes)
  {
    pass->PreReplaceShaderValues(
      vertexShader, geometryShader, fragmentShader, this->Mapper, this->Volume);
  }
  for (vtkOpenGLRenderPass* pass : this->Passes)
  {
    pass->PostReplaceShaderValues(
      vertexShader, geometryShader, fragmentShader, this->Mapper, this->Volume);
  }
}

void PeelHooks::bind(vtkShaderProgram* program) const
{
  for (vtkOpenGLRenderPass* pass : this->Passes)
  {
    pass->SetShaderParameters(program, this->Mapper, this->Volume);
  }
}

} // namespace tetmarch
