// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Transfer functions that jump, that are empty, that make all of the volume bright or dark; all for
// scalars 0..1 on the cube of "jittered-cube".
#include "CaseGroup.h"
#include "CaseOptics.h"

#include "SmallGrids.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <cmath>

namespace tetmarch::testing
{
namespace
{
constexpr Range Unit = { 0.0, 1.0 };
constexpr double TableEntry = 1.0 / 1024.0;

// The standard optics over 0..1 with another opacity or other colours.
HardCase& addOpacity(CaseGroup& group, const char* name, const char* what,
  const std::function<void(vtkPiecewiseFunction*)>& fill, double depthOfDiagonal = 11.0)
{
  HardCase& hard = fills(group.add(name, what, jitteredCube));
  hard.SetOptics = [=](vtkVolumeProperty* property, vtkUnstructuredGrid* grid)
  {
    vtkNew<vtkPiecewiseFunction> opacity;
    fill(opacity);
    setStandardColours(property, Unit);
    property->SetScalarOpacity(opacity);
    setDepthOfDiagonal(property, grid, depthOfDiagonal);
  };
  return hard;
}

HardCase& addColours(CaseGroup& group, const char* name, const char* what,
  const std::function<void(vtkColorTransferFunction*)>& fill)
{
  HardCase& hard = fills(group.add(name, what, jitteredCube));
  hard.SetOptics = [=](vtkVolumeProperty* property, vtkUnstructuredGrid* grid)
  {
    standardOpticsOver(Unit)(property, grid);
    vtkNew<vtkColorTransferFunction> colours;
    fill(colours);
    property->SetColor(colours);
  };
  return hard;
}

void addJumps(CaseGroup& group)
{
  addOpacity(group, "steps", "opacity by steps, nodes one double apart",
    [](vtkPiecewiseFunction* opacity)
    {
      double value = 0.05;
      opacity->AddPoint(0.0, value);
      for (const double x : { 0.2, 0.35, 0.5, 0.8 })
      {
        opacity->AddPoint(x, value);
        value = 0.9 - value;
        opacity->AddPoint(std::nextafter(x, 1.0), value);
      }
      opacity->AddPoint(1.0, value);
    });
  addOpacity(
    group, "spikes-of-one-entry", "spikes as wide as 1/1024 of the range",
    [](vtkPiecewiseFunction* opacity)
    {
      for (const double x : { 0.2, 0.37, 0.5, 0.7, 0.9 })
      {
        opacity->AddPoint(x - 0.5 * TableEntry, 0.0);
        opacity->AddPoint(x, 1.0);
        opacity->AddPoint(x + 0.5 * TableEntry, 0.0);
      }
    },
    2000.0);
  addOpacity(group, "spikes-without-width", "nodes at the same scalar: 0, 1, 0",
    [](vtkPiecewiseFunction* opacity)
    {
      opacity->AllowDuplicateScalarsOn();
      opacity->AddPoint(0.0, 0.1);
      for (const double x : { 0.25, 0.5, 0.75 })
      {
        opacity->AddPoint(x, 0.1);
        opacity->AddPoint(x, 1.0);
        opacity->AddPoint(x, 0.1);
      }
      opacity->AddPoint(1.0, 0.1);
    });
  addOpacity(group, "nodes-replaced", "the same without duplicates allowed: the last node counts",
    [](vtkPiecewiseFunction* opacity)
    {
      opacity->AddPoint(0.0, 0.1);
      for (const double value : { 0.1, 1.0, 0.3 })
      {
        opacity->AddPoint(0.5, value);
      }
      opacity->AddPoint(1.0, 0.1);
    });
  addOpacity(group, "midpoints-and-sharpness", "nodes with midpoints 0 and 1 and sharpness 0 and 1",
    [](vtkPiecewiseFunction* opacity)
    {
      opacity->AddPoint(0.0, 0.0, 0.5, 1.0);
      opacity->AddPoint(0.2, 0.8, 0.0, 0.0);
      opacity->AddPoint(0.4, 0.1, 1.0, 0.0);
      opacity->AddPoint(0.6, 0.9, 0.0, 1.0);
      opacity->AddPoint(0.8, 0.0, 1.0, 1.0);
      opacity->AddPoint(1.0, 0.7, 0.3, 0.6);
    });
  addColours(group, "colours-by-steps", "colours in VTK's step space",
    [](vtkColorTransferFunction* colours)
    {
      colours->SetColorSpaceToStep();
      colours->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
      colours->AddRGBPoint(0.4, 0.0, 1.0, 0.0);
      colours->AddRGBPoint(0.7, 0.0, 0.0, 1.0);
      colours->AddRGBPoint(1.0, 1.0, 1.0, 1.0);
    });
}

void addExtremes(CaseGroup& group)
{
  const auto constant = [](double value)
  { return [value](vtkPiecewiseFunction* opacity) { opacity->AddPoint(0.5, value); }; };
  addOpacity(group, "opacity-0", "transparent everywhere", constant(0.0));
  addOpacity(group, "opacity-1", "opacity 1 everywhere", constant(1.0));
  addOpacity(group, "unit-distance-1e-9", "optical depths of 1e9: opaque at once", constant(0.5),
    std::sqrt(3.0) * 1e9);
  addOpacity(group, "unit-distance-1e9", "optical depths of 1e-9: nothing to see", constant(0.5),
    std::sqrt(3.0) * 1e-9);
  addOpacity(
    group, "unit-distance-1e-9-with-gaps", "opaque at once but where the functions leave gaps",
    [](vtkPiecewiseFunction* opacity)
    {
      const double nodes[][2] = { { 0.0, 0.0 }, { 0.3, 0.0 }, { 0.4, 1.0 }, { 0.5, 0.0 },
        { 0.8, 0.0 }, { 1.0, 1.0 } };
      for (const auto& node : nodes)
      {
        opacity->AddPoint(node[0], node[1]);
      }
    },
    std::sqrt(3.0) * 1e9);
  for (const auto& [name, depth] : { std::pair<const char*, double>{ "1e-6", 1e-6 },
         { "1e-3", 1e-3 }, { "1", 1.0 }, { "1e3", 1e3 }, { "1e6", 1e6 } })
  {
    HardCase& hard = group.add(std::string("one-tet-of-depth-") + name,
      std::string("a single tetrahedron, an edge of which has an optical depth of ") + name,
      [] { return singleTet(); });
    hard.SetOptics = [depth = depth](vtkVolumeProperty* property, vtkUnstructuredGrid*)
    {
      setStandardColours(property, { 0.0, 0.5 });
      vtkNew<vtkPiecewiseFunction> opacity;
      opacity->AddPoint(0.25, 1.0);
      property->SetScalarOpacity(opacity);
      property->SetScalarOpacityUnitDistance(1.0 / depth);
    };
  }
}

void addNodeRanges(CaseGroup& group)
{
  fills(group.add("no-nodes", "both transfer functions are empty", jitteredCube)).SetOptics =
    [](vtkVolumeProperty* property, vtkUnstructuredGrid* grid)
  {
    vtkNew<vtkColorTransferFunction> colours;
    vtkNew<vtkPiecewiseFunction> opacity;
    property->SetColor(colours);
    property->SetScalarOpacity(opacity);
    setDepthOfDiagonal(property, grid, 3.0);
  };
  addOpacity(
    group, "no-opacity-nodes", "the opacity function is empty", [](vtkPiecewiseFunction*) {});
  addColours(
    group, "no-colour-nodes", "the colour function is empty", [](vtkColorTransferFunction*) {});
  addOpacity(group, "nodes-beyond-data", "opacity nodes from -1000 to 1000, the data has 0..1",
    [](vtkPiecewiseFunction* opacity)
    {
      opacity->AddPoint(-1000.0, 0.0);
      opacity->AddPoint(-0.5, 1.0);
      opacity->AddPoint(0.6, 0.05);
      opacity->AddPoint(1000.0, 1.0);
    });
  addOpacity(group, "nodes-above-data", "opacity nodes at 2 and 3 only, clamped",
    [](vtkPiecewiseFunction* opacity)
    {
      opacity->AddPoint(2.0, 0.3);
      opacity->AddPoint(3.0, 0.9);
    });
  addOpacity(group, "nodes-inside-data-unclamped", "nodes at 0.4 and 0.6, nothing beyond them",
    [](vtkPiecewiseFunction* opacity)
    {
      opacity->ClampingOff();
      opacity->AddPoint(0.4, 0.9);
      opacity->AddPoint(0.6, 0.4);
    });
}

void addColourSpaces(CaseGroup& group)
{
  using Fill = std::function<void(vtkColorTransferFunction*)>;
  const auto withSpace = [](const Fill& setSpace, double low = 0.0)
  {
    return [=](vtkColorTransferFunction* colours)
    {
      setSpace(colours);
      colours->AddRGBPoint(low, 0.9, 0.0, 0.1);
      colours->AddRGBPoint(0.5, 0.2, 0.9, 0.3);
      colours->AddRGBPoint(1.0, 0.8, 0.1, 0.9);
    };
  };
  addColours(group, "colours-hsv", "colours in HSV, without passing red",
    withSpace(
      [](vtkColorTransferFunction* colours)
      {
        colours->SetColorSpaceToHSV();
        colours->HSVWrapOff();
      }));
  addColours(group, "colours-hsv-wrapped", "colours in HSV, by the shorter way",
    withSpace([](vtkColorTransferFunction* colours) { colours->SetColorSpaceToHSV(); }));
  addColours(group, "colours-lab", "colours in CIE Lab",
    withSpace([](vtkColorTransferFunction* colours) { colours->SetColorSpaceToLab(); }));
  addColours(group, "colours-diverging", "colours in VTK's diverging space",
    withSpace([](vtkColorTransferFunction* colours) { colours->SetColorSpaceToDiverging(); }));
  addColours(group, "colours-log", "colours over the logarithm of the scalar, from 1e-4 on",
    withSpace([](vtkColorTransferFunction* colours) { colours->SetScaleToLog10(); }, 1e-4));

  fills(group.add("gray", "a gray transfer function instead of colours", jitteredCube)).SetOptics =
    [](vtkVolumeProperty* property, vtkUnstructuredGrid* grid)
  {
    standardOpticsOver(Unit)(property, grid);
    vtkNew<vtkPiecewiseFunction> gray;
    gray->AddPoint(0.0, 0.1);
    gray->AddPoint(0.5, 1.0);
    gray->AddPoint(1.0, 0.3);
    property->SetColor(gray);
  };
}
} // namespace

void addTransferFunctionCases(std::vector<HardCase>& cases)
{
  CaseGroup group(cases, "optics");
  addJumps(group);
  addExtremes(group);
  addNodeRanges(group);
  addColourSpaces(group);
}
} // namespace tetmarch::testing
