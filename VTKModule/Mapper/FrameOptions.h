// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the settings of a mapper and the window ask of a frame.
#ifndef TetMarchMapperFrameOptions_h
#define TetMarchMapperFrameOptions_h

#include "Appearance/Blending.h"
#include "Budget/AccuracyLadder.h"
#include "Diagnostics/MeasureView.h"
#include "GL/PeelHooks.h"
#include "GL/Pipeline.h"
#include "Light/EffectOptions.h"

class vtkRenderWindow;
class vtkRenderer;
class vtkTetMarchSettings;

namespace tetmarch
{

class SampleDistance;

AccuracyOptions accuracyOptionsOf(vtkTetMarchSettings* settings);

/** Whether somebody waits for the next frame: the window is to draw at least one a second. At rest
 * interactors ask for 0.0001 a second, and ParaView asks for 0.002. */
bool isInteractive(vtkRenderWindow* window);

/** Whether a view mode shows a measure of each pixel. */
bool isMeasure(int viewMode);

/** What a mapper knows of a frame beside its settings. */
struct FrameConditions
{
  bool Interacting = false;      // somebody waits for the next frame
  bool AdjustsDistances = false; // rays may be fewer, to keep the allocated time if there is one
  bool OnlyParts = false; // several pipelines draw parts of the picture, and nothing else is drawn
  std::array<float, 2> ColorWindow{ { 1, 0 } }; // as in DrawOptions
};

struct FrameOptions
{
  /** `hooks` and `viewColors`, the colours of measures, are referred to. */
  FrameOptions(vtkTetMarchSettings* settings, BlendMode blend, vtkRenderer* renderer,
    const Rung& accuracy, const PeelHooks& hooks, const FrameConditions& conditions,
    vtkLookupTable* viewColors);
  FrameOptions(const FrameOptions&) = delete;
  void operator=(const FrameOptions&) = delete;

  /** Take fewer rays if `settings` say so, or, if that `adjusts`, as `controller` needs to keep the
   * seconds; 0: it may take as long as it does. */
  void chooseSampleDistance(
    vtkTetMarchSettings* settings, bool adjusts, SampleDistance& controller, double seconds);

  /**
   * Whether the frame is the picture, not a measure, the boundary, a part between translucent
   * surfaces or a pick. Budgets go by the times of such frames only.
   */
  bool MarchesPicture = false;
  OpacityLaw Law;
  bool DrawNanCells;
  EffectOptions Effects;
  DrawOptions Draw;

private:
  MeasureView View; // what Draw.View refers to
};

} // namespace tetmarch

#endif
