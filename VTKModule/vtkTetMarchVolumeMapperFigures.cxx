// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a vtkTetMarchVolumeMapper tells of itself and of its last frame.
#include "vtkTetMarchVolumeMapperInternals.h"

#include "vtkFloatArray.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>

namespace
{
const char* nameOf(int accuracyLevel)
{
  constexpr const char* names[] = { "Fast", "Default", "Accurate", "Reference" };
  return names[accuracyLevel];
}
} // namespace

//------------------------------------------------------------------------------
const char* vtkTetMarchVolumeMapper::GetAccuracyLevelAsString() const
{
  return nameOf(this->AccuracyLevel);
}
const char* vtkTetMarchVolumeMapper::GetUsedAccuracyLevelAsString() const
{
  return nameOf(this->GetUsedAccuracyLevel());
}

//------------------------------------------------------------------------------
const char* vtkTetMarchVolumeMapper::GetBlendModeAsString() const
{
  constexpr const char* names[] = { "Composite", "MaximumIntensity", "MinimumIntensity",
    "AverageIntensity", "Additive", "IsoSurface" };
  return this->BlendMode >= COMPOSITE_BLEND && this->BlendMode <= ISOSURFACE_BLEND
           ? names[this->BlendMode]
           : "Unknown";
}

//------------------------------------------------------------------------------
int vtkTetMarchVolumeMapper::GetUsedAccuracyLevel() const
{
  return static_cast<int>(this->Internal->Choice.used().Level);
}
double vtkTetMarchVolumeMapper::GetUsedImageSampleDistance() const
{
  return this->Internal->UsedSampleDistance;
}

//------------------------------------------------------------------------------
double vtkTetMarchVolumeMapper::GetUsedErrorTolerance() const
{
  return this->Internal->Choice.used().Tolerance;
}
bool vtkTetMarchVolumeMapper::IsLightComplete() const
{
  return this->Internal->Pipeline.isLightComplete();
}
bool vtkTetMarchVolumeMapper::IsBudgetKept() const { return this->Internal->Choice.isKept(); }

//------------------------------------------------------------------------------
const char* vtkTetMarchVolumeMapper::GetViewModeAsString() const
{
  constexpr const char* names[] = { "Picture", "ErrorBound", "Cells", "Lookups", "Illumination",
    "Gradients", "BoundaryFaces", "BoundaryCoordinates" };
  return names[this->ViewMode];
}

//------------------------------------------------------------------------------
const char* vtkTetMarchVolumeMapper::GetVectorModeAsString() const
{
  constexpr const char* names[] = { "Disabled", "Magnitude", "Component", "AllComponents" };
  return names[this->VectorMode - DISABLED];
}

//------------------------------------------------------------------------------
const char* vtkTetMarchVolumeMapper::GetGradientTypeAsString() const
{
  return this->GradientType == CELL_GRADIENTS ? "Cell" : "Vertex";
}
const char* vtkTetMarchVolumeMapper::GetShadowMethodAsString() const
{
  constexpr const char* names[] = { "Off", "Automatic", "AtVertices", "AlongRays" };
  return names[this->ShadowMethod];
}

//------------------------------------------------------------------------------
vtkLookupTable* vtkTetMarchVolumeMapper::GetViewLookupTable() { return this->Internal->ViewTable; }

//------------------------------------------------------------------------------
vtkIdType vtkTetMarchVolumeMapper::GetNumberOfTetrahedra() const
{
  return this->Internal->Tets.mesh().numberOfTets();
}

