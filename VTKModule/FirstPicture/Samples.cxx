// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture/Samples.h"

#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{

namespace
{

constexpr vtkIdType MostSamples = 1 << 20;

// Takes samples of one block.
class Sampler
{
public:
  Sampler(vtkDataSet* block, const DrawnArray& drawn, std::vector<Sample>& samples)
    : Block(block)
    , Values(block, drawn)
    , Samples(samples)
  {
  }

  void takeAll()
  {
    int n[3];
    if (this->Values)
    {
      isLattice(this->Block, n) ? this->takeOfLattice(n) : this->takeOfCells();
    }
  }

private:
  void takeOfCells()
  {
    const vtkIdType count = this->Block->GetNumberOfCells();
    const vtkIdType step = std::max<vtkIdType>(1, count / MostSamples);
    for (vtkIdType cell = 0; cell < count; cell += step)
    {
      this->take(cell);
    }
  }

  // A constant step over all cells would select the same few planes of cells.
  void takeOfLattice(const int n[3])
  {
    const double share = static_cast<double>(this->Block->GetNumberOfCells()) / MostSamples;
    const int step = static_cast<int>(std::ceil(std::cbrt(std::max(1.0, share))));
    const vtkIdType row = n[0] - 1;
    const vtkIdType slice = row * (n[1] - 1);
    for (int k = 0; k < n[2] - 1; k += step)
    {
      for (int j = 0; j < n[1] - 1; j += step)
      {
        for (int i = 0; i < n[0] - 1; i += step)
        {
          this->take(k * slice + j * row + i);
        }
      }
    }
  }

  void take(vtkIdType cell)
  {
    double value = 0;
    if (this->Values.ofCells())
    {
      value = this->Values.at(cell);
    }
    else
    {
      this->Block->GetCellPoints(cell, this->Points);
      const auto count = static_cast<double>(this->Points->GetNumberOfIds());
      for (const vtkIdType point : *this->Points)
      {
        value += this->Values.at(point) / count; // a sum might overflow
      }
    }
    double bounds[6];
    this->Block->GetCellBounds(cell, bounds);
    const double volume =
      (bounds[1] - bounds[0]) * (bounds[3] - bounds[2]) * (bounds[5] - bounds[4]);
    if (std::isfinite(value) && volume > 0)
    {
      this->Samples.push_back({ value, volume });
    }
  }

  vtkDataSet* Block;
  DrawnValues Values;
  std::vector<Sample>& Samples;
  vtkNew<vtkIdList> Points;
};

} // namespace

std::vector<Sample> takeSamples(const std::vector<vtkDataSet*>& blocks, const DrawnArray& drawn)
{
  std::vector<Sample> samples;
  for (vtkDataSet* block : blocks)
  {
    Sampler(block, drawn, samples).takeAll();
  }
  return samples;
}

} // namespace tetmarch
