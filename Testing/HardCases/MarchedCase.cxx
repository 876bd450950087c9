// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MarchedCase.h"

#include "Mesh/MeshScalars.h"
#include "Mesh/TetMeshBuilder.h"
#include "Optics/FittingTable.h"

#include "DisplacedMesh.h"
#include "GroundTruth.h"
#include "MarchedLength.h"
#include "MarchedMesh.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <stdexcept>

namespace tetmarch::testing
{
MarchedCase::MarchedCase(const HardCase& hard)
  : Case(hard)
{
  const Grid grid = hard.Make();
  std::string error;
  if (buildTetMesh(grid, {}, this->Mesh, error) != BuildStatus::Done)
  {
    throw std::runtime_error(hard.Name + ": " + error);
  }
  ensureHierarchy(this->Mesh);
  if (!this->Mesh.Tets.empty())
  {
    this->makeOptics(grid);
    this->makeAnswers();
  }
}

MarchedCase::~MarchedCase() = default;

void MarchedCase::makeOptics(vtkUnstructuredGrid* grid)
{
  const HardCase& hard = this->Case;
  vtkDataArray* array =
    hard.CellScalars ? grid->GetCellData()->GetScalars() : grid->GetPointData()->GetScalars();
  MeshScalars scalars = readScalars(grid, { array, hard.CellScalars }, this->Mesh);
  this->Range = scalars.Range;
  this->CellScalars = std::move(scalars.OfCells);
  vtkNew<vtkVolumeProperty> property;
  (hard.SetOptics ? hard.SetOptics : setStandardOptics)(property, grid);
  this->Table = fittingTable(property, tetmarch::OpacityLaw::Unstructured, this->Range.Low,
    this->Range.High, DefaultAccuracy);
  this->UnitDistance = property->GetScalarOpacityUnitDistance() / this->Mesh.Frame.Radius;
}

void MarchedCase::makeAnswers()
{
  const HardCase& hard = this->Case;
  if (hard.Known == Answer::Box)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->NormalizedBox.Low[k] =
        (hard.ExactBox.Low[k] - this->Mesh.Frame.Center[k]) / this->Mesh.Frame.Radius;
      this->NormalizedBox.High[k] =
        (hard.ExactBox.High[k] - this->Mesh.Frame.Center[k]) / this->Mesh.Frame.Radius;
    }
  }
  // A box without inner surfaces needs none of them.
  if (hard.Known != Answer::Box || this->Mesh.MayReenter)
  {
    const std::size_t tets = this->Mesh.Tets.size();
    const int together = tets < 50000 ? DisplacementsTogether : 0;
    const int copies = together + static_cast<int>(std::clamp<std::size_t>(20000 / tets, 16, 200));
    for (int i = 0; i < copies; ++i)
    {
      this->Displaced.push_back(
        i < together ? displacedTogether(this->Mesh, VertexDisplacement, i)
                     : displacedMesh(this->Mesh, VertexDisplacement, static_cast<unsigned>(i)));
    }
  }
  if (hard.Known == Answer::Union)
  {
    this->BruteForce = std::make_unique<GroundTruthScene>(asGrid(this->Mesh), constantModel());
  }
}
} // namespace tetmarch::testing
