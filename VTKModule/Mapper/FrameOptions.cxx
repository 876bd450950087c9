// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mapper/FrameOptions.h"

#include "Budget/SampleDistance.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTetMarchSettings.h"

namespace tetmarch
{
namespace
{

using Settings = vtkTetMarchSettings;

Measure measureOf(int viewMode)
{
  return viewMode == Settings::VIEW_CELLS     ? Measure::Cells
         : viewMode == Settings::VIEW_LOOKUPS ? Measure::Lookups
                                              : Measure::ErrorBound;
}

Subject subjectOf(int viewMode)
{
  return viewMode == Settings::VIEW_ILLUMINATION ? Subject::Illumination
         : viewMode == Settings::VIEW_GRADIENTS  ? Subject::Gradients
                                                 : Subject::Picture;
}

BoundaryView boundaryViewOf(int viewMode)
{
  return viewMode == Settings::VIEW_BOUNDARY_FACES         ? BoundaryView::Faces
         : viewMode == Settings::VIEW_BOUNDARY_COORDINATES ? BoundaryView::Coordinates
                                                           : BoundaryView::None;
}

EffectOptions effectOptionsOf(Settings* settings, BlendMode blend)
{
  return { settings->GetGradientType() == Settings::CELL_GRADIENTS,
    static_cast<ShadowMethod>(settings->GetShadowMethod()),
    settings->GetVolumetricScatteringBlending(), settings->GetGlobalIlluminationReach(),
    settings->GetAmbientOcclusion(), settings->GetAmbientOcclusionRadius(),
    settings->GetAmbientOcclusionDirections(), settings->GetOpaqueShadows(),
    subjectOf(settings->GetViewMode()), blend, static_cast<LightPreset>(settings->GetLightPreset()),
    settings->GetLightTolerance(), settings->GetLightThroughCuts() };
}

} // namespace

bool isMeasure(int viewMode)
{
  return viewMode == Settings::VIEW_ERROR_BOUND || viewMode == Settings::VIEW_CELLS ||
         viewMode == Settings::VIEW_LOOKUPS;
}

AccuracyOptions accuracyOptionsOf(Settings* settings)
{
  return { static_cast<Accuracy>(settings->GetAccuracyLevel()), settings->GetErrorTolerance(),
    settings->GetFrameTimeBudget(), settings->GetErrorBudget(), settings->GetPixelTolerance() };
}

bool isInteractive(vtkRenderWindow* window) { return window->GetDesiredUpdateRate() >= 1.0; }

FrameOptions::FrameOptions(Settings* settings, BlendMode blend, vtkRenderer* renderer,
  const Rung& accuracy, const PeelHooks& hooks, const FrameConditions& conditions,
  vtkLookupTable* viewColors)
  : Law(static_cast<OpacityLaw>(settings->GetOpacityLaw()))
  , DrawNanCells(settings->GetDrawNanCells())
  , Effects(effectOptionsOf(settings, blend))
  , View{ measureOf(settings->GetViewMode()), settings->GetAutomaticViewRange(),
    { { settings->GetViewRange()[0], settings->GetViewRange()[1] } }, viewColors }
{
  // Between translucent geometry the picture is drawn in parts, too.
  const bool peeling = hooks.isPeeling();
  const bool onlyParts = peeling || conditions.OnlyParts;
  const int viewMode = settings->GetViewMode();
  this->Draw.Level = accuracy.level();
  this->Draw.Diagnostics = settings->GetCollectDiagnostics() && !onlyParts;
  this->Draw.Stage = static_cast<ShaderStage>(settings->GetShaderStage());
  this->Draw.MostSecondsPerDraw = settings->GetMaxDrawTimeInSeconds();
  this->Draw.MostLightSeconds =
    conditions.Interacting && !peeling ? settings->GetLightTimeBudget() : 0.0;
  this->Draw.View = isMeasure(viewMode) && !onlyParts ? &this->View : nullptr;
  this->Draw.Boundary = onlyParts ? BoundaryView::None : boundaryViewOf(viewMode);
  this->Draw.Peeling = peeling ? &hooks : nullptr;
  if (this->Effects.Shown == Subject::Picture)
  {
    this->Draw.ColorWindow = conditions.ColorWindow;
  }
  this->Draw.PickOpacity = settings->GetPickOpacityThreshold();

  this->MarchesPicture = !renderer->GetSelector() && !peeling && !this->Draw.View &&
                         this->Draw.Boundary == BoundaryView::None;
  const bool isErrorView =
    this->Draw.View && this->View.What == Measure::ErrorBound && !renderer->GetSelector();
  this->Draw.PixelTolerance = this->MarchesPicture || isErrorView ? accuracy.PixelTolerance : 0.0;
}

void FrameOptions::chooseSampleDistance(
  Settings* settings, bool adjusts, SampleDistance& controller, double seconds)
{
  if (this->MarchesPicture && !this->Draw.Diagnostics)
  {
    this->Draw.SampleDistance =
      adjusts ? controller.choose(seconds, settings->GetMinimumImageSampleDistance(),
                  settings->GetMaximumImageSampleDistance())
              : settings->GetImageSampleDistance();
  }
}

} // namespace tetmarch
