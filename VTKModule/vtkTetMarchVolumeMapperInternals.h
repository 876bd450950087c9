// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The state of a vtkTetMarchVolumeMapper between frames.
#ifndef vtkTetMarchVolumeMapperInternals_h
#define vtkTetMarchVolumeMapperInternals_h

#include "Blocks/JoinedBlocks.h"
#include "Blocks/OwnCells.h"
#include "GL/Pipeline.h"
#include "GL/TetTextures.h"
#include "Input/ExplicitLattice.h"
#include "Leaves/LeafGrid.h"
#include "Mapper/MapperFrame.h"
#include "Mapper/MapperState.h"
#include "Mapper/StructuredBlocks.h"
#include "Volume/TetVolume.h"

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
  bool isShared() const { return this->Distributed.Processes.size() > 1; }
  /** The drawn data of a grid, which may be nullptr. If memory is lacking and there is no error
   * yet, this is the error. */
  tetmarch::DrawnData drawnOf(
    vtkTetMarchVolumeMapper* mapper, vtkDataSet* grid, std::string& error);
  /** The options of the mesh of this input without other processes: those of the last common
   * frame. */
  tetmarch::PieceOptions pieceAlone(vtkDataObject* input) const;
  /** Of the cells of drawnOf(). */
  const tetmarch::CellOrigins& origins() const
  {
    return this->drawsLeaves() ? this->Leaves.origins() : this->Own.origins();
  }
  /** nullptr before they are known. */
  double* wholeBounds();
  bool hasBlocks() const { return this->Blocks.grid() || this->drawsLeaves(); }
  /** Rays march through leaves, else through tetrahedra. */
  bool drawsLeaves() const { return this->Leaves.places() != nullptr; }
  tetmarch::Pipeline& pipeline()
  {
    return this->drawsLeaves() ? this->OfLeaves.Pipeline : this->OfTets;
  }
  tetmarch::MarchedVolume& marched()
  {
    return this->drawsLeaves() ? static_cast<tetmarch::MarchedVolume&>(this->OfLeaves.Volume)
                               : this->Tets;
  }
  /** Free what is not drawn now. The window's context stays current. */
  void dropOthers(vtkOpenGLRenderWindow* window);

  tetmarch::MapperState State;
  tetmarch::TetVolume Tets;
  tetmarch::TetTextures Textures{ Tets };
  tetmarch::Pipeline OfTets{ Tets, Textures };
  tetmarch::LeafGrid Leaves; // of an adaptive mesh
  tetmarch::StructuredBlock OfLeaves;
  tetmarch::ExplicitLattice Explicit;
  tetmarch::JoinedBlocks Blocks; // of composite input
  tetmarch::OwnCells Own;        // without ghosts
  tetmarch::GroupState Distributed;
  std::array<double, 6> WholeBounds{};
  vtkNew<vtkUnstructuredGrid> NoCells;
  tetmarch::LastMessage LastMeshReport;
  tetmarch::LastMessage LastOmissions;
};

#endif