//------------------------------------------------------------------------------
vtkIdType vtkTetMarchVolumeMapper::GetNumberOfBoundaryFaces() const
{
  return static_cast<vtkIdType>(this->Internal->Tets.mesh().BoundaryFaces.size());
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkTetMarchVolumeMapper::GetGPUMemoryBytes() const
{
  return static_cast<vtkTypeInt64>(this->Internal->Pipeline.gpuBytes());
}

//------------------------------------------------------------------------------
double vtkTetMarchVolumeMapper::GetBlocksSeconds() const
{
  return this->Internal->Blocks.record().Seconds;
}
double vtkTetMarchVolumeMapper::GetMeshSeconds() const
{
  return this->Internal->Tets.meshRecord().Seconds;
}
double vtkTetMarchVolumeMapper::GetScalarsSeconds() const
{
  return this->Internal->Tets.scalarsRecord().Seconds;
}
double vtkTetMarchVolumeMapper::GetTablesSeconds() const
{
  return this->Internal->Pipeline.tablesRecord().Seconds;
}
double vtkTetMarchVolumeMapper::GetGradientsSeconds() const
{
  return this->Internal->Pipeline.effects().gradientsRecord().Seconds;
}
double vtkTetMarchVolumeMapper::GetOpaqueShadowsSeconds() const
{
  return this->Internal->Pipeline.effects().opaqueShadowsRecord().Seconds;
}
double vtkTetMarchVolumeMapper::GetVertexLightSeconds() const
{
  return this->Internal->Pipeline.vertexLightRecord().Seconds;
}
double vtkTetMarchVolumeMapper::GetUploadSeconds() const
{
  return this->Internal->Pipeline.uploadRecord().Seconds;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkTetMarchVolumeMapper::GetBlocksBuilds() const
{
  return this->Internal->Blocks.record().Runs;
}
vtkTypeInt64 vtkTetMarchVolumeMapper::GetMeshBuilds() const
{
  return this->Internal->Tets.meshRecord().Runs;
}
vtkTypeInt64 vtkTetMarchVolumeMapper::GetScalarsBuilds() const
{
  return this->Internal->Tets.scalarsRecord().Runs;
}
vtkTypeInt64 vtkTetMarchVolumeMapper::GetTablesBuilds() const
{
  return this->Internal->Pipeline.tablesRecord().Runs;
}
vtkTypeInt64 vtkTetMarchVolumeMapper::GetGradientsBuilds() const
{
  return this->Internal->Pipeline.effects().gradientsRecord().Runs;
}
vtkTypeInt64 vtkTetMarchVolumeMapper::GetOpaqueShadowsBuilds() const
{
  return this->Internal->Pipeline.effects().opaqueShadowsRecord().Runs;
}
vtkTypeInt64 vtkTetMarchVolumeMapper::GetVertexLightBuilds() const
{
  return this->Internal->Pipeline.vertexLightRecord().Runs;
}
vtkTypeInt64 vtkTetMarchVolumeMapper::GetUploadedBytes() const
{
  return this->Internal->Pipeline.uploadedBytes();
}

//------------------------------------------------------------------------------
int vtkTetMarchVolumeMapper::GetNumberOfDraws() const
{
  return this->Internal->Pipeline.numberOfDraws();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkTetMarchVolumeMapper::GetNumberOfRays() const
{
  return this->Internal->Pipeline.counted().counters().Rays;
}
vtkTypeInt64 vtkTetMarchVolumeMapper::GetNumberOfCrossedCells() const
{
  return this->Internal->Pipeline.counted().counters().Cells;
}
vtkTypeInt64 vtkTetMarchVolumeMapper::GetNumberOfLookups() const
{
  return this->Internal->Pipeline.counted().counters().Lookups;
}
vtkTypeInt64 vtkTetMarchVolumeMapper::GetNumberOfRefusedEntries() const
{
  return this->Internal->Pipeline.counted().counters().Refused;
}
vtkTypeInt64 vtkTetMarchVolumeMapper::GetNumberOfLostRays() const
{
  return this->Internal->Pipeline.counted().counters().Lost;
}
vtkTypeInt64 vtkTetMarchVolumeMapper::GetNumberOfGuardHits() const
{
  return this->Internal->Pipeline.counted().counters().Guarded;
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::GetDiagnosticPixels(vtkFloatArray* pixels) const
{
  const std::vector<float>& values = this->Internal->Pipeline.counted().pixels();
  pixels->SetNumberOfComponents(4);
  pixels->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / 4));
  std::copy(values.begin(), values.end(), pixels->GetPointer(0));
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BlendMode: " << this->GetBlendModeAsString() << "\n";
  os << indent << "AverageIPScalarRange: " << this->AverageIPScalarRange[0] << ", "
     << this->AverageIPScalarRange[1] << "\n";
  os << indent << "OpacityLaw: " << (this->OpacityLaw == STRUCTURED ? "Structured" : "Unstructured")
     << "\n";
  os << indent << "VectorMode: " << this->GetVectorModeAsString() << "\n";
  os << indent << "VectorComponent: " << this->VectorComponent << "\n";
  os << indent << "DrawNanCells: " << (this->DrawNanCells ? "On" : "Off") << "\n";
  os << indent << "AccuracyLevel: " << this->GetAccuracyLevelAsString() << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "FrameTimeBudget: " << this->FrameTimeBudget << "\n";
  os << indent << "ErrorBudget: " << this->ErrorBudget << "\n";
  os << indent << "UsedAccuracyLevel: " << this->GetUsedAccuracyLevelAsString() << "\n";
  os << indent << "UsedErrorTolerance: " << this->GetUsedErrorTolerance() << "\n";
  os << indent << "BudgetKept: " << (this->IsBudgetKept() ? "Yes" : "No") << "\n";
  os << indent << "MaxDrawTimeInSeconds: " << this->MaxDrawTimeInSeconds << "\n";
  os << indent << "ViewMode: " << this->GetViewModeAsString() << "\n";
  os << indent << "AutomaticViewRange: " << (this->AutomaticViewRange ? "On" : "Off") << "\n";
  os << indent << "ViewRange: " << this->ViewRange[0] << ", " << this->ViewRange[1] << "\n";
  os << indent << "GradientType: " << this->GetGradientTypeAsString() << "\n";
  os << indent << "ShadowMethod: " << this->GetShadowMethodAsString() << "\n";
  os << indent << "VolumetricScatteringBlending: " << this->VolumetricScatteringBlending << "\n";
  os << indent << "GlobalIlluminationReach: " << this->GlobalIlluminationReach << "\n";
  os << indent << "OpaqueShadows: " << (this->OpaqueShadows ? "On" : "Off") << "\n";
  os << indent << "AmbientOcclusion: " << (this->AmbientOcclusion ? "On" : "Off") << "\n";
  os << indent << "AmbientOcclusionRadius: " << this->AmbientOcclusionRadius << "\n";
  os << indent << "AmbientOcclusionDirections: " << this->AmbientOcclusionDirections << "\n";
  os << indent << "AutoAdjustSampleDistances: " << (this->AutoAdjustSampleDistances ? "On" : "Off")
     << "\n";
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << "\n";
  os << indent << "MinimumImageSampleDistance: " << this->MinimumImageSampleDistance << "\n";
  os << indent << "MaximumImageSampleDistance: " << this->MaximumImageSampleDistance << "\n";
  os << indent << "UsedImageSampleDistance: " << this->GetUsedImageSampleDistance() << "\n";
  os << indent << "LightTimeBudget: " << this->LightTimeBudget << "\n";
  os << indent << "Cropping: " << (this->Cropping ? "On" : "Off") << "\n";
  os << indent << "CroppingRegionPlanes:";
  for (double plane : this->CroppingRegionPlanes)
  {
    os << ' ' << plane;
  }
  os << "\n" << indent << "CroppingRegionFlags: " << this->CroppingRegionFlags << "\n";
  os << indent << "PickOpacityThreshold: " << this->PickOpacityThreshold << "\n";
  os << indent << "PickedPosition: " << this->PickedPosition[0] << ", " << this->PickedPosition[1]
     << ", " << this->PickedPosition[2] << "\n";
  os << indent << "PickedScalar: " << this->PickedScalar << "\n";
  os << indent << "PickedCellId: " << this->PickedCellId << "\n";
  os << indent << "PickedBlock: " << this->PickedBlock << "\n";
  os << indent << "MaxMemoryInBytes: " << this->MaxMemoryInBytes << "\n";
  os << indent << "CollectDiagnostics: " << (this->CollectDiagnostics ? "On" : "Off") << "\n";
  os << indent << "BlocksBuilds: " << this->GetBlocksBuilds() << "\n";
  os << indent << "MeshBuilds: " << this->GetMeshBuilds() << "\n";
  os << indent << "ScalarsBuilds: " << this->GetScalarsBuilds() << "\n";
  os << indent << "NumberOfTetrahedra: " << this->GetNumberOfTetrahedra() << "\n";
  os << indent << "NumberOfBoundaryFaces: " << this->GetNumberOfBoundaryFaces() << "\n";
  os << indent << "GPUMemoryBytes: " << this->GetGPUMemoryBytes() << "\n";
}
