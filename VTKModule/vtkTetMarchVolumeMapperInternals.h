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

#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkTetMarchFrameStatistics.h"
#include "vtkTetMarchVolumeMapper.h"

#include <array>
#include <string>

class vtkHardwareSelector;

class vtkTetMarchVolumeMapper::Internals
{
public:
  struct FrameOptions;

  /** Draw what the renderer's selector reads, and keep it if it is for Pick(). */
  bool select(vtkRenderer* renderer, vtkVolume* volume, const tetmarch::DrawOptions& options,
    const tetmarch::Progress& progress);

  tetmarch::TetSource Tets;
  tetmarch::Pipeline Pipeline{ Tets };
  tetmarch::AccuracyController Choice;
  tetmarch::JoinedBlocks Blocks; // of composite input
  tetmarch::SampleDistance Distance;
  double UsedSampleDistance = 1;
  std::string LastError; // reported already
  std::string LastReport;
  std::string LastOmissions;
  vtkNew<vtkTetMarchFrameStatistics> Statistics;
  vtkNew<vtkLookupTable> ViewTable;

  // Of Pick(), while it goes on.
  vtkHardwareSelector* PickSelector = nullptr;
  vtkVolume* PickVolume = nullptr;
  bool PickFailed = false;              // in one of the selector's passes
  std::array<double, 3> PickPosition{}; // in the world
  double PickScalar = 0;
};

#endif
