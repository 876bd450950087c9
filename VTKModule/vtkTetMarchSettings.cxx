// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchSettings.h"

#include "vtkObjectFactory.h"

namespace
{
const char* onOrOff(bool value) { return value ? "On" : "Off"; }
} // namespace

vtkStandardNewMacro(vtkTetMarchSettings);

//------------------------------------------------------------------------------
vtkTetMarchSettings::vtkTetMarchSettings() = default;

//------------------------------------------------------------------------------
vtkTetMarchSettings::~vtkTetMarchSettings() = default;

//------------------------------------------------------------------------------
const char* vtkTetMarchSettings::GetOpacityLawAsString() const
{
  return this->OpacityLaw == STRUCTURED ? "Structured" : "Unstructured";
}

//------------------------------------------------------------------------------
const char* vtkTetMarchSettings::GetAccuracyLevelAsString() const
{
  constexpr const char* names[] = { "Fast", "Default", "Accurate", "Reference", "Sampled" };
  return names[this->AccuracyLevel];
}

//------------------------------------------------------------------------------
const char* vtkTetMarchSettings::GetShaderStageAsString() const
{
  constexpr const char* names[] = { "Automatic", "Fragment", "Compute" };
  return names[this->ShaderStage];
}

//------------------------------------------------------------------------------
const char* vtkTetMarchSettings::GetViewModeAsString() const
{
  constexpr const char* names[] = { "Picture", "ErrorBound", "Cells", "Lookups", "Illumination",
    "Gradients", "BoundaryFaces", "BoundaryCoordinates" };
  return names[this->ViewMode];
}

//------------------------------------------------------------------------------
const char* vtkTetMarchSettings::GetGradientTypeAsString() const
{
  return this->GradientType == CELL_GRADIENTS ? "Cell" : "Vertex";
}

//------------------------------------------------------------------------------
const char* vtkTetMarchSettings::GetShadowMethodAsString() const
{
  constexpr const char* names[] = { "Off", "Automatic", "AtVertices", "AlongRays" };
  return names[this->ShadowMethod];
}

//------------------------------------------------------------------------------
void vtkTetMarchSettings::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OpacityLaw: " << this->GetOpacityLawAsString() << "\n";
  os << indent << "DrawNanCells: " << onOrOff(this->DrawNanCells) << "\n";
  os << indent << "AccuracyLevel: " << this->GetAccuracyLevelAsString() << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "FrameTimeBudget: " << this->FrameTimeBudget << "\n";
  os << indent << "ErrorBudget: " << this->ErrorBudget << "\n";
  os << indent << "AutoAdjustSampleDistances: " << onOrOff(this->AutoAdjustSampleDistances) << "\n";
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << "\n";
  os << indent << "MinimumImageSampleDistance: " << this->MinimumImageSampleDistance << "\n";
  os << indent << "MaximumImageSampleDistance: " << this->MaximumImageSampleDistance << "\n";
  os << indent << "MaxDrawTimeInSeconds: " << this->MaxDrawTimeInSeconds << "\n";
  os << indent << "ShaderStage: " << this->GetShaderStageAsString() << "\n";
  os << indent << "MaxMemoryInBytes: " << this->MaxMemoryInBytes << "\n";
  os << indent << "ViewMode: " << this->GetViewModeAsString() << "\n";
  os << indent << "AutomaticViewRange: " << onOrOff(this->AutomaticViewRange) << "\n";
  os << indent << "ViewRange: " << this->ViewRange[0] << ", " << this->ViewRange[1] << "\n";
  os << indent << "GradientType: " << this->GetGradientTypeAsString() << "\n";
  os << indent << "ShadowMethod: " << this->GetShadowMethodAsString() << "\n";
  os << indent << "OpaqueShadows: " << onOrOff(this->OpaqueShadows) << "\n";
  os << indent << "VolumetricScatteringBlending: " << this->VolumetricScatteringBlending << "\n";
  os << indent << "GlobalIlluminationReach: " << this->GlobalIlluminationReach << "\n";
  os << indent << "AmbientOcclusion: " << onOrOff(this->AmbientOcclusion) << "\n";
  os << indent << "AmbientOcclusionRadius: " << this->AmbientOcclusionRadius << "\n";
  os << indent << "AmbientOcclusionDirections: " << this->AmbientOcclusionDirections << "\n";
  os << indent << "LightTimeBudget: " << this->LightTimeBudget << "\n";
  os << indent << "PickOpacityThreshold: " << this->PickOpacityThreshold << "\n";
  os << indent << "CollectDiagnostics: " << onOrOff(this->CollectDiagnostics) << "\n";
}
