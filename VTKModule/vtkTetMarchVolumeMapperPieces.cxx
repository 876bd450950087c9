// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The piece of a volume that this process draws, and the data shared by all processes.
#include "vtkTetMarchVolumeMapperInternals.h"

#include "Caching/WithinMemory.h"

#include "vtkMultiProcessController.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

//------------------------------------------------------------------------------
// The points of curvilinear pieces have the same order in all processes, by which one process cuts.
tetmarch::PieceOptions vtkTetMarchVolumeMapper::Internals::pieceAlone(vtkDataObject* input) const
{
  tetmarch::PieceOptions piece = this->Distributed.Piece;
  piece.ByCoordinates = this->Distributed.HasController && !vtkStructuredGrid::SafeDownCast(input);
  return piece;
}

//------------------------------------------------------------------------------
tetmarch::DrawnData vtkTetMarchVolumeMapper::Internals::drawnOf(
  vtkTetMarchVolumeMapper* mapper, vtkDataSet* grid, std::string& error)
{
  tetmarch::FoundScalars scalars;
  if (this->drawsLeaves())
  {
    scalars = { this->Leaves.scalars(), true };
  }
  else if (grid)
  {
    scalars = this->hasBlocks()
                ? tetmarch::FoundScalars{ this->Blocks.scalars(), this->Blocks.hasCellScalars() }
                : tetmarch::findScalars(grid, tetmarch::selectionOf(mapper));
  }
  vtkDataSet* data = grid ? grid : this->NoCells.Get();
  if (auto* stored = vtkUnstructuredGrid::SafeDownCast(grid))
  {
    const std::string shortage = tetmarch::withinMemory("the cells of this process",
      [&] { this->Own.update(stored, scalars.Array, scalars.OfCells, this->Blocks.origins()); });
    error = error.empty() ? shortage : error;
    data = this->Own.grid();
    scalars.Array = this->Own.scalars();
  }
  else
  {
    this->Own = {};
  }
  return { { data, this->pieceAlone(mapper->GetDataObjectInput()), tetmarch::Interpolation::Nearest,
             this->Leaves.places() },
    scalars, tetmarch::vectorOptionsOf(mapper), tetmarch::blendOptionsOf(mapper),
    tetmarch::clippingOptionsOf(mapper), {},
    this->isShared() ? this->Distributed.Whole : WholeRanges(),
    this->hasBlocks() && grid ? this->Blocks.departure() : tetmarch::CurvedDeparture{} };
}

//------------------------------------------------------------------------------
double* vtkTetMarchVolumeMapper::Internals::wholeBounds()
{
  if (!this->Distributed.WholeBox.IsValid())
  {
    return nullptr;
  }
  this->Distributed.WholeBox.GetBounds(this->WholeBounds.data());
  return this->WholeBounds.data();
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Internal->Distributed = {};
    this->Internal->Distributed.Processes = tetmarch::Group(controller);
    this->Internal->Distributed.HasController = controller != nullptr;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkTetMarchVolumeMapper::GetController() const
{
  return this->Controller;
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::SetWholeBounds(const double bounds[6])
{
  this->Internal->Distributed.WholeBox = vtkBoundingBox(bounds);
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::ShareBounds()
{
  const double* bounds = this->GetDataObjectInput() ? this->GetOwnBounds() : nullptr;
  const bool isBox = bounds && bounds[0] <= bounds[1];
  tetmarch::GroupState& distributed = this->Internal->Distributed;
  try
  {
    distributed.WholeBox =
      tetmarch::wholeBox(distributed.Processes, isBox ? vtkBoundingBox(bounds) : vtkBoundingBox());
  }
  catch (const tetmarch::GroupFailure& failure)
  {
    this->Report(failure.what());
  }
}
