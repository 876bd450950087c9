// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/RefinedCells.h"

#include "vtkImageData.h"
#include "vtkOverlappingAMR.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetmarch
{
namespace
{

// Whether the cells of the first one belong to a coarser level.
bool isCoarser(vtkImageData* a, vtkImageData* b)
{
  return a && b && a->GetSpacing()[0] > 1.5 * b->GetSpacing()[0];
}

// Mark the cells of the coarse image that lie in the fine one.
void markCovered(vtkImageData* coarse, vtkImageData* fine, std::vector<bool>& covered)
{
  constexpr double slack = 1e-3; // of a cell
  std::array<double, 6> low{}, box{};
  coarse->GetBounds(low.data());
  fine->GetBounds(box.data());
  int points[3];
  coarse->GetDimensions(points);
  std::array<int, 3> begin{}, end{};
  for (int a = 0; a < 3; ++a)
  {
    const double spacing = coarse->GetSpacing()[a];
    const double from = std::ceil((box[2 * a] - low[2 * a]) / spacing - slack);
    const double to = std::floor((box[2 * a + 1] - low[2 * a]) / spacing + slack);
    const double most = points[a] - 1;
    begin[a] = static_cast<int>(std::clamp(from, 0.0, most));
    end[a] = static_cast<int>(std::clamp(to, 0.0, most));
  }
  for (int k = begin[2]; k < end[2]; ++k)
  {
    for (int j = begin[1]; j < end[1]; ++j)
    {
      const std::size_t row = (static_cast<std::size_t>(k) * (points[1] - 1) + j) * (points[0] - 1);
      for (int i = begin[0]; i < end[0]; ++i)
      {
        covered[row + i] = true;
      }
    }
  }
}

} // namespace

std::vector<std::vector<bool>> refinedCells(vtkDataObject* input, const std::vector<Block>& drawn)
{
  const bool overlap = vtkOverlappingAMR::SafeDownCast(input) != nullptr;
  std::vector<std::vector<bool>> refined(overlap ? drawn.size() : 0);
  for (std::size_t b = 0; b < refined.size(); ++b)
  {
    auto* image = vtkImageData::SafeDownCast(drawn[b].Data);
    refined[b].resize(static_cast<std::size_t>(drawn[b].Data->GetNumberOfCells()));
    for (const Block& other : drawn)
    {
      auto* fine = vtkImageData::SafeDownCast(other.Data);
      if (isCoarser(image, fine))
      {
        markCovered(image, fine, refined[b]);
      }
    }
  }
  return refined;
}

} // namespace tetmarch
