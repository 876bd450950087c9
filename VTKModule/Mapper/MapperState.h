// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a mapper keeps from frame to frame, whatever its rays march through.
#ifndef TetMarchMapperMapperState_h
#define TetMarchMapperMapperState_h

#include "Budget/AccuracyController.h"
#include "Budget/SampleDistance.h"
#include "Caching/WithinMemory.h"
#include "Mapper/LastMessage.h"
#include "Mapper/PickSession.h"
#include "Mapper/SettingsLink.h"
#include "Processes/Group.h"

#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkTetMarchFrameStatistics.h"

#include <string>

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
  Rung Chosen;                           // for this frame
  AccuracyLevel Level = DefaultAccuracy; // of it; of several processes, that of the first
  SampleDistance Distance;
  PickSession Picking;
  LastMessage LastError;
  LastMessage LastUndrawn; // why a frame that went well shows nothing, or something wrong
  vtkNew<vtkTetMarchFrameStatistics> Statistics;
  vtkNew<vtkLookupTable> ViewTable; // the colours of measures
};

/** Run a part of Render(), which throws nothing. Returns what it says is wrong, a lack of memory or
 * a process that can't be reached included. */
template <typename Part>
std::string guardedPart(
  Part&& part, const char* purpose = "the frame", const char* consequence = "so nothing is drawn")
{
  std::string error;
  try
  {
    const std::string shortage = withinMemory(
      purpose, [&] { error = part(); }, consequence);
    return shortage.empty() ? error : shortage;
  }
  catch (const GroupFailure& failure)
  {
    return failure.what();
  }
}

/** The same of what comes after the picture: what the frame took and counted. */
template <typename Part>
std::string guardedRecords(Part&& part)
{
  return guardedPart(
    [&]
    {
      part();
      return std::string();
    },
    "the statistics of the frame", "so they are missing; the picture is complete");
}

} // namespace tetmarch

#endif
