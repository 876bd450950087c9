// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The state of a vtkTetMarchSmartVolumeMapper between frames.
#ifndef vtkTetMarchSmartVolumeMapperInternals_h
#define vtkTetMarchSmartVolumeMapperInternals_h

#include "Mapper/MapperState.h"
#include "Mapper/StructuredBlocks.h"

#include "vtkTetMarchSmartVolumeMapper.h"

class vtkTetMarchSmartVolumeMapper::Internals
{
public:
  explicit Internals(vtkTetMarchSmartVolumeMapper* mapper)
    : State(mapper, vtkTetMarchSettings::STRUCTURED)
  {
  }

  /** The only block of the last frame; null with an error if there was not exactly one.
   */
  tetmarch::StructuredBlock* onlyBlock(std::string& error) const;
  /** The maximum number of bytes of a block on the GPU, given the maximum for all; 0: no limit. */
  std::uint64_t bytesFor(const tetmarch::StructuredBlock& block, std::uint64_t mostBytes) const;
  void recordStatistics();

  tetmarch::MapperState State;
  tetmarch::StructuredBlocks Blocks;
  tetmarch::LastMessage LastOmissions;
  tetmarch::LastMessage LastReason; // for which VTK drew
};

#endif
