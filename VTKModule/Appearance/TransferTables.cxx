// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Appearance/TransferTables.h"

#include "Caching/WithinMemory.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

void addFunctions(Fingerprint& fingerprint, vtkVolumeProperty* property, int component)
{
  add(fingerprint, property->GetScalarOpacity(component));
  add(fingerprint, property->GetColorChannels(component) == 1
                     ? static_cast<vtkObject*>(property->GetGrayTransferFunction(component))
                     : property->GetRGBTransferFunction(component));
}

void addRange(Fingerprint& fingerprint, const ScalarRange& range)
{
  add(fingerprint, range.Low);
  add(fingerprint, range.High);
}

// The getters of functions of components that are not drawn would create them.
Fingerprint versionOf(vtkVolumeProperty* property, const TableInput& input)
{
  Fingerprint version;
  const bool independent = input.Mix == ComponentMix::Independent;
  const int functions = independent ? 1 + static_cast<int>(input.ExtraRanges.size()) : 1;
  for (int k = 0; k < functions; ++k)
  {
    addFunctions(version, property, k);
  }
  const OpacityLaw law = input.Blend->isComposite() ? input.Law : OpacityLaw::Unstructured;
  version.push_back(static_cast<std::uintptr_t>(law));
  version.push_back(input.Blend->isSum() ? 1 : 0);
  version.push_back(static_cast<std::uintptr_t>(input.Mix));
  version.push_back(input.HasVariations ? 1 : 0);
  addRange(version, input.Range);
  for (const ScalarRange& range : input.ExtraRanges)
  {
    addRange(version, range);
  }
  return version;
}

// All tables lie in one buffer of the GPU.
AccuracyLevel fittedTo(const TableInput& input, AccuracyLevel level)
{
  const std::uint64_t mostOfOne = input.MostEntries / (1 + input.ExtraRanges.size());
  level.MostTableEntries =
    static_cast<int>(std::min<std::uint64_t>(level.MostTableEntries, mostOfOne));
  return level;
}

} // namespace

IntegralTable makeTables(vtkVolumeProperty* property, const TableInput& input,
  const AccuracyLevel& wanted, Components& components)
{
  const AccuracyLevel level = fittedTo(input, wanted);
  components.Tables.clear();
  if (!components.isSingle())
  {
    IntegralTable first = componentTables(property, input.Law, input.Range, level, components);
    if (input.HasVariations)
    {
      addSlopeVariations(first); // for rays towards the light, which use only this table
    }
    return first;
  }
  IntegralTable table = blendedTable(property, input.Law, *input.Blend, input.Range, level);
  if (input.HasVariations)
  {
    addExtinctionVariations(table);
    addSlopeVariations(table);
  }
  return table;
}

std::string TransferTables::update(
  vtkVolumeProperty* property, const TableInput& input, const AccuracyLevel& wanted)
{
  const AccuracyLevel level = fittedTo(input, wanted);
  this->Parts.Mix = input.Mix;
  this->Parts.ExtraRanges = input.ExtraRanges;
  const std::string badUnit = setFactors(property, this->Parts);
  if (!badUnit.empty())
  {
    return badUnit;
  }
  Fingerprint from = versionOf(property, input);
  this->Shown = from;
  addAll(this->Shown, this->Parts.Factors);
  from.push_back(static_cast<std::uintptr_t>(level.LeastTableEntries));
  from.push_back(static_cast<std::uintptr_t>(level.MostTableEntries));
  add(from, level.ErrorTolerance);
  if (from == this->MadeFrom)
  {
    return {};
  }
  this->MadeFrom.clear();
  const std::string shortage = withinMemory("the tables of the transfer functions",
    [&]
    {
      const StageRecorder recorder(this->Record);
      this->First = makeTables(property, input, level, this->Parts);
    });
  if (shortage.empty())
  {
    this->Visible = hasExtinction(this->First) || this->Parts.isExtraVisible();
    this->MadeFrom = from;
  }
  return shortage;
}

std::vector<BufferSize> TransferTables::bufferSizes() const
{
  std::vector<BufferSize> sizes{ { "table entries", this->First.Values.size(), 16 + 16 + 4 } };
  if (!this->Parts.isSingle())
  {
    std::size_t extra = 0;
    for (const IntegralTable& table : this->Parts.Tables)
    {
      extra += table.Values.size();
    }
    sizes.push_back({ "extra table entries", extra, 16 + 16 + 4 });
    sizes.push_back({ "variations of extinction", this->First.Values.size() + extra, 4 });
  }
  return sizes;
}

} // namespace tetmarch
