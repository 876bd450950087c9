// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A frame of a vtkTetMarchSmartVolumeMapper: by marching, or by vtkSmartVolumeMapper.
#include "vtkTetMarchSmartVolumeMapperInternals.h"

#include "Mapper/MapperFrame.h"
#include "Picking/SelectedCells.h"

#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
// DISABLED means all components to a vtkSmartVolumeMapper, and so does COMPONENT of dependent ones:
// it chooses among independent components by their weights, which dependent ones don't have.
tetmarch::VectorOptions vectorOptionsOf(vtkSmartVolumeMapper* mapper, vtkVolumeProperty* property)
{
  tetmarch::VectorOptions options = tetmarch::vectorOptionsOf(mapper);
  const bool dependent = !property->GetIndependentComponents();
  if (options.Mode == tetmarch::VectorMode::Disabled ||
      (dependent && options.Mode == tetmarch::VectorMode::Component))
  {
    options.Mode = tetmarch::VectorMode::AllComponents;
  }
  return options;
}

bool hasGradientOpacity(vtkVolumeProperty* property, int components)
{
  bool has = false;
  for (int c = 0; c < std::min(components, VTK_MAX_VRCOMP); ++c)
  {
    has = has || (property->HasGradientOpacity(c) && !property->GetDisableGradientOpacity(c));
  }
  return has;
}

// Whether each component reflects light as the first one does.
bool reflectAlike(vtkVolumeProperty* property, int components)
{
  bool alike = true;
  for (int c = 1; c < std::min(components, VTK_MAX_VRCOMP); ++c)
  {
    alike = alike && property->GetShade(c) == property->GetShade(0) &&
            property->GetAmbient(c) == property->GetAmbient(0) &&
            property->GetDiffuse(c) == property->GetDiffuse(0) &&
            property->GetSpecular(c) == property->GetSpecular(0) &&
            property->GetSpecularPower(c) == property->GetSpecularPower(0);
  }
  return alike;
}

// As vtkOpenGLGPUVolumeRayCastMapper: the window of 1 about the level 0.5 changes nothing.
std::array<float, 2> colorWindowOf(float window, float level)
{
  constexpr float least = 1e-5f;
  const float width = std::copysign(std::max(std::abs(window), least), window);
  return { { 1 / width, 0.5f - level / width } };
}

tetmarch::Interpolation interpolationOf(vtkVolumeProperty* property)
{
  return property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION
           ? tetmarch::Interpolation::Nearest
           : tetmarch::Interpolation::Linear;
}
} // namespace

//------------------------------------------------------------------------------
void vtkTetMarchSmartVolumeMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkDataObject* input = this->GetDataObjectInput();
  tetmarch::StructuredBlocks& blocks = this->Internal->Blocks;
  const std::size_t before = blocks.all().size();
  std::string error;
  if (input)
  {
    error =
      tetmarch::guardedPart([&] { return blocks.update(input, tetmarch::selectionOf(this)); });
  }
  else
  {
    blocks.clear();
  }
  if (blocks.all().size() < before) // they may have been in another window
  {
    renderer->GetRenderWindow()->MakeCurrent();
  }
  if (!input)
  {
    return;
  }
  const std::string reason = error.empty() ? this->FindReasonForVTK(volume) : std::string();
  if (!reason.empty() && !blocks.isTree())
  {
    this->RenderByVTK(renderer, volume, reason);
    return;
  }
  if (!reason.empty())
  {
    error = "Blocks are marched only, but " + reason +
            ", which is left to vtkSmartVolumeMapper, and that draws no blocks.";
  }
  this->March(renderer, volume, error);
}

