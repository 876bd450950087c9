// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which scalars of a scene's data are drawn, and how they are interpolated.
#include "ImageSceneTruth.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <numeric>

namespace tetmarch::testing
{
namespace
{
// The same data with the lengths of the vectors as its active scalars.
vtkSmartPointer<vtkDataSet> withMagnitudes(vtkDataSet* data, bool ofCells)
{
  const auto copy = vtkSmartPointer<vtkDataSet>::Take(data->NewInstance());
  copy->ShallowCopy(data);
  vtkDataSetAttributes* attributes = ofCells
                                       ? static_cast<vtkDataSetAttributes*>(copy->GetCellData())
                                       : static_cast<vtkDataSetAttributes*>(copy->GetPointData());
  vtkDataArray* vectors = attributes->GetScalars();
  vtkNew<vtkDoubleArray> lengths;
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
  {
    const double* v = vectors->GetTuple(i);
    lengths->InsertNextValue(
      std::sqrt(std::inner_product(v, v + vectors->GetNumberOfComponents(), v, 0.0)));
  }
  attributes->SetScalars(lengths);
  return copy;
}
} // namespace

void ImageSceneTruth::readScalars(vtkDataSet* data)
{
  int kind = 0;
  vtkDataArray* array = vtkAbstractMapper::GetScalars(data, this->Stage.Mapper->GetScalarMode(),
    this->Stage.Mapper->GetArrayAccessMode(), this->Stage.Mapper->GetArrayId(),
    this->Stage.Mapper->GetArrayName(), kind);
  const bool ofCells = kind == 1;
  const bool linear = this->Stage.Property->GetInterpolationType() == VTK_LINEAR_INTERPOLATION;
  const LatticeValues values =
    ofCells ? (linear ? LatticeValues::CellsLinear : LatticeValues::CellsNearest)
            : (linear ? LatticeValues::PointsLinear : LatticeValues::PointsNearest);
  const auto add = [&](vtkDataSet* from, int component)
  { this->Truths.push_back(std::make_unique<LatticeTruth>(from, this->Model, values, component)); };
  switch (this->Stage.Mapper->GetVectorMode())
  {
    case vtkSmartVolumeMapper::MAGNITUDE:
    {
      const auto lengths = withMagnitudes(data, ofCells);
      add(lengths, 0);
      lengths->GetScalarRange(this->Range);
      break;
    }
    case vtkSmartVolumeMapper::COMPONENT:
      add(data, this->Stage.Mapper->GetVectorComponent());
      array->GetRange(this->Range, this->Stage.Mapper->GetVectorComponent());
      break;
    default:
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        add(data, c);
      }
      array->GetRange(this->Range, 0);
      break;
  }
}
} // namespace tetmarch::testing
