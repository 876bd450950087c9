// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchVolumeMapperOptions.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>

namespace
{
using Mapper = vtkTetMarchVolumeMapper;

bool isMeasure(int viewMode)
{
  return viewMode == Mapper::VIEW_ERROR_BOUND || viewMode == Mapper::VIEW_CELLS ||
         viewMode == Mapper::VIEW_LOOKUPS;
}

tetmarch::Measure measureOf(int viewMode)
{
  return viewMode == Mapper::VIEW_CELLS     ? tetmarch::Measure::Cells
         : viewMode == Mapper::VIEW_LOOKUPS ? tetmarch::Measure::Lookups
                                            : tetmarch::Measure::ErrorBound;
}

tetmarch::Subject subjectOf(int viewMode)
{
  return viewMode == Mapper::VIEW_ILLUMINATION ? tetmarch::Subject::Illumination
         : viewMode == Mapper::VIEW_GRADIENTS  ? tetmarch::Subject::Gradients
                                               : tetmarch::Subject::Picture;
}

tetmarch::BoundaryView boundaryViewOf(int viewMode)
{
  return viewMode == Mapper::VIEW_BOUNDARY_FACES         ? tetmarch::BoundaryView::Faces
         : viewMode == Mapper::VIEW_BOUNDARY_COORDINATES ? tetmarch::BoundaryView::Coordinates
                                                         : tetmarch::BoundaryView::None;
}
} // namespace

//------------------------------------------------------------------------------
vtkTetMarchVolumeMapper::Internals::FrameOptions::FrameOptions(vtkTetMarchVolumeMapper* mapper,
  vtkRenderer* renderer, vtkVolume* volume, const tetmarch::AccuracyLevel& level,
  const tetmarch::PeelHooks& hooks)
  : Law(static_cast<tetmarch::OpacityLaw>(mapper->OpacityLaw))
  , Vector{ static_cast<tetmarch::VectorMode>(mapper->VectorMode), mapper->VectorComponent }
  , Blend{ mapper->BlendMode,
    { { mapper->AverageIPScalarRange[0], mapper->AverageIPScalarRange[1] } } }
  , View{ measureOf(mapper->ViewMode), mapper->AutomaticViewRange,
    { { mapper->ViewRange[0], mapper->ViewRange[1] } }, mapper->Internal->ViewTable }
{
  this->Effects = { mapper->GradientType == CELL_GRADIENTS,
    static_cast<tetmarch::ShadowMethod>(mapper->ShadowMethod), mapper->VolumetricScatteringBlending,
    mapper->GlobalIlluminationReach, mapper->AmbientOcclusion, mapper->AmbientOcclusionRadius,
    mapper->AmbientOcclusionDirections, mapper->OpaqueShadows, subjectOf(mapper->ViewMode),
    static_cast<tetmarch::BlendMode>(mapper->BlendMode) };

  this->Clipping.Planes = mapper->ClippingPlanes;
  this->Clipping.Cropping = mapper->Cropping;
  std::copy_n(mapper->CroppingRegionPlanes, 6, this->Clipping.CroppingPlanes.begin());
  this->Clipping.CroppingFlags = mapper->CroppingRegionFlags;

  // Between translucent geometry the same picture is drawn in parts, and nothing else.
  const bool peeling = hooks.isPeeling();
  const bool interacting = renderer->GetRenderWindow()->GetDesiredUpdateRate() >= 1.0;
  this->Draw.Level = level;
  this->Draw.Diagnostics = mapper->CollectDiagnostics && !peeling;
  this->Draw.MostSecondsPerDraw = mapper->MaxDrawTimeInSeconds;
  this->Draw.MostLightSeconds = interacting && !peeling ? mapper->LightTimeBudget : 0.0;
  this->Draw.View = isMeasure(mapper->ViewMode) && !peeling ? &this->View : nullptr;
  this->Draw.Shell = peeling ? tetmarch::BoundaryView::None : boundaryViewOf(mapper->ViewMode);
  this->Draw.Peeling = peeling ? &hooks : nullptr;
  this->Draw.PickOpacity = mapper->PickOpacityThreshold;

  this->MarchesPicture = !renderer->GetSelector() && !peeling && !this->Draw.View &&
                         this->Draw.Shell == tetmarch::BoundaryView::None;
  if (this->MarchesPicture && !mapper->CollectDiagnostics)
  {
    this->Draw.SampleDistance =
      mapper->AutoAdjustSampleDistances
        ? mapper->Internal->Distance.choose(volume->GetAllocatedRenderTime(),
            mapper->MinimumImageSampleDistance, mapper->MaximumImageSampleDistance)
        : mapper->ImageSampleDistance;
  }
}