//------------------------------------------------------------------------------
std::string vtkTetMarchSmartVolumeMapper::FindReasonForVTK(vtkVolume* volume)
{
  switch (this->RequestedRenderMode)
  {
    case DefaultRenderMode:
    case GPURenderMode:
      break;
    case RayCastRenderMode:
      return "the requested render mode is ray cast";
    case OSPRayRenderMode:
      return "the requested render mode is OSPRay";
    default:
      return "the requested render mode is another than GPU"; // ANARI, from VTK 9.4 on
  }
  vtkVolumeProperty* property = volume->GetProperty();
  if (this->BlendMode == SLICE_BLEND)
  {
    return "the blend mode is slice";
  }
  if (property->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D)
  {
    return "the transfer functions are two-dimensional";
  }
  if (this->GPUMapper->GetMaskInput())
  {
    return "there is a mask";
  }
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  if (this->ComputeNormalFromOpacity && property->GetShade())
  {
    return "normals are computed from the opacity (ComputeNormalFromOpacity)";
  }
#endif
  return this->FindReasonOfComponents(property);
}

//------------------------------------------------------------------------------
// Several independent components have neither gradient opacity nor other blend modes here, and one
// reflection.
std::string vtkTetMarchSmartVolumeMapper::FindReasonOfComponents(vtkVolumeProperty* property)
{
  int components = 1;
  for (const auto& block : this->Internal->Blocks.all())
  {
    components = std::max(components, block->Scalars.Array->GetNumberOfComponents());
  }
  if (components == 1 || this->VectorMode != DISABLED || !property->GetIndependentComponents())
  {
    return {};
  }
  const bool hasVolumeLight =
    (property->GetShade() &&
      (this->GetShadowMethod() != SHADOWS_OFF || this->GetVolumetricScatteringBlending() > 0 ||
        this->GetAmbientOcclusion())) ||
    this->GetLightPreset() == LIGHT_STUDIO || this->GetLightPreset() == LIGHT_SUN;
  return hasGradientOpacity(property, components)
           ? "several independent components have gradient opacity"
         : hasVolumeLight
           ? "several independent components have shadows, scattering or ambient occlusion"
         : !reflectAlike(property, components)
           ? "several independent components reflect light differently"
         : this->BlendMode != COMPOSITE_BLEND
           ? "several independent components have another blend mode than composite"
           : std::string();
}

//------------------------------------------------------------------------------
void vtkTetMarchSmartVolumeMapper::RenderByVTK(
  vtkRenderer* renderer, vtkVolume* volume, const std::string& reason)
{
  this->Internal->LastReason.reportWarning(
    this, "The volume is drawn by vtkSmartVolumeMapper, since " + reason + ".");
  this->Internal->Blocks.clear();
  this->Internal->State.Statistics->Clear();
  renderer->GetRenderWindow()->MakeCurrent();
  if (this->GetMaxMemoryInBytes() > 0)
  {
    this->Superclass::SetMaxMemoryInBytes(this->GetMaxMemoryInBytes());
  }
  this->Superclass::SetAutoAdjustSampleDistances(this->GetAutoAdjustSampleDistances());
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0)
  this->GPUMapper->SetUseJittering(this->UseJittering);
#endif
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  this->Superclass::SetVolumetricScatteringBlending(this->GetVolumetricScatteringBlending());
  this->Superclass::SetGlobalIlluminationReach(this->GetGlobalIlluminationReach());
#endif
  this->Superclass::Render(renderer, volume);
}

//------------------------------------------------------------------------------
void vtkTetMarchSmartVolumeMapper::March(
  vtkRenderer* renderer, vtkVolume* volume, const std::string& error)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkHardwareSelector* selector = renderer->GetSelector();
  if (!window || (selector && !tetmarch::asksForCells(selector)))
  {
    return;
  }
  const vtkOpenGLState::ScopedglActiveTexture unit(window->GetState()); // uploads choose others
  this->InvokeEvent(vtkCommand::VolumeMapperRenderStartEvent);
  Internals& internal = *this->Internal;
  this->CurrentRenderMode = GPURenderMode;
  const std::string wrong = tetmarch::guardedPart(
    [&]
    {
      internal.State.begin(selector != nullptr);
      return error.empty() && !internal.Blocks.all().empty()
               ? this->DrawBlocks(window, renderer, volume)
               : error;
    });
  const std::string unrecorded = tetmarch::guardedRecords(
    [&]
    {
      internal.recordStatistics();
      internal.LastOmissions.reportWarning(this, internal.Blocks.omissions());
    });
  internal.State.LastError.reportError(this, wrong.empty() ? unrecorded : wrong);
  this->InvokeEvent(vtkCommand::VolumeMapperRenderEndEvent);
}

