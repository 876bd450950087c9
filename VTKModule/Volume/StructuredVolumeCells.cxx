// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells and planes of the data behind those of the lattice.
#include "Volume/StructuredVolume.h"

#include <algorithm>

namespace tetmarch
{

vtkIdType StructuredVolume::cellOf(std::uint32_t cell, const Vector3& point) const
{
  if (this->Leaves)
  {
    return cell;
  }
  const auto& m = this->Made.FromNormalized;
  vtkIdType number = 0;
  vtkIdType stride = 1; // of data cells
  for (int a = 0; a < 3; ++a)
  {
    const auto cells = static_cast<std::uint32_t>(this->Made.Axes[a].Cells);
    auto along = static_cast<int>(cell % cells);
    cell /= cells;
    const int dataCells = this->Geometry.Points[a] - 1;
    if (this->Case.isShifted())
    {
      // A cell between centres contains the data's plane of the same index.
      const double place =
        m[4 * a] * point[0] + m[4 * a + 1] * point[1] + m[4 * a + 2] * point[2] + m[4 * a + 3];
      along -= place < latticePlace(this->Geometry, a, along) ? 1 : 0;
      along = std::clamp(along, 0, dataCells - 1);
    }
    number += stride * along;
    stride *= dataCells;
  }
  return number;
}

std::array<std::vector<double>, 3> StructuredVolume::dataPlanes() const
{
  std::array<std::vector<double>, 3> planes;
  for (int a = 0; a < 3 && this->Case.isShifted(); ++a)
  {
    for (int i = 0; i < this->Geometry.Points[a]; ++i)
    {
      planes[a].push_back(latticePlace(this->Geometry, a, i));
    }
  }
  return planes;
}

} // namespace tetmarch
