// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The piece of a volume that this process draws, and the data shared by all processes.
#include "vtkTetMarchVolumeMapperInternals.h"

#include "vtkMultiProcessController.h"
#include "vtkUnstructuredGrid.h"

//------------------------------------------------------------------------------
tetmarch::DrawnData vtkTetMarchVolumeMapper::Internals::drawnOf(
  vtkTetMarchVolumeMapper* mapper, vtkUnstructuredGrid* grid)
{
  tetmarch::FoundScalars scalars;
  if (grid)
  {
    scalars = this->hasBlocks()
                ? tetmarch::FoundScalars{ this->Blocks.scalars(), this->Blocks.hasCellScalars() }
                : tetmarch::findScalars(grid, tetmarch::selectionOf(mapper));
  }
  vtkDataSet* data = grid ? grid : this->NoCells.Get();
  if (grid && this->isShared())
  {
    this->Own.update(grid, scalars.Array, scalars.OfCells, this->Blocks.origins());
    data = this->Own.grid();
    scalars.Array = this->Own.scalars();
  }
  return { data, scalars, tetmarch::vectorOptionsOf(mapper), tetmarch::blendOptionsOf(mapper),
    tetmarch::clippingOptionsOf(mapper), this->isShared() ? this->Together.Whole : WholeRanges() };
}

//------------------------------------------------------------------------------
double* vtkTetMarchVolumeMapper::Internals::wholeBounds()
{
  if (!this->Together.WholeBox.IsValid())
  {
    return nullptr;
  }
  this->Together.WholeBox.GetBounds(this->WholeBounds.data());
  return this->WholeBounds.data();
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Internal->Together = {};
    this->Internal->Together.Processes = tetmarch::Group(controller);
    this->Internal->Together.HasController = controller != nullptr;
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
  this->Internal->Together.WholeBox = vtkBoundingBox(bounds);
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::ShareBounds()
{
  const double* bounds = this->GetDataObjectInput() ? this->GetOwnBounds() : nullptr;
  const bool isBox = bounds && bounds[0] <= bounds[1];
  tetmarch::GroupState& together = this->Internal->Together;
  try
  {
    together.WholeBox =
      tetmarch::wholeBox(together.Processes, isBox ? vtkBoundingBox(bounds) : vtkBoundingBox());
  }
  catch (const tetmarch::GroupFailure& failure)
  {
    this->Report(failure.what());
  }
}
