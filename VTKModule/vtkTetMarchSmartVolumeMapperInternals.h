// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a vtkTetMarchSmartVolumeMapper keeps from frame to frame.
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

  /** The only block of the last frame; null, and what is wrong, if it had another number of them.
   */
  tetmarch::StructuredBlock* onlyBlock(std::string& error) const;
  /** Bytes that a block may take on the GPU beside the others, of so many in all; 0: no limit. */
  std::uint64_t bytesFor(const tetmarch::StructuredBlock& block, std::uint64_t mostBytes) const;
  void recordStatistics();

  tetmarch::MapperState State;
  tetmarch::StructuredBlocks Blocks;
  tetmarch::LastMessage LastOmissions;
  tetmarch::LastMessage LastReason; // for which VTK drew
};

#endif
