// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a vtkTetMarchVolumeMapper keeps from frame to frame.
#ifndef vtkTetMarchVolumeMapperInternals_h
#define vtkTetMarchVolumeMapperInternals_h

#include "Blocks/JoinedBlocks.h"
#include "GL/Pipeline.h"
#include "GL/TetSource.h"
#include "Mapper/MapperState.h"

#include "vtkTetMarchVolumeMapper.h"

class vtkTetMarchVolumeMapper::Internals
{
public:
  explicit Internals(vtkTetMarchVolumeMapper* mapper)
    : State(mapper, vtkTetMarchSettings::UNSTRUCTURED)
  {
  }

  void recordStatistics();
  bool hasBlocks() { return this->Blocks.grid() != nullptr; }

  tetmarch::MapperState State;
  tetmarch::TetSource Tets;
  tetmarch::Pipeline Pipeline{ Tets };
  tetmarch::JoinedBlocks Blocks; // of composite input
  tetmarch::LastMessage LastMeshReport;
  tetmarch::LastMessage LastOmissions;
};

#endif
