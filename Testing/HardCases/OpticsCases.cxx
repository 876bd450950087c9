// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Groups.h"

#include "Grids.h"
#include "Views.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <limits>

namespace tetmarch::testing
{
namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

using ValueOf = std::function<double(double f, vtkIdType i)>;
using SetOptics = std::function<void(vtkVolumeProperty*, vtkUnstructuredGrid*)>;

// The scalars of a data set replaced by others, of any type, from the values they had in 0..1.
void replaceScalars(vtkDataSetAttributes* data, int type, const ValueOf& valueOf)
{
  vtkDataArray* old = data->GetScalars();
  const vtkSmartPointer<vtkDataArray> made =
    vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  made->SetName(old->GetName());
  made->SetNumberOfTuples(old->GetNumberOfTuples());
  for (vtkIdType i = 0; i < old->GetNumberOfTuples(); ++i)
  {
    made->SetComponent(i, 0, valueOf(old->GetComponent(i, 0), i));
  }
  data->SetScalars(made);
}

Grid cube() { return jitteredLattice(5, 0.15, 3, sineField()); }

HardCase scalarCase(
  const std::string& name, const std::string& what, const ValueOf& valueOf, int type = VTK_DOUBLE)
{
  HardCase hard;
  hard.Name = name;
  hard.Group = "optics";
  hard.What = what;
  hard.Make = [=]
  {
    const Grid grid = cube();
    replaceScalars(grid->GetPointData(), type, valueOf);
    replaceScalars(grid->GetCellData(), type, valueOf);
    return grid;
  };
  hard.Known = Answer::Box;
  hard.ExactBox = { { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } };
  return hard;
}

HardCase opticsCase(const std::string& name, const std::string& what, const SetOptics& setOptics)
{
  HardCase hard = scalarCase(name, what, [](double f, vtkIdType) { return f; });
  hard.SetOptics = setOptics;
  return hard;
}

// Nodes x, opacity; the colours of the standard optics.
SetOptics opacityNodes(const std::vector<std::array<double, 2>>& nodes, double unitDistance = 0.25)
{
  return [=](vtkVolumeProperty* property, vtkUnstructuredGrid* grid)
  {
    setStandardOptics(property, grid);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AllowDuplicateScalarsOn();
    for (const auto& node : nodes)
    {
      opacity->AddPoint(node[0], node[1]);
    }
    property->SetScalarOpacity(opacity);
    property->SetScalarOpacityUnitDistance(unitDistance);
  };
}

// The same functions over 0..1, whatever the data.
void setUnitOptics(vtkVolumeProperty* property, vtkUnstructuredGrid*)
{
  setStandardOptics(property, cube());
}

void addScalarCases(HardCases& cases)
{
  cases.push_back(scalarCase("nan-some", "every 7th value is NaN",
    [](double f, vtkIdType i) { return i % 7 == 0 ? NaN : f; }));
  cases.push_back(scalarCase("infinite-some", "every 11th value is infinite, of either sign",
    [](double f, vtkIdType i) { return i % 11 == 0 ? (i % 2 ? Infinity : -Infinity) : f; }));
  cases.push_back(
    scalarCase("nan-all", "every value is NaN", [](double, vtkIdType) { return NaN; }));
  cases.push_back(scalarCase(
    "infinite-all", "every value is infinite", [](double, vtkIdType) { return Infinity; }));
  cases.push_back(
    scalarCase("constant", "every value is 0.7", [](double, vtkIdType) { return 0.7; }));
  cases.push_back(scalarCase("nearly-constant", "values of 1000 that differ by 1e-7 of that",
    [](double f, vtkIdType) { return 1000.0 * (1.0 + 1e-7 * f); }));
  cases.push_back(scalarCase(
    "values-1e30", "values of 1e30", [](double f, vtkIdType) { return 1e30 * (1.0 + f); }));
  cases.push_back(
    scalarCase("values-1e-30", "values of 1e-30", [](double f, vtkIdType) { return 1e-30 * f; }));
  cases.push_back(
    scalarCase("values-1e300", "values of 1e300 of both signs, whose range leaves double",
      [](double f, vtkIdType) { return 1.7e308 * (2.0 * f - 1.0); }));
  cases.push_back(scalarCase("outlier-1e30", "one value of 1e30 among values of 0..1",
    [](double f, vtkIdType i) { return i == 100 ? 1e30 : f; }));
  cases.back().SetOptics = setUnitOptics;
  cases.push_back(scalarCase("cell-scalars-nan", "cell values, every 7th NaN",
    [](double f, vtkIdType i) { return i % 7 == 0 ? NaN : f; }));
  cases.back().CellScalars = true;
}

void addIntegerCases(HardCases& cases)
{
  const auto integers = [](double low, double high)
  { return [=](double f, vtkIdType) { return std::floor(low + f * (high - low)); }; };
  struct Row
  {
    const char* Name;
    int Type;
    double Low, High;
  };
  for (const Row& row :
    { Row{ "char", VTK_CHAR, 0, 127 }, Row{ "signed-char", VTK_SIGNED_CHAR, -128, 127 },
      Row{ "unsigned-char", VTK_UNSIGNED_CHAR, 0, 255 }, Row{ "short", VTK_SHORT, -32768, 32767 },
      Row{ "unsigned-short", VTK_UNSIGNED_SHORT, 0, 65535 },
      Row{ "int", VTK_INT, -2147483648.0, 2147483647.0 },
      Row{ "unsigned-int", VTK_UNSIGNED_INT, 0, 4294967295.0 },
      Row{ "long", VTK_LONG, -9e18, 9e18 }, Row{ "unsigned-long", VTK_UNSIGNED_LONG, 0, 1.8e19 },
      Row{ "long-long", VTK_LONG_LONG, 4.5e15, 4.5e15 + 4096 },
      Row{ "unsigned-long-long", VTK_UNSIGNED_LONG_LONG, 0, 1.8e19 },
      Row{ "id-type", VTK_ID_TYPE, -9e18, 9e18 }, Row{ "float", VTK_FLOAT, 0, 1000 } })
  {
    cases.push_back(scalarCase(std::string("type-") + row.Name,
      std::string("scalars of the type ") + vtkImageScalarTypeNameMacro(row.Type),
      integers(row.Low, row.High), row.Type));
    cases.back().CellScalars = row.Type == VTK_SHORT;
  }
}

void addFunctionCases(HardCases& cases)
{
  cases.push_back(opticsCase("steps", "opacity in steps",
    opacityNodes({ { 0.0, 0.0 }, { 0.3, 0.0 }, { 0.3, 0.6 }, { 0.5, 0.6 }, { 0.5, 0.1 },
      { 0.8, 0.1 }, { 0.8, 1.0 }, { 1.0, 1.0 } })));
  cases.push_back(opticsCase("spikes-one-entry", "opaque spikes as wide as one entry of the table",
    opacityNodes({ { 0.0, 0.0 }, { 0.3, 0.0 }, { 0.3005, 1.0 }, { 0.301, 0.0 }, { 0.6, 0.0 },
                   { 0.6005, 1.0 }, { 0.601, 0.0 }, { 1.0, 0.0 } },
      0.01)));
  cases.push_back(opticsCase("spike-zero-width", "a spike without width: nothing to see",
    opacityNodes({ { 0.0, 0.0 }, { 0.5, 0.0 }, { 0.5, 1.0 }, { 0.5, 0.0 }, { 1.0, 0.0 } })));
  cases.push_back(opticsCase("sharp-midpoints", "nodes with midpoints and sharpness",
    [](vtkVolumeProperty* property, vtkUnstructuredGrid* grid)
    {
      setStandardOptics(property, grid);
      vtkNew<vtkPiecewiseFunction> opacity;
      opacity->AddPoint(0.0, 0.0, 0.2, 1.0);
      opacity->AddPoint(0.4, 0.9, 0.99, 0.3);
      opacity->AddPoint(0.6, 0.1, 0.0, 0.99);
      opacity->AddPoint(1.0, 0.8);
      property->SetScalarOpacity(opacity);
    }));
  cases.push_back(
    opticsCase("opacity-0", "opacity 0 everywhere", opacityNodes({ { 0.0, 0.0 }, { 1.0, 0.0 } })));
  cases.push_back(
    opticsCase("opacity-1", "opacity 1 everywhere", opacityNodes({ { 0.0, 1.0 }, { 1.0, 1.0 } })));
  cases.push_back(opticsCase("unit-distance-1e-9", "opaque within 1e-9 mesh sizes",
    opacityNodes({ { 0.0, 0.0 }, { 0.4, 0.0 }, { 0.5, 1.0 }, { 1.0, 1.0 } }, 1e-9)));
  cases.push_back(
    opticsCase("unit-distance-1e9", "a billion mesh sizes until opaque: nothing to see",
      opacityNodes({ { 0.0, 0.2 }, { 1.0, 1.0 } }, 1e9)));
  cases.push_back(opticsCase("unit-distance-1e-30", "opaque within 1e-30 mesh sizes",
    opacityNodes({ { 0.0, 0.0 }, { 0.4, 0.0 }, { 0.5, 1.0 }, { 1.0, 1.0 } }, 1e-30)));
  cases.push_back(opticsCase("empty-functions", "transfer functions without a node",
    [](vtkVolumeProperty* property, vtkUnstructuredGrid*)
    {
      vtkNew<vtkPiecewiseFunction> opacity;
      vtkNew<vtkColorTransferFunction> colour;
      property->SetScalarOpacity(opacity);
      property->SetColor(colour);
    }));
  cases.push_back(opticsCase("one-node", "transfer functions of one node",
    [](vtkVolumeProperty* property, vtkUnstructuredGrid*)
    {
      vtkNew<vtkPiecewiseFunction> opacity;
      opacity->AddPoint(0.4, 0.3);
      vtkNew<vtkColorTransferFunction> colour;
      colour->AddRGBPoint(0.4, 0.9, 0.5, 0.1);
      property->SetScalarOpacity(opacity);
      property->SetColor(colour);
      property->SetScalarOpacityUnitDistance(0.25);
    }));
  cases.push_back(opticsCase("nodes-beyond-data", "nodes from -1e6 to 1e6 around data of 0..1",
    opacityNodes({ { -1e6, 0.0 }, { 0.2, 0.1 }, { 0.6, 0.9 }, { 1e6, 0.2 } })));
  cases.push_back(opticsCase("clamping-off", "functions that end within the data, without clamping",
    [](vtkVolumeProperty* property, vtkUnstructuredGrid*)
    {
      vtkNew<vtkPiecewiseFunction> opacity;
      opacity->AddPoint(0.3, 0.8);
      opacity->AddPoint(0.7, 0.8);
      opacity->ClampingOff();
      vtkNew<vtkColorTransferFunction> colour;
      colour->AddRGBPoint(0.3, 1.0, 0.5, 0.1);
      colour->AddRGBPoint(0.7, 0.1, 0.5, 1.0);
      colour->ClampingOff();
      property->SetScalarOpacity(opacity);
      property->SetColor(colour);
      property->SetScalarOpacityUnitDistance(0.25);
    }));
  const auto inSpace = [&](
                         const char* name, const char* what, void (*set)(vtkColorTransferFunction*))
  {
    cases.push_back(opticsCase(name, what,
      [set](vtkVolumeProperty* property, vtkUnstructuredGrid* grid)
      {
        setStandardOptics(property, grid);
        vtkNew<vtkColorTransferFunction> colour;
        set(colour);
        colour->AddRGBPoint(0.01, 0.9, 0.1, 0.2);
        colour->AddRGBPoint(0.5, 0.1, 0.9, 0.8);
        colour->AddRGBPoint(1.0, 0.8, 0.2, 0.9);
        property->SetColor(colour);
      }));
  };
  inSpace("colour-hsv", "colours interpolated in HSV",
    [](vtkColorTransferFunction* f) { f->SetColorSpaceToHSV(); });
  inSpace("colour-lab", "colours interpolated in Lab",
    [](vtkColorTransferFunction* f) { f->SetColorSpaceToLab(); });
  inSpace("colour-diverging", "colours that diverge",
    [](vtkColorTransferFunction* f) { f->SetColorSpaceToDiverging(); });
  inSpace("colour-log", "colours on a logarithmic scale",
    [](vtkColorTransferFunction* f) { f->SetScaleToLog10(); });
  cases.push_back(opticsCase("gray", "a gray function instead of colours",
    [](vtkVolumeProperty* property, vtkUnstructuredGrid* grid)
    {
      setStandardOptics(property, grid);
      vtkNew<vtkPiecewiseFunction> gray;
      gray->AddPoint(0.0, 0.1);
      gray->AddPoint(1.0, 0.9);
      property->SetColor(gray);
    }));
}

void addThickCells(HardCases& cases)
{
  for (int exponent = -6; exponent <= 6; exponent += 2)
  {
    HardCase hard;
    hard.Name = "one-cell-depth-1e" + std::to_string(exponent);
    hard.Group = "optics";
    hard.What = "one tetrahedron of optical depth 1e" + std::to_string(exponent) +
                ", colours and opacity from 0 to 1 in it";
    hard.Make = [] { return singleTet(); };
    hard.SetOptics = [=](vtkVolumeProperty* property, vtkUnstructuredGrid* grid)
    {
      setStandardOptics(property, grid);
      property->SetScalarOpacityUnitDistance(std::pow(10.0, -exponent));
    };
    cases.push_back(hard);
  }
}
} // namespace

void addOpticsCases(HardCases& cases)
{
  addScalarCases(cases);
  addIntegerCases(cases);
  addFunctionCases(cases);
  addThickCells(cases);
}
} // namespace tetmarch::testing