//------------------------------------------------------------------------------
// If a block can't be prepared, none is drawn.
std::string vtkTetMarchSmartVolumeMapper::DrawBlocks(
  vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkVolume* volume)
{
  Internals& internal = *this->Internal;
  const bool several = internal.Blocks.all().size() > 1;
  const tetmarch::BlendOptions blend = tetmarch::blendOptionsOf(this);
  if (several && blend.Mode != COMPOSITE_BLEND && blend.Mode != ISOSURFACE_BLEND)
  {
    return "Several blocks are drawn one over the other, which is for composite blending and "
           "isosurfaces only, but the blend mode is another. vtkTetMarchVolumeMapper joins blocks.";
  }
  const bool interacting = window->GetDesiredUpdateRate() >= this->InteractiveUpdateRate;
  const bool adjusts = this->InteractiveAdjustSampleDistances
                         ? interacting
                         : this->GetAutoAdjustSampleDistances() != 0;
  tetmarch::MapperFrame frame({ this, window, renderer, volume }, internal.State, blend,
    { interacting && tetmarch::isInteractive(window), adjusts, several,
      colorWindowOf(this->FinalColorWindow, this->FinalColorLevel) });
  if (several && frame.isPeeled())
  {
    return "Several blocks can't be drawn between the peels of translucent surfaces. Draw one "
           "block, "
           "or switch vtkRenderer::UseDepthPeelingForVolumes off.";
  }
  const auto mostBytes = static_cast<std::uint64_t>(
    double(this->GetMaxMemoryInBytes()) * double(this->MaxMemoryFraction));
  std::vector<tetmarch::StructuredBlock*> ready;
  std::string error;
  for (tetmarch::StructuredBlock* block : internal.Blocks.backToFront(renderer, volume))
  {
    const std::uint64_t bytes = internal.bytesFor(*block, mostBytes);
    renderer->GetSelector() ? block->Pipeline.beginPick(bytes) : block->Pipeline.begin(bytes);
    const tetmarch::DrawnData drawn{
      { block->Data, {}, interpolationOf(volume->GetProperty()), nullptr }, block->Scalars,
      vectorOptionsOf(this, volume->GetProperty()), blend, tetmarch::clippingOptionsOf(this),
      { this->FindSampleDistance(block->Data, adjusts ? frame.rayDistance() : 0.0),
        this->UseJittering != 0 }
    };
    const tetmarch::StageResult result = frame.prepare(block->Pipeline, drawn);
    if (result.isDone())
    {
      ready.push_back(block);
    }
    error = error.empty() ? result.Error : error;
  }
  for (std::size_t i = 0; error.empty() && i < ready.size(); ++i)
  {
    const tetmarch::StageResult result = frame.draw(ready[i]->Pipeline, ready[i]->Origins);
    error = result.Error;
    if (!result.isDone())
    {
      break;
    }
  }
  const std::string unrecorded = tetmarch::guardedRecords([&] { frame.end(this->TimeToDraw); });
  return error.empty() ? unrecorded : error;
}

//------------------------------------------------------------------------------
std::uint64_t vtkTetMarchSmartVolumeMapper::Internals::bytesFor(
  const tetmarch::StructuredBlock& block, std::uint64_t mostBytes) const
{
  std::uint64_t others = 0;
  for (const auto& other : this->Blocks.all())
  {
    others += other.get() == &block ? 0 : other->Pipeline.gpuBytes();
  }
  return mostBytes == 0 ? 0 : mostBytes > others ? mostBytes - others : 1;
}
