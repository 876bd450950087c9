// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The input of the stages of a frame.
#ifndef TetMarchFrameFrameInput_h
#define TetMarchFrameFrameInput_h

#include "Appearance/Blending.h"
#include "Curved/CurvedDeparture.h"
#include "Light/EffectOptions.h"
#include "Light/OpaqueSurfaces.h"
#include "Optics/AccuracyLevel.h"
#include "View/Clipping.h"
#include "View/RaySamples.h"
#include "Volume/MarchedVolume.h"

class vtkRenderer;
class vtkVolume;

namespace tetmarch
{

/** An array of the data. */
struct FoundScalars
{
  vtkDataArray* Array = nullptr;
  bool OfCells = false; // else of points
};

/** An array of the data, and what is shown of it. */
struct DrawnData
{
  VolumeInput Volume;
  FoundScalars Scalars;
  VectorOptions Vector{};
  BlendOptions Blend{};
  ClippingOptions Cuts{};
  RaySamples Samples{};             // at levels that sample the volume
  std::vector<FiniteRange> Whole{}; // as in DrawnScalars
  CurvedDeparture Departure{};      // of a grid that is drawn in place of curved cells
};

struct FrameInput
{
  DrawnData Drawn;
  vtkRenderer* Renderer = nullptr;
  vtkVolume* Volume = nullptr; // its property and its matrix
  OpacityLaw Law = OpacityLaw::Unstructured;
  AccuracyLevel Level = DefaultAccuracy;
  /** What touches a scalar that is not finite is drawn, in the colour that the colour function has
   * for it. */
  bool DrawNan = false;
  EffectOptions Effects{};
  BlockAttributes Blocks = nullptr; // as in EffectInput
};

} // namespace tetmarch

#endif
