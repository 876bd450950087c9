// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UnsoundData.h"

#include "Grids.h"
#include "RawGrid.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <functional>
#include <limits>

namespace tetmarch::testing
{
namespace
{
constexpr int Points = 6; // along each axis of structured data
const double Infinity = std::numeric_limits<double>::infinity();
const double NotANumber = std::numeric_limits<double>::quiet_NaN();

using Words = std::vector<std::string>;
using List = std::vector<UnsoundData>;

/// The numbers of the points, or of as many as there are tuples.
template <typename Data>
vtkSmartPointer<Data> withArray(vtkSmartPointer<Data> data, vtkIdType tuples = -1)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("f");
  array->SetNumberOfTuples(tuples < 0 ? data->GetNumberOfPoints() : tuples);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    array->SetValue(i, static_cast<double>(i));
  }
  data->GetPointData()->SetScalars(array);
  return data;
}

vtkSmartPointer<vtkImageData> image()
{
  auto data = vtkSmartPointer<vtkImageData>::New();
  data->SetDimensions(Points, Points, Points);
  return data;
}

vtkSmartPointer<vtkRectilinearGrid> rectilinear(const std::vector<double>& x)
{
  auto data = vtkSmartPointer<vtkRectilinearGrid>::New();
  data->SetDimensions(Points, Points, Points);
  vtkNew<vtkDoubleArray> even;
  for (int i = 0; i < Points; ++i)
  {
    even->InsertNextValue(i);
  }
  data->SetXCoordinates(arrayOf<vtkDoubleArray>(x));
  data->SetYCoordinates(even);
  data->SetZCoordinates(even);
  return data;
}

/// With another coordinate x of the point with this number, and without points from another one on.
vtkSmartPointer<vtkStructuredGrid> curvilinear(
  vtkIdType changed = -1, double x = 0, vtkIdType count = Points * Points * Points)
{
  auto data = vtkSmartPointer<vtkStructuredGrid>::New();
  data->SetDimensions(Points, Points, Points);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double across = static_cast<double>(i % Points);
    points->InsertNextPoint(
      i == changed ? x : across, 1.5 * double(i / Points % Points), double(i / Points / Points));
  }
  data->SetPoints(points);
  return data;
}

void addGrid(List& list, const char* name, vtkUnstructuredGrid* sound,
  const std::function<void(RawGrid&)>& damage, const Words& words)
{
  RawGrid raw(sound);
  damage(raw);
  list.push_back({ name, withArray(raw.grid()), words });
}

void addGrids(List& list)
{
  const auto add = [&list](const char* name, auto damage, const Words& words)
  { addGrid(list, name, hexLattice(2), damage, words); };
  add("a point that is not there", [](RawGrid& raw) { raw.Connectivity[9] = 1000000000; },
    { "The connectivity of cell 1 names point 1000000000", "27 points" });
  add("a point with a negative number", [](RawGrid& raw) { raw.Connectivity[0] = -1; },
    { "The connectivity of cell 0 names point -1" });
  add("offsets that fall", [](RawGrid& raw) { raw.Offsets[2] = 4; },
    { "cell 1 begin at 8 and end at 4" });
  add("offsets beyond the connectivity", [](RawGrid& raw) { raw.Offsets.back() = 4000000; },
    { "cell 7", "4000000", "64 values" });
  add("a type that is none", [](RawGrid& raw) { raw.Types[3] = 200; },
    { "The cell types say 200 of cell 3" });
  add("fewer types than cells", [](RawGrid& raw) { raw.Types.resize(3); },
    { "8 cells but 3 cell types" });
  add(
    "a hexahedron of 7 points", [](RawGrid& raw) { raw.Offsets[1] = 7; }, { "7 points", "have 8" });
  add("a point that is not a number", [](RawGrid& raw) { raw.Points[1] = NotANumber; },
    { "Coordinate 1 of point 0, which cell 0 has, is nan" });
  add("a point at 1e145", [](RawGrid& raw) { raw.Points[3] = 1e145; },
    { "Coordinate 0 of point 1", "1e+145, which is larger than 1e100" });
  addGrid(list, "a face with a point that is not there", polyhedronLattice(2),
    [](RawGrid& raw) { raw.Faces.faceArrays().back()->back() = 1000000000; },
    { "point 1000000000" });
}

