// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Samples.h"

#include "VolumeData.h"

#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>

namespace
{
using tetmarch::ArraySelection;
using tetmarch::Association;
using tetmarch::Sample;

constexpr vtkIdType MaximumSamples = 1 << 20;

/// Takes samples of one block.
class Sampler
{
public:
  Sampler(vtkDataSet* block, const ArraySelection& selection, std::vector<Sample>& samples)
    : Block(block)
    , Array(tetmarch::FindArray(block, selection))
    , Selection(selection)
    , Samples(samples)
  {
  }

  void TakeAll()
  {
    if (this->Array && this->Selection.Component < this->Array->GetNumberOfComponents())
    {
      tetmarch::IsStructured(this->Block) ? this->TakeOfLattice() : this->TakeOfCells();
    }
  }

private:
  void TakeOfCells()
  {
    const vtkIdType count = this->Block->GetNumberOfCells();
    const vtkIdType step = std::max<vtkIdType>(1, count / MaximumSamples);
    for (vtkIdType cell = 0; cell < count; cell += step)
    {
      this->Take(cell);
    }
  }

  // A step over all cells would meet the same few planes of cells again and again.
  void TakeOfLattice()
  {
    int n[3];
    tetmarch::GetDimensions(this->Block, n);
    const double share = static_cast<double>(this->Block->GetNumberOfCells()) / MaximumSamples;
    const int step = static_cast<int>(std::ceil(std::cbrt(std::max(1.0, share))));
    const vtkIdType row = n[0] - 1;
    const vtkIdType slice = row * (n[1] - 1);
    for (int k = 0; k < n[2] - 1; k += step)
    {
      for (int j = 0; j < n[1] - 1; j += step)
      {
        for (int i = 0; i < n[0] - 1; i += step)
        {
          this->Take(k * slice + j * row + i);
        }
      }
    }
  }

  void Take(vtkIdType cell)
  {
    double value = 0.0;
    if (this->Selection.Where == Association::CELLS)
    {
      value = this->ValueOf(cell);
    }
    else
    {
      this->Block->GetCellPoints(cell, this->Points);
      for (const vtkIdType point : *this->Points)
      {
        value += this->ValueOf(point);
      }
      value /= static_cast<double>(this->Points->GetNumberOfIds());
    }
    double bounds[6];
    this->Block->GetCellBounds(cell, bounds);
    const double volume =
      (bounds[1] - bounds[0]) * (bounds[3] - bounds[2]) * (bounds[5] - bounds[4]);
    if (std::isfinite(value) && volume > 0.0)
    {
      this->Samples.push_back({ value, volume });
    }
  }

  double ValueOf(vtkIdType tuple) const
  {
    if (this->Selection.Component >= 0)
    {
      return this->Array->GetComponent(tuple, this->Selection.Component);
    }
    double square = 0.0;
    for (int i = 0; i < this->Array->GetNumberOfComponents(); ++i)
    {
      const double component = this->Array->GetComponent(tuple, i);
      square += component * component;
    }
    return std::sqrt(square);
  }

  vtkDataSet* Block;
  vtkDataArray* Array;
  const ArraySelection& Selection;
  std::vector<Sample>& Samples;
  vtkNew<vtkIdList> Points;
};
} // namespace

namespace tetmarch
{

std::vector<Sample> TakeSamples(
  const std::vector<vtkDataSet*>& blocks, const ArraySelection& selection)
{
  std::vector<Sample> samples;
  for (vtkDataSet* block : blocks)
  {
    Sampler(block, selection, samples).TakeAll();
  }
  return samples;
}

} // namespace tetmarch
