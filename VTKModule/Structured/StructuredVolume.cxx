// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Structured/StructuredVolume.h"

#include "Caching/WithinMemory.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace tetmarch
{
namespace
{

// Values may be borrowed, so their address is included.
Fingerprint inputOf(const DrawnScalars& drawn)
{
  Fingerprint input = versionOf(drawn);
  add(input, drawn.FurtherUnit);
  addAll(input, drawn.Further);
  const bool lies = drawn.Array->HasStandardMemoryLayout();
  input.push_back(
    lies ? reinterpret_cast<std::uintptr_t>(drawn.Array->GetVoidPointer(0)) : std::uintptr_t(0));
  return input;
}

} // namespace

std::string StructuredVolume::updateGeometry(vtkDataSet* data)
{
  GridGeometry geometry;
  VolumeFrame framed;
  std::string wrong;
  const std::string shortage = withinMemory("the coordinates of the grid",
    [&]
    {
      wrong = readGeometry(data, geometry);
      if (wrong.empty() && !geometry.isEmpty() && !(geometry == this->Geometry))
      {
        wrong = findFrame(geometry, framed);
      }
    });
  wrong = wrong.empty() ? shortage : wrong;
  if (!wrong.empty())
  {
    geometry = {};
  }
  if (!(geometry == this->Geometry))
  {
    this->Geometry = std::move(geometry);
    this->Frame = framed;
    this->LatticeInput.clear();
  }
  if (this->isEmpty())
  {
    this->clearValues();
  }
  return wrong;
}

std::string StructuredVolume::updateScalars(
  vtkDataSet* data, const DrawnScalars& drawn, Interpolation interpolation)
{
  if (this->isEmpty())
  {
    return {};
  }
  std::string wrong = this->updateLattice({ drawn.OfCells, interpolation });
  wrong = wrong.empty() ? checkScalars(data, drawn.Array, drawn.OfCells) : wrong;
  wrong = wrong.empty() ? this->updateHidden(data) : wrong;
  wrong = wrong.empty() ? this->updateValues(drawn) : wrong;
  wrong = wrong.empty() ? this->updateRanges(drawn.Mix) : wrong;
  if (!wrong.empty())
  {
    this->clearValues();
  }
  return wrong;
}

std::string StructuredVolume::updateLattice(const LatticeCase& lies)
{
  // Never empty, so that it differs from the input before the first lattice.
  const Fingerprint input{ lies.OfCells ? std::uintptr_t(1) : 0,
    static_cast<std::uintptr_t>(lies.Between) };
  if (input == this->LatticeInput)
  {
    return {};
  }
  this->LatticeInput.clear();
  std::string wrong;
  const std::string shortage = withinMemory("the planes of the lattice",
    [&]
    {
      const StageRecorder recorder(this->LatticeRecord);
      wrong = makeLattice(this->Geometry, this->Frame, lies, this->Made);
    });
  wrong = wrong.empty() ? shortage : wrong;
  if (wrong.empty())
  {
    this->Case = lies;
    this->Nodes = lightNodesOf(this->Made);
    this->LatticeInput = input;
  }
  return wrong;
}

std::string StructuredVolume::updateHidden(vtkDataSet* data)
{
  return withinMemory("the hidden cells", [&]
    { this->Hidden.update(data, this->Geometry.Points, this->Case, this->LatticeRecord.Runs); });
}

std::string StructuredVolume::updateValues(const DrawnScalars& drawn)
{
  const Fingerprint input = inputOf(drawn);
  if (input == this->ValuesInput)
  {
    return {};
  }
  this->clearValues();
  const std::string shortage = withinMemory("the scalars",
    [&]
    {
      const StageRecorder recorder(this->ValuesRecord);
      this->Values = storeValues(drawn);
      std::transform(this->Values.begin() + 1, this->Values.end(),
        std::back_inserter(this->FurtherRanges),
        [](const StoredValues& values) { return values.Range; });
    });
  if (shortage.empty())
  {
    this->ValuesInput = input;
  }
  return shortage;
}

std::string StructuredVolume::updateRanges(ComponentMix mix)
{
  const Fingerprint input = this->valuesVersion();
  if (input == this->RangesInput)
  {
    return {};
  }
  this->RangesInput.clear();
  const std::string shortage = withinMemory("the ranges of blocks",
    [&]
    {
      const StageRecorder recorder(this->RangesRecord);
      const std::size_t count = mix == ComponentMix::Independent ? this->Values.size() : 1;
      this->Ranges.clear();
      for (std::size_t k = 0; k < count; ++k)
      {
        this->Ranges.push_back(findBlockRanges(this->Made, this->Values[k]));
      }
    });
  if (shortage.empty())
  {
    this->RangesInput = input;
  }
  return shortage;
}

void StructuredVolume::clearValues()
{
  this->ValuesInput.clear();
  this->RangesInput.clear();
  this->Values.clear();
  this->FurtherRanges.clear();
  this->Ranges.clear();
}

vtkIdType StructuredVolume::dataCellOf(std::uint32_t cell, const Vector3& point) const
{
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

Fingerprint StructuredVolume::latticeVersion() const
{
  return { static_cast<std::uintptr_t>(this->LatticeRecord.Runs) };
}

Fingerprint StructuredVolume::valuesVersion() const
{
  return { static_cast<std::uintptr_t>(this->LatticeRecord.Runs),
    static_cast<std::uintptr_t>(this->ValuesRecord.Runs) };
}

} // namespace tetmarch
