// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a vtkTetMarchVolumeMapper keeps from frame to frame.
#ifndef vtkTetMarchVolumeMapperInternals_h
#define vtkTetMarchVolumeMapperInternals_h

#include "Blocks/JoinedBlocks.h"
#include "Budget/AccuracyController.h"
#include "Budget/SampleDistance.h"
#include "GL/Pipeline.h"
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

  /** A frame, or a selection, which keeps what is known of the last frame and uses its tables. */
  void begin(bool selecting);
  /** A frame took so many seconds. */
  void end(const tetmarch::FrameOptions& options, bool drawn, double seconds);
  void recordStatistics();
  /** Draw what the renderer's selector reads, and keep it if it is for Pick(). */
  bool select(vtkRenderer* renderer, vtkVolume* volume, const tetmarch::DrawOptions& options,
    const tetmarch::Progress& progress);

  tetmarch::SettingsLink Settings;
  tetmarch::Pipeline Pipeline;
  tetmarch::AccuracyController Accuracy;
  tetmarch::AccuracyLevel Level = tetmarch::DefaultAccuracy; // of this frame
  tetmarch::SampleDistance Distance;
  tetmarch::JoinedBlocks Blocks; // of composite input
  tetmarch::LastMessage LastError;
  tetmarch::LastMessage LastMeshReport;
  tetmarch::LastMessage LastOmissions;
  vtkNew<vtkTetMarchFrameStatistics> Statistics;
  vtkNew<vtkLookupTable> ViewTable;

  // Of a Pick() that goes on.
  vtkHardwareSelector* PickSelector = nullptr;
  vtkVolume* PickVolume = nullptr;
  bool PickFailed = false;              // in one of the selector's passes
  std::array<double, 3> PickPosition{}; // in world coordinates
  double PickScalar = 0;
};

#endif
