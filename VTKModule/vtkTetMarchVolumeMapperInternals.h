// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a vtkTetMarchVolumeMapper keeps from frame to frame.
#ifndef vtkTetMarchVolumeMapperInternals_h
#define vtkTetMarchVolumeMapperInternals_h

#include "Blocks/JoinedBlocks.h"
#include "Budget/AccuracyController.h"
#include "Budget/SampleDistance.h"
#include "GL/Pipeline.h"
#include "GL/TetSource.h"
#include "Mapper/LastMessage.h"
#include "Mapper/SettingsLink.h"

#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkTetMarchVolumeMapper.h"

#include <array>

class vtkHardwareSelector;

namespace tetmarch
{
struct FrameOptions;
}

class vtkTetMarchVolumeMapper::Internals
{
public:
  explicit Internals(vtkTetMarchVolumeMapper* mapper);

  /** Begin a frame, or a selection: that keeps the figures and the tables of the last frame. */
  void begin(bool selecting);
  /** End a frame, which took so many seconds, diagnostics included. */
  void end(const tetmarch::FrameOptions& options, bool drawn, double seconds);
  void recordStatistics();
  /** Draw for the renderer's selector, and keep the hit if the selector is that of Pick(). */
  bool select(vtkRenderer* renderer, vtkVolume* volume, const tetmarch::DrawOptions& options,
    const tetmarch::Progress& progress);

  tetmarch::SettingsLink Settings;
  tetmarch::TetSource Tets;
  tetmarch::Pipeline Pipeline{ Tets };
  tetmarch::AccuracyController Accuracy;
  tetmarch::AccuracyLevel Level = tetmarch::DefaultAccuracy; // of this frame
  tetmarch::SampleDistance Distance;
  tetmarch::JoinedBlocks Blocks; // of composite input
  tetmarch::LastMessage LastError;
  tetmarch::LastMessage LastMeshReport;
  tetmarch::LastMessage LastOmissions;
  vtkNew<vtkTetMarchFrameStatistics> Statistics;
  vtkNew<vtkLookupTable> ViewTable;

  // State of a Pick() in progress.
  vtkHardwareSelector* PickSelector = nullptr;
  vtkVolume* PickVolume = nullptr;
  bool PickFailed = false;              // in one of the passes of the selector
  std::array<double, 3> PickPosition{}; // in world coordinates
  double PickScalar = 0;
};

#endif