void addLattices(List& list)
{
  const auto directed = [](double first)
  {
    auto data = image();
    data->SetDirectionMatrix(first, 0, 0, 0, 1, 0, 0, 0, 1);
    return withArray(data);
  };
  list.push_back(
    { "an image's direction of -1e308", directed(-1e308), { "larger than", "1e100" } });
  list.push_back({ "an image's direction of 0", directed(0), { "direction matrix is singular" } });
  auto wide = image();
  wide->SetSpacing(1e99, 1e99, 1e120);
  list.push_back({ "an image of 1e120", withArray(wide), { "larger than", "Scale it" } });
  auto nowhere = image();
  nowhere->SetOrigin(0, NotANumber, 0);
  list.push_back({ "an image's origin", withArray(nowhere), { "origin is not finite" } });
  list.push_back({ "an infinite coordinate", withArray(rectilinear({ 0, 1, 2, 3, 4, Infinity })),
    { "x coordinate number 5 is inf" } });
  list.push_back({ "fewer coordinates than points", withArray(rectilinear({ 0, 1 })),
    { "2 x coordinates, but 6 points" } });
  list.push_back({ "coordinates that fall", withArray(rectilinear({ 0, 1, 2, 1, 4, 5 })),
    { "x coordinate number 3 is 1", "sort them" } });
}

void addCurvilinear(List& list)
{
  list.push_back(
    { "a curvilinear grid with an infinite point", withArray(curvilinear(77, Infinity)),
      { "Coordinate 0 of point 77, which cell 54 has, is inf" } });
  list.push_back({ "a curvilinear grid with its last point at 1e200",
    withArray(curvilinear(215, 1e200)), { "point 215, which cell 124 has", "1e+200" } });
  list.push_back({ "a curvilinear grid of 40 points", withArray(curvilinear(-1, 0, 40)),
    { "40 points", "6 x 6 x 6 call for 216" } });
}

void addGhosts(List& list)
{
  for (const bool ofCells : { false, true })
  {
    auto data = withArray(curvilinear());
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfValues(5);
    ghosts->Fill(0);
    ofCells ? data->GetCellData()->AddArray(ghosts) : data->GetPointData()->AddArray(ghosts);
    list.push_back({ ofCells ? "five ghost cells" : "five ghost points", data,
      { "\"vtkGhostType\" has 5 tuples", ofCells ? "125 cells" : "216 points" } });
  }
}
} // namespace

std::vector<UnsoundData> unsoundGeometries()
{
  List list;
  addGrids(list);
  addLattices(list);
  addCurvilinear(list);
  addGhosts(list);
  return list;
}

std::vector<UnsoundData> unsoundArrays()
{
  List list;
  for (const vtkIdType tuples : { 0, 1, 5, 1000 })
  {
    for (const auto& data : soundData())
    {
      withArray(data, tuples);
      list.push_back({ std::string(data->GetClassName()) + " with " + std::to_string(tuples), data,
        { "\"f\" has " + std::to_string(tuples) + " tuples, but the grid has " +
          std::to_string(data->GetNumberOfPoints()) + " points" } });
    }
  }
  return list;
}

std::vector<vtkSmartPointer<vtkDataSet>> soundData()
{
  return { withArray(hexLattice(2)), withArray(polyhedronLattice(2)), withArray(image()),
    withArray(rectilinear({ 0, 1, 2, 3, 4, 5 })), withArray(curvilinear()) };
}
} // namespace tetmarch::testing
