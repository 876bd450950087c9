// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The state of a vtkTetMarchVolumeMapper between frames.
#ifndef vtkTetMarchVolumeMapperInternals_h
#define vtkTetMarchVolumeMapperInternals_h

#include "Blocks/JoinedBlocks.h"
#include "Blocks/OwnCells.h"
#include "GL/Pipeline.h"
#include "GL/TetSource.h"
#include "Mapper/MapperFrame.h"
#include "Mapper/MapperState.h"

#include "vtkTetMarchVolumeMapper.h"

class vtkTetMarchVolumeMapper::Internals
{
public:
  explicit Internals(vtkTetMarchVolumeMapper* mapper)
    : State(mapper, vtkTetMarchSettings::UNSTRUCTURED)
  {
  }

  using WholeRanges = std::vector<tetmarch::FiniteRange>;

  void recordStatistics();
  /** Whether other processes have pieces of the volume. */
  bool isShared() const { return this->Together.Processes.size() > 1; }
  /** The drawn data of a grid, which may be nullptr. */
  tetmarch::DrawnData drawnOf(vtkTetMarchVolumeMapper* mapper, vtkUnstructuredGrid* grid);
  /** The options of the mesh without other processes: those of the last common frame. */
  tetmarch::PieceOptions pieceAlone() const
  {
    tetmarch::PieceOptions piece = this->Together.Piece;
    piece.ByCoordinates = this->Together.HasController;
    return piece;
  }
  const tetmarch::CellOrigins& origins() const
  {
    return this->isShared() ? this->Own.origins() : this->Blocks.origins();
  }
  /** nullptr before they are known. */
  double* wholeBounds();
  bool hasBlocks() { return this->Blocks.grid() != nullptr; }

  tetmarch::MapperState State;
  tetmarch::TetSource Tets;
  tetmarch::Pipeline Pipeline{ Tets };
  tetmarch::JoinedBlocks Blocks; // of composite input
  tetmarch::OwnCells Own;        // of a piece of the volume
  tetmarch::GroupState Together;
  std::array<double, 6> WholeBounds{};
  vtkNew<vtkUnstructuredGrid> NoCells;
  tetmarch::LastMessage LastMeshReport;
  tetmarch::LastMessage LastOmissions;
};

#endif
