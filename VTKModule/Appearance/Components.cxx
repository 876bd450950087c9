// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Appearance/Components.h"

#include "Variants/VariantKey.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

void setColors(vtkVolumeProperty* from, int component, vtkVolumeProperty* to)
{
  if (from->GetColorChannels(component) == 1)
  {
    to->SetColor(from->GetGrayTransferFunction(component));
  }
  else
  {
    to->SetColor(from->GetRGBTransferFunction(component));
  }
}

// Its only node is one of the other function, since tables extend from the first node to the last.
vtkSmartPointer<vtkPiecewiseFunction> constantOne(double node)
{
  auto one = vtkSmartPointer<vtkPiecewiseFunction>::New();
  one->AddPoint(node, 1.0);
  return one;
}

IntegralTable withVariations(IntegralTable table)
{
  addExtinctionVariations(table);
  return table;
}

// The functions of one component.
IntegralTable tableOf(vtkVolumeProperty* property, int component, OpacityLaw law,
  const ScalarRange& range, const AccuracyLevel& level)
{
  vtkNew<vtkVolumeProperty> own;
  setColors(property, component, own);
  own->SetScalarOpacity(property->GetScalarOpacity(component));
  return withVariations(fittingTable(own, law, range.Low, range.High, level));
}

// The opacity function, in one colour.
IntegralTable opacityTable(
  vtkVolumeProperty* property, OpacityLaw law, const ScalarRange& range, const AccuracyLevel& level)
{
  vtkNew<vtkVolumeProperty> own;
  own->SetScalarOpacity(property->GetScalarOpacity());
  own->SetColor(constantOne(property->GetScalarOpacity()->GetRange()[0]));
  return withVariations(fittingTable(own, law, range.Low, range.High, level));
}

// The colour function, with an extinction of 1.
IntegralTable colorTable(
  vtkVolumeProperty* property, const ScalarRange& range, const AccuracyLevel& level)
{
  vtkNew<vtkVolumeProperty> own;
  setColors(property, 0, own);
  own->SetScalarOpacity(
    constantOne(own->GetColorChannels() == 1 ? own->GetGrayTransferFunction()->GetRange()[0]
                                             : own->GetRGBTransferFunction()->GetRange()[0]));
  return withVariations(fittingTable(own, OpacityLaw::Unstructured, range.Low, range.High, level));
}

} // namespace

void Components::setBits(VariantKey& key) const { key.Components = this->Mix; }

std::vector<TablePlace> Components::places(
  const IntegralTable& first, const ScalarRange& range) const
{
  std::vector<TablePlace> places;
  int entries = 0;
  const auto add = [&](const IntegralTable& table, const ScalarRange& own)
  {
    places.push_back({ entries, table.size(), table.IntegralUnit, table.scale(own.width()),
      table.offset(own.Low) });
    entries += table.size();
  };
  add(first, range);
  for (std::size_t k = 0; k < this->Tables.size(); ++k)
  {
    add(this->Tables[k], this->ExtraRanges[k]);
  }
  return places;
}

bool Components::isExtraVisible() const
{
  return this->isIndependent() &&
         std::any_of(this->Tables.begin(), this->Tables.end(),
           [](const IntegralTable& table) { return hasExtinction(table); });
}

std::string setFactors(vtkVolumeProperty* property, Components& components)
{
  components.Factors.fill(1);
  for (int k = 0; k < components.count() && components.isIndependent(); ++k)
  {
    const double unit = property->GetScalarOpacityUnitDistance(k);
    if (!(unit > 0))
    {
      return "The scalar opacity unit distance of component " + std::to_string(k) + " is " +
             std::to_string(unit) +
             "; it must be above 0 (vtkVolumeProperty::SetScalarOpacityUnitDistance).";
    }
    components.Factors[k] =
      property->GetComponentWeight(k) * property->GetScalarOpacityUnitDistance(0) / unit;
  }
  return {};
}

IntegralTable componentTables(vtkVolumeProperty* property, OpacityLaw law, const ScalarRange& range,
  const AccuracyLevel& level, Components& components)
{
  components.Tables.clear();
  IntegralTable first = components.isIndependent() ? tableOf(property, 0, law, range, level)
                                                   : opacityTable(property, law, range, level);
  first.NanColor = nanColorOf(property, law);
  if (components.Mix == ComponentMix::ColorAndOpacity)
  {
    components.Tables.push_back(colorTable(property, components.ExtraRanges[0], level));
  }
  for (int k = 1; k < components.count() && components.isIndependent(); ++k)
  {
    components.Tables.push_back(tableOf(property, k, law, components.ExtraRanges[k - 1], level));
  }
  return first;
}

} // namespace tetmarch
