// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a vtkTetMarchVolumeMapper keeps from frame to frame.
#ifndef vtkTetMarchVolumeMapperInternals_h
#define vtkTetMarchVolumeMapperInternals_h

#include "GL/Pipeline.h"
#include "Scene/AccuracyChoice.h"
#include "Scene/JoinedBlocks.h"
#include "Scene/SampleDistance.h"

#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkTetMarchFrameStatistics.h"
#include "vtkTetMarchVolumeMapper.h"

#include <string>

class vtkTetMarchVolumeMapper::Internals
{
public:
  tetmarch::Pipeline Pipeline;
  tetmarch::AccuracyChoice Choice;
  tetmarch::JoinedBlocks Blocks; // of composite input
  tetmarch::SampleDistance Distance;
  double UsedSampleDistance = 1;
  std::string LastError; // reported already
  std::string LastReport;
  std::string LastOmissions;
  vtkNew<vtkTetMarchFrameStatistics> Statistics;
  vtkNew<vtkLookupTable> ViewTable;
};

#endif
