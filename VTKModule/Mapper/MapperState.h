// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a mapper keeps from frame to frame, whatever its rays march through.
#ifndef TetMarchMapperMapperState_h
#define TetMarchMapperMapperState_h

#include "Budget/AccuracyController.h"
#include "Budget/SampleDistance.h"
#include "Mapper/LastMessage.h"
#include "Mapper/PickSession.h"
#include "Mapper/SettingsLink.h"

#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkTetMarchFrameStatistics.h"

namespace tetmarch
{

struct MapperState
{
  /** The law of the mapper's own settings. */
  MapperState(vtkObject* mapper, int opacityLaw);

  /** Begin a frame, or a selection: that keeps the figures and the level of the last frame. */
  void begin(bool selecting);

  SettingsLink Settings;
  AccuracyController Accuracy;
  AccuracyLevel Level = DefaultAccuracy; // of this frame
  SampleDistance Distance;
  PickSession Picking;
  LastMessage LastError;
  LastMessage LastUndrawn; // why a frame that went well shows nothing
  vtkNew<vtkTetMarchFrameStatistics> Statistics;
  vtkNew<vtkLookupTable> ViewTable; // the colours of measures
};

} // namespace tetmarch

#endif
