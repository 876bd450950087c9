// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellTypeCode.h"
#include "GridCode.h"

#include "Input/CellKind.h"

#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>

namespace tetmarch::testing
{
namespace
{
// The number as a signed byte other than -128, which announces a wild number.
std::uint8_t asByte(double value)
{
  return static_cast<std::uint8_t>(
    static_cast<std::int8_t>(std::lround(std::min(std::max(value, -127.0), 127.0))));
}
} // namespace

Bytes encode(vtkUnstructuredGrid* grid, std::uint8_t flags, std::uint8_t seed)
{
  const RawGrid raw(grid);
  const double* bounds = grid->GetBounds();
  const double extent =
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  Bytes bytes{ flags, seed, 0, static_cast<std::uint8_t>(raw.Points.size() / 3) };
  for (std::size_t i = 0; i < raw.Points.size(); ++i)
  {
    bytes.push_back(asByte(250.0 * (raw.Points[i] - bounds[2 * (i % 3)]) / extent - 125.0));
  }
  bytes.push_back(static_cast<std::uint8_t>(raw.Types.size()));
  vtkNew<vtkIdList> ids;
  for (std::size_t cell = 0; cell < raw.Types.size(); ++cell)
  {
    const int type = raw.Types[cell];
    bytes.push_back(static_cast<std::uint8_t>(codeOfType(type)));
    grid->GetFaceStream(static_cast<vtkIdType>(cell), ids); // or points, if it is no polyhedron
    if (type != VTK_POLYHEDRON && cellKinds()[type].LeastPoints != cellKinds()[type].MostPoints)
    {
      bytes.push_back(static_cast<std::uint8_t>(ids->GetNumberOfIds()));
    }
    bytes.insert(bytes.end(), ids->begin(), ids->end());
  }
  bytes.push_back(0);                     // no damage
  bytes.insert(bytes.end(), { 0, 0, 0 }); // doubles, one component, as many as expected
  const std::size_t scalars = (flags & 4) != 0 ? raw.Types.size() : raw.Points.size() / 3;
  for (std::size_t i = 0; i < scalars; ++i)
  {
    bytes.push_back(asByte(static_cast<double>(i * 37 % 201) - 100.0));
  }
  // One node between the two that are always there.
  bytes.insert(bytes.end(), { 1, 10, 255, 40, 0, 128, 0, 30, 128, 0 });
  return bytes;
}
} // namespace tetmarch::testing
