// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HardCase.h"

#include "Groups.h"
#include "Views.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cctype>

namespace tetmarch::testing
{
const std::vector<HardCase>& hardCases()
{
  static const std::vector<HardCase> cases = []
  {
    HardCases all;
    addRayCases(all);
    addCellCases(all);
    addScaleCases(all);
    addOpticsCases(all);
    addNonConvexCases(all);
    return all;
  }();
  return cases;
}

std::vector<std::string> hardCaseNames()
{
  std::vector<std::string> names;
  for (const HardCase& hard : hardCases())
  {
    names.push_back(hard.Name);
  }
  return names;
}

std::string identifierOf(const std::string& name)
{
  std::string identifier = name;
  std::replace_if(
    identifier.begin(), identifier.end(), [](unsigned char c) { return std::isalnum(c) == 0; },
    '_');
  return identifier;
}

const HardCase* findHardCase(const std::string& name)
{
  for (const HardCase& hard : hardCases())
  {
    if (hard.Name == name)
    {
      return &hard;
    }
  }
  return nullptr;
}

std::vector<HardView> standardViews()
{
  return { perspectiveFrom("oblique", { 0.9, -1.6, 1.1 }, 4.0),
    parallelAlong("along-z", { 0.0, 0.0, 1.0 }), parallelAlong("diagonal", { 1.0, 1.0, 1.0 }) };
}

std::vector<HardView> viewsOf(const HardCase& hard)
{
  return hard.Views.empty() ? standardViews() : hard.Views;
}

HardView viewOfSameName(const HardCase& hard, const HardView& view)
{
  const std::vector<HardView> views = viewsOf(hard);
  const auto found = std::find_if(views.begin(), views.end(),
    [&](const HardView& candidate) { return candidate.Name == view.Name; });
  return found == views.end() ? views.front() : *found;
}

namespace
{
void setFunctions(vtkVolumeProperty* property, double low, double high)
{
  const auto at = [&](double share) { return (1.0 - share) * low + share * high; };
  vtkNew<vtkColorTransferFunction> colour;
  colour->AddRGBPoint(at(0.0), 0.1, 0.2, 1.0);
  colour->AddRGBPoint(at(0.45), 0.1, 1.0, 0.3);
  colour->AddRGBPoint(at(0.55), 1.0, 0.9, 0.0);
  colour->AddRGBPoint(at(1.0), 1.0, 0.1, 0.1);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(at(0.0), 0.3);
  opacity->AddPoint(at(0.3), 0.1);
  opacity->AddPoint(at(0.5), 0.8);
  opacity->AddPoint(at(0.6), 0.0);
  opacity->AddPoint(at(0.7), 0.0);
  opacity->AddPoint(at(1.0), 0.9);
  property->SetColor(colour);
  property->SetScalarOpacity(opacity);
}
} // namespace

void setStandardOptics(vtkVolumeProperty* property, vtkUnstructuredGrid* grid)
{
  double range[2] = { 0.0, 1.0 };
  if (vtkDataArray* scalars = grid->GetPointData()->GetScalars())
  {
    scalars->GetFiniteRange(range, 0);
  }
  const bool one = !(range[1] > range[0]);
  setFunctions(property, one ? range[0] - 0.5 : range[0], one ? range[0] + 0.5 : range[1]);
  property->SetScalarOpacityUnitDistance(ballOf(grid).Radius / 4.0);
}
} // namespace tetmarch::testing
