// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/HigherOrderCheck.h"

#include "Input/GridVersions.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace tetmarch
{
namespace
{

using AxisDegrees = std::array<double, 3>;

// Far above the orders that VTK supports; keeps products exact.
constexpr double MostDegree = 1000;

bool isTetrahedron(int type)
{
  return type == VTK_LAGRANGE_TETRAHEDRON || type == VTK_BEZIER_TETRAHEDRON;
}
bool isBezier(int type) { return type >= VTK_BEZIER_CURVE && type <= VTK_BEZIER_PYRAMID; }

double pointsOf(int type, const AxisDegrees& n)
{
  if (isTetrahedron(type))
  {
    return (n[0] + 1) * (n[0] + 2) * (n[0] + 3) / 6;
  }
  return isHigherOrderWedge(type) ? (n[0] + 1) * (n[0] + 2) / 2 * (n[2] + 1)
                                  : (n[0] + 1) * (n[1] + 1) * (n[2] + 1);
}

// Cells with additional points in the centres of their faces or of the cell.
bool isSpecial(int type, vtkIdType points)
{
  return (isTetrahedron(type) && points == 15) || (isHigherOrderWedge(type) && points == 21);
}

// The least degree whose cell has that number of points or more.
double oneDegree(int type, vtkIdType points)
{
  double n = 1;
  while (n < MostDegree && pointsOf(type, { n, n, n }) < static_cast<double>(points))
  {
    ++n;
  }
  return n;
}

bool fitsOneDegree(int type, vtkIdType points)
{
  const double n = oneDegree(type, points);
  return pointsOf(type, { n, n, n }) == static_cast<double>(points);
}

bool fit(int type, const AxisDegrees& n, vtkIdType points)
{
  const bool whole = std::all_of(
    n.begin(), n.end(), [](double d) { return d >= 1 && d <= MostDegree && d == std::floor(d); });
  if (!whole || (isHigherOrderWedge(type) && n[0] != n[1]))
  {
    return false;
  }
  if (isSpecial(type, points))
  {
    return n == AxisDegrees{ { 2, 2, 2 } };
  }
  return pointsOf(type, n) == static_cast<double>(points);
}

std::string nameOf(vtkDataArray* array)
{
  return std::string("\"") + (array->GetName() ? array->GetName() : "") + "\"";
}

} // namespace

HigherOrderArrays::HigherOrderArrays(vtkUnstructuredGrid* grid)
  : Degrees(grid->GetCellData()->GetHigherOrderDegrees())
  , Weights(grid->GetPointData()->GetRationalWeights())
  , NumberOfPoints(grid->GetNumberOfPoints())
{
}

std::string HigherOrderArrays::errorOf(vtkIdType cell, int type, vtkIdType points) const
{
  if (!isTetrahedron(type) && !isHigherOrderWedge(type) && !isHigherOrderHexahedron(type))
  {
    return {};
  }
  const std::string which = "cell " + std::to_string(cell) + ", a " + nameOfCellType(type) +
                            " of " + std::to_string(points) + " points";
  if (isBezier(type) && this->Weights &&
      (this->Weights->GetNumberOfComponents() != 1 ||
        this->Weights->GetNumberOfTuples() < this->NumberOfPoints))
  {
    return "The rational weights " + nameOf(this->Weights) + " have " +
           std::to_string(this->Weights->GetNumberOfTuples()) + " tuples of " +
           std::to_string(this->Weights->GetNumberOfComponents()) + " components, but " + which +
           ", wants one value for each of the grid's " + std::to_string(this->NumberOfPoints) +
           " points.";
  }
  if (isTetrahedron(type) || !this->Degrees)
  {
    return isSpecial(type, points) || fitsOneDegree(type, points)
             ? ""
             : "The offsets give " + which + ", which is the number of no degree" +
                 (isTetrahedron(type) ? "." : "; set the higher order degrees of the cell data.");
  }
  if (this->Degrees->GetNumberOfComponents() != 3 || cell >= this->Degrees->GetNumberOfTuples())
  {
    return "The higher order degrees " + nameOf(this->Degrees) + " have " +
           std::to_string(this->Degrees->GetNumberOfTuples()) + " tuples of " +
           std::to_string(this->Degrees->GetNumberOfComponents()) + " components, but " + which +
           ", wants three degrees.";
  }
  AxisDegrees degrees;
  this->Degrees->GetTuple(cell, degrees.data());
  if (!fit(type, degrees, points))
  {
    std::ostringstream values;
    values << degrees[0] << ", " << degrees[1] << ", " << degrees[2];
    return "The higher order degrees " + nameOf(this->Degrees) + " are " + values.str() + " for " +
           which + ", which don't go together.";
  }
  return {};
}

CellDegrees HigherOrderArrays::degreesOf(vtkIdType cell, int type, vtkIdType points) const
{
  if (isSpecial(type, points))
  {
    return { { 0, 0, 0 } };
  }
  AxisDegrees degrees;
  degrees.fill(oneDegree(type, points));
  if (this->Degrees)
  {
    this->Degrees->GetTuple(cell, degrees.data());
  }
  return { { static_cast<int>(degrees[0]), static_cast<int>(degrees[1]),
    static_cast<int>(degrees[2]) } };
}

} // namespace tetmarch
