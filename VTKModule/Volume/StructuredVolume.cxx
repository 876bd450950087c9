// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volume/StructuredVolume.h"

#include "Appearance/Blending.h"
#include "Appearance/Components.h"
#include "Caching/WithinMemory.h"
#include "Reference/ReferenceImage.h"
#include "Variants/VariantKey.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace tetmarch
{
namespace
{

// Of the blocks, the empty ones: what leaps gain and what asking for them costs is much the same.
constexpr double LeastShareToKeepLeaping = 0.05;

// Values may be borrowed, so their address is included.
Fingerprint inputOf(const DrawnScalars& drawn)
{
  Fingerprint input = versionOf(drawn);
  add(input, drawn.ExtraUnit);
  addAll(input, drawn.Extra);
  const bool lies = drawn.Array->HasStandardMemoryLayout();
  input.push_back(
    lies ? reinterpret_cast<std::uintptr_t>(drawn.Array->GetVoidPointer(0)) : std::uintptr_t(0));
  return input;
}

} // namespace

std::string StructuredVolume::updateGeometry(
  const VolumeInput& input, const ResourceLimits& limits, const Progress&)
{
  vtkDataSet* data = input.Data;
  GridGeometry geometry;
  VolumeFrame framed;
  std::string wrong;
  const std::string shortage = withinMemory("the coordinates of the grid",
    [&]
    {
      if (input.Leaves)
      {
        geometry = input.Leaves->Geometry;
      }
      else
      {
        wrong = readGeometry(data, geometry);
      }
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
  if (!(geometry == this->Geometry) || input.Leaves != this->Leaves)
  {
    this->Leaves = input.Leaves;
    this->Geometry = std::move(geometry);
    this->Frame = framed;
    this->LatticeInput.clear();
  }
  if (this->isEmpty())
  {
    this->clearValues();
    return wrong;
  }
  // The least that any type of value takes, before any is read.
  return describeExcess({ { "values", static_cast<std::uint64_t>(data->GetNumberOfPoints()), 1 } },
    { std::numeric_limits<std::uint64_t>::max(), limits.Bytes }, SizesAre::LowerBounds);
}

std::string StructuredVolume::updateScalars(const VolumeInput& input, const DrawnScalars& drawn)
{
  if (this->isEmpty())
  {
    return {};
  }
  LatticeCase lies{ drawn.OfCells, input.Between };
  std::array<int, 3> points = this->Geometry.Points;
  if (this->Leaves)
  {
    vtkImageData::SafeDownCast(input.Data)->GetDimensions(points.data());
    lies = { true, Interpolation::Nearest, { { points[0] - 1, points[1] - 1, points[2] - 1 } } };
  }
  std::string wrong = this->updateLattice(lies);
  wrong = wrong.empty()
            ? withinMemory("the hidden cells", [&]
                { this->Hidden.update(input.Data, points, this->Case, this->LatticeRecord.Runs); })
            : wrong;
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
  Fingerprint input{ lies.OfCells ? std::uintptr_t(1) : 0,
    static_cast<std::uintptr_t>(lies.Between) };
  addAll(input, lies.ValuesOfLeaves);
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
      this->ValuesOfLeaves = this->Leaves ? drawn.Array : nullptr;
      this->Values = storeValues(drawn);
      std::transform(this->Values.begin() + 1, this->Values.end(),
        std::back_inserter(this->ExtraRanges),
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
  const Fingerprint input = this->scalarsVersion();
  if (input == this->RangesInput)
  {
    return {};
  }
  this->RangesInput.clear();
  const std::string shortage = withinMemory("the ranges of blocks",
    [&]
    {
      const StageRecorder recorder(this->RangesRecord);
      const std::size_t count = this->Leaves                       ? 0
                                : mix == ComponentMix::Independent ? this->Values.size()
                                                                   : 1;
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
  this->ValuesOfLeaves = nullptr;
  this->ExtraRanges.clear();
  this->Ranges.clear();
}

// Of dependent components the first one is that of the opacity: the others show nothing without it.
std::vector<ShownScalar> StructuredVolume::shownScalars(
  const IntegralTable& first, const Components& parts) const
{
  std::vector<ShownScalar> shown{ { &this->Ranges.front(), &first, this->range() } };
  for (std::size_t k = 1; k < this->Ranges.size(); ++k)
  {
    shown.push_back({ &this->Ranges[k], &parts.Tables[k - 1], this->ExtraRanges[k - 1] });
  }
  return shown;
}

std::string StructuredVolume::updateVisibility(
  const IntegralTable& first, const Components& parts, const Blending& blending, bool undrawnSeen)
{
  return withinMemory("the distances to what is seen",
    [&]
    {
      // Surfaces between constant cells lie between blocks, too, whose ranges do not tell of them.
      if (this->Leaves)
      {
        this->Empty.clear();
      }
      else if (blending.isIsoSurface() && !this->Made.Constant)
      {
        this->Empty.updateSurfaces(
          this->Ranges.front(), blending.IsoValues, this->RangesRecord.Runs);
      }
      else if (blending.isComposite())
      {
        this->Empty.update(this->shownScalars(first, parts), undrawnSeen, this->RangesRecord.Runs);
      }
      else
      {
        this->Empty.clear();
      }
      this->Leaps.update(isWorthLeaping(this->emptySpace()),
        this->emptySpace().EmptyShare >= LeastShareToKeepLeaping, this->version());
    });
}

void StructuredVolume::setBits(VariantKey& key) const
{
  key.Structured = true;
  key.PointScalars = !this->Made.Constant;
  key.Rectilinear = !this->Made.isUniform();
  key.Octree = this->Leaves != nullptr;
  key.HiddenCells = !this->hiddenCells().empty();
  key.Leaps = this->leaps();
}

void StructuredVolume::addTo(ReferenceScene& scene) const
{
  scene.Cells = &this->Made;
  scene.Tree = this->octree();
  scene.Values = &this->Values.front();
  scene.Range = this->range();
  scene.Hidden = &this->hiddenCells();
}

std::vector<EffectSource::VertexStart> StructuredVolume::vertexStarts() const
{
  std::vector<VertexStart> starts(this->Nodes.count());
  for (std::uint32_t i = 0; i < this->Nodes.count(); ++i)
  {
    const std::array<std::uint32_t, 3> numbers = this->Nodes.numbersOf(i);
    starts[i] = { { numbers[0], numbers[1], numbers[2], 0 } };
  }
  return starts;
}

bool StructuredVolume::startPoint(std::size_t, const VertexStart& start, Vector3& point) const
{
  point = this->Nodes.point({ { start[0], start[1], start[2] } });
  return true;
}

Fingerprint StructuredVolume::version() const
{
  Fingerprint version = this->scalarsVersion();
  add(version, this->hiddenVersion());
  return version;
}

Fingerprint StructuredVolume::geometryVersion() const
{
  return { static_cast<std::uintptr_t>(this->LatticeRecord.Runs) };
}

Fingerprint StructuredVolume::scalarsVersion() const
{
  return { static_cast<std::uintptr_t>(this->LatticeRecord.Runs),
    static_cast<std::uintptr_t>(this->ValuesRecord.Runs) };
}

} // namespace tetmarch
