// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Appearance/Components.h"

#include "Variants/VariantKey.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <numeric>

namespace tetmarch
{
namespace
{

std::string describeArray(vtkDataArray* array)
{
  return std::string("The scalar array \"") + (array->GetName() ? array->GetName() : "") +
         "\" has " + std::to_string(array->GetNumberOfComponents()) + " components";
}

// Red, green and blue as VTK takes them where it maps no scalars (vtkMapper's
// VTK_COLOR_MODE_DIRECT_SCALARS).
double colorUnit(vtkDataArray* array)
{
  const int type = array->GetDataType();
  return type == VTK_FLOAT || type == VTK_DOUBLE ? 1.0 : 255.0;
}

DrawnComponents dependent(vtkDataArray* array, std::string& error)
{
  const int count = array->GetNumberOfComponents();
  if (count == 2)
  {
    return { ComponentMix::ColorAndOpacity, { false, 1 }, { { 0 }, 0 } };
  }
  if (count == 4)
  {
    return { ComponentMix::DirectColor, { false, 3 }, { { 0, 1, 2 }, colorUnit(array) } };
  }
  error =
    describeArray(array) +
    ", but dependent ones (vtkVolumeProperty::IndependentComponentsOff()) are either 2, for "
    "colour and opacity, or 4, for red, green, blue and opacity. Switch IndependentComponents "
    "on, or choose what is drawn by VectorMode.";
  return {};
}

DrawnComponents independent(vtkDataArray* array, std::string& error)
{
  const int count = array->GetNumberOfComponents();
  if (count > MostComponents)
  {
    error = describeArray(array) + ", but at most " + std::to_string(MostComponents) +
            " independent ones can be drawn together. Choose one by VectorMode.";
    return {};
  }
  DrawnComponents drawn{ ComponentMix::Independent, {}, {} };
  drawn.Further.Components.resize(count - 1);
  std::iota(drawn.Further.Components.begin(), drawn.Further.Components.end(), 1);
  return drawn;
}

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

// Without a node beyond those of the other function, since tables reach from the first to the last.
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

DrawnComponents drawnComponents(
  const VectorOptions& choice, vtkVolumeProperty* property, vtkDataArray* array, std::string& error)
{
  error.clear();
  const bool several = array->GetNumberOfComponents() > 1;
  const bool all = choice.Mode == VectorMode::AllComponents;
  if (several && !property->GetIndependentComponents() &&
      (all || choice.Mode == VectorMode::Disabled))
  {
    return dependent(array, error);
  }
  if (several && all)
  {
    return independent(array, error);
  }
  DrawnComponents drawn;
  drawn.Scalar = tupleScalarOf(choice, property, array, error);
  return drawn;
}

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
    add(this->Tables[k], this->Further.Ranges[k]);
  }
  return places;
}

bool Components::isFurtherVisible() const
{
  return this->isIndependent() &&
         std::any_of(this->Tables.begin(), this->Tables.end(),
           [](const IntegralTable& table) { return hasExtinction(table); });
}

ScalarRange readComponents(vtkUnstructuredGrid* grid, vtkDataArray* array, bool ofCells,
  const DrawnComponents& drawn, TetMesh& mesh, std::vector<float>& cellScalars,
  Components& components)
{
  ScalarRange range;
  cellScalars.clear();
  components = {};
  if (ofCells)
  {
    range = makeCellScalars(array, mesh, cellScalars, drawn.Scalar);
    components.Further = furtherCellScalars(array, drawn.Further, mesh, cellScalars, range);
  }
  else
  {
    range = setPointScalars(grid, array, mesh, drawn.Scalar);
    components.Further = furtherPointScalars(grid, array, drawn.Further, mesh, range);
  }
  components.Mix = drawn.Mix;
  return range;
}

void addFunctions(
  Fingerprint& fingerprint, const Components& components, vtkVolumeProperty* property)
{
  fingerprint.push_back(static_cast<std::uintptr_t>(components.Mix));
  for (int k = 1; k < components.count() && components.isIndependent(); ++k)
  {
    add(fingerprint, property->GetScalarOpacity(k));
    add(fingerprint, property->GetColorChannels(k) == 1
                       ? static_cast<vtkObject*>(property->GetGrayTransferFunction(k))
                       : property->GetRGBTransferFunction(k));
  }
  for (const ScalarRange& range : components.Further.Ranges)
  {
    add(fingerprint, range.Low);
    add(fingerprint, range.High);
  }
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

void addBufferSizes(
  std::vector<BufferSize>& sizes, const Components& components, const IntegralTable& first)
{
  if (components.isSingle())
  {
    return;
  }
  const std::size_t count = components.Further.count();
  const std::size_t entries =
    std::accumulate(components.Tables.begin(), components.Tables.end(), std::size_t(0),
      [](std::size_t sum, const IntegralTable& table) { return sum + table.Values.size(); });
  sizes.push_back({ "further scalars", components.Further.Values.size() / count,
    (count < 3 ? count : 4) * sizeof(float) });
  sizes.push_back({ "further table entries", entries, 16 + 16 + 4 });
  sizes.push_back({ "variations of extinction", first.Values.size() + entries, 4 });
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
    components.Tables.push_back(colorTable(property, components.Further.Ranges[0], level));
  }
  for (int k = 1; k < components.count() && components.isIndependent(); ++k)
  {
    components.Tables.push_back(tableOf(property, k, law, components.Further.Ranges[k - 1], level));
  }
  return first;
}

} // namespace tetmarch
