// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/GridGeometry.h"

#include "Input/PointCheck.h"
#include "Input/PreciseSum.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkRectilinearGrid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tetmarch
{
namespace
{

// The volume of the parallelepiped of unit vectors along the axes of an image: 1 if they are
// perpendicular.
constexpr double LeastBox = 1e-9;

bool isFinite(const Vector3& v)
{
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

double lengthOf(const Vector3& v) { return std::hypot(v[0], v[1], v[2]); }

std::array<Vector3, 3> directionsOf(const GridGeometry& geometry)
{
  std::array<Vector3, 3> directions;
  for (int a = 0; a < 3; ++a)
  {
    directions[a] = scaled(1 / lengthOf(geometry.Steps[a]), geometry.Steps[a]);
  }
  return directions;
}

double boxOf(const std::array<Vector3, 3>& directions)
{
  return dot(directions[0], cross(directions[1], directions[2]));
}

// Reads the number of points. Returns an error if there are some, but too few.
std::string readPoints(const char* what, const int extent[6], GridGeometry& geometry)
{
  for (int a = 0; a < 3; ++a)
  {
    geometry.First[a] = extent[2 * a];
    const std::int64_t count = std::int64_t(extent[2 * a + 1]) - extent[2 * a] + 1;
    geometry.Points[a] = static_cast<int>(std::min<std::int64_t>(count, VTK_INT_MAX));
  }
  const std::array<int, 3>& points = geometry.Points;
  if (geometry.isEmpty() || *std::min_element(points.begin(), points.end()) >= 2)
  {
    return {};
  }
  return std::string("The ") + what + " has " + std::to_string(points[0]) + " x " +
         std::to_string(points[1]) + " x " + std::to_string(points[2]) +
         " points, but a volume has at least 2 along each axis. Draw a slice with vtkImageSlice or "
         "as a surface, or repeat it along the axis that has 1.";
}

std::string readImage(vtkImageData* image, GridGeometry& geometry)
{
  const std::string thin = readPoints("image", image->GetExtent(), geometry);
  if (geometry.isEmpty() || !thin.empty())
  {
    return thin;
  }
  const double* spacing = image->GetSpacing();
  for (int a = 0; a < 3; ++a)
  {
    if (!std::isfinite(spacing[a]) || spacing[a] == 0)
    {
      return "The image's spacing along axis " + std::to_string(a) + " is " +
             std::to_string(spacing[a]) + ". Set one that is finite and not 0.";
    }
  }
  const vtkMatrix4x4* matrix = image->GetIndexToPhysicalMatrix();
  for (int k = 0; k < 3; ++k)
  {
    geometry.Origin[k] = matrix->GetElement(k, 3);
    for (int a = 0; a < 3; ++a)
    {
      geometry.Steps[a][k] = matrix->GetElement(k, a);
    }
  }
  if (!isFinite(geometry.Origin))
  {
    return "The image's origin is not finite. Set one that is.";
  }
  const bool finite = std::all_of(geometry.Steps.begin(), geometry.Steps.end(), isFinite);
  if (!finite || !(std::abs(boxOf(directionsOf(geometry))) >= LeastBox))
  {
    return "The image's direction matrix is singular or not finite: its axes span no volume. Set "
           "one whose columns are independent.";
  }
  return {};
}

std::string checkCoordinates(const char* name, const std::vector<double>& coordinates)
{
  const std::string begin = std::string("The rectilinear grid's ") + name + " coordinate ";
  const auto valueAt = [&](std::size_t i)
  { return "number " + std::to_string(i) + " is " + std::to_string(coordinates[i]); };
  const bool ascends = coordinates.back() > coordinates.front();
  for (std::size_t i = 0; i < coordinates.size(); ++i)
  {
    if (!std::isfinite(coordinates[i]))
    {
      return begin + valueAt(i) + ". Set one that is finite.";
    }
    if (i > 0 &&
        !(ascends ? coordinates[i] > coordinates[i - 1] : coordinates[i] < coordinates[i - 1]))
    {
      return begin + valueAt(i) + ", but " + valueAt(i - 1) +
             ". Coordinates must ascend or descend from each to the next one: sort them with their "
             "values, and leave out those that repeat.";
    }
  }
  return {};
}

std::string readRectilinear(vtkRectilinearGrid* grid, GridGeometry& geometry)
{
  const std::string thin = readPoints("rectilinear grid", grid->GetExtent(), geometry);
  if (geometry.isEmpty() || !thin.empty())
  {
    return thin;
  }
  constexpr const char* Names[] = { "x", "y", "z" };
  vtkDataArray* arrays[] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
    grid->GetZCoordinates() };
  for (int a = 0; a < 3; ++a)
  {
    const vtkIdType count = arrays[a] ? arrays[a]->GetNumberOfTuples() : 0;
    if (count != geometry.Points[a])
    {
      return std::string("The rectilinear grid has ") + std::to_string(count) + " " + Names[a] +
             " coordinates, but " + std::to_string(geometry.Points[a]) +
             " points along that axis. Set as many as its dimensions say.";
    }
    std::vector<double>& coordinates = geometry.Coordinates[a];
    coordinates.resize(static_cast<std::size_t>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      coordinates[i] = arrays[a]->GetComponent(i, 0);
    }
    const std::string wrong = checkCoordinates(Names[a], coordinates);
    if (!wrong.empty())
    {
      return wrong;
    }
  }
  return {};
}

} // namespace

bool GridGeometry::operator==(const GridGeometry& other) const
{
  return this->Points == other.Points && this->Coordinates == other.Coordinates &&
         this->First == other.First && this->Origin == other.Origin && this->Steps == other.Steps;
}

Vector3 GridGeometry::point(const std::array<int, 3>& numbers) const
{
  Vector3 point = this->Origin;
  for (int a = 0; a < 3; ++a)
  {
    if (this->isRectilinear())
    {
      point[a] = this->Coordinates[a][numbers[a]];
    }
    else
    {
      add(double(this->First[a]) + numbers[a], this->Steps[a], point);
    }
  }
  return point;
}

std::string readGeometry(vtkDataSet* data, GridGeometry& geometry)
{
  geometry = {};
  if (!data)
  {
    return {};
  }
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    return readImage(image, geometry);
  }
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    return readRectilinear(grid, geometry);
  }
  return std::string("A ") + data->GetClassName() +
         " is neither a vtkImageData nor a vtkRectilinearGrid. Resample it to an image "
         "(vtkResampleToImage), or draw it with vtkTetMarchVolumeMapper.";
}

std::string findFrame(const GridGeometry& geometry, VolumeFrame& frame)
{
  std::vector<Vector3> corners;
  for (int c = 0; c < 8; ++c)
  {
    std::array<int, 3> numbers;
    for (int a = 0; a < 3; ++a)
    {
      numbers[a] = (c >> a & 1) != 0 ? geometry.Points[a] - 1 : 0;
    }
    corners.push_back(geometry.point(numbers));
  }
  const std::string wrong = findFrame(corners, frame);
  if (!wrong.empty())
  {
    return wrong;
  }
  const auto isNear = [](const Vector3& p)
  { return isSound(p[0]) && isSound(p[1]) && isSound(p[2]); };
  if (!std::all_of(corners.begin(), corners.end(), isNear))
  {
    return "The grid is larger than double precision can tell: coordinates must be within 1e100 of "
           "0. Scale it.";
  }
  return {};
}

std::array<double, 12> latticeFromNormalized(const GridGeometry& geometry, const VolumeFrame& frame)
{
  std::array<double, 12> matrix{};
  if (geometry.isRectilinear())
  {
    for (int a = 0; a < 3; ++a)
    {
      const double first = geometry.Coordinates[a].front();
      const double last = geometry.Coordinates[a].back();
      const double mean = (last - first) / (geometry.Points[a] - 1);
      matrix[5 * a] = frame.Radius / mean; // of the diagonal
      matrix[4 * a + 3] = 0.5 * ((frame.Center[a] - first) + (frame.Center[a] - last)) / mean;
    }
    return matrix;
  }
  // From the middle of the lattice to the centre of the frame: a small difference of possibly large
  // numbers.
  Vector3 shift;
  for (int k = 0; k < 3; ++k)
  {
    PreciseSum sum;
    sum.add(frame.Center[k]);
    sum.add(-geometry.Origin[k]);
    for (int a = 0; a < 3; ++a)
    {
      sum.addProduct(-(geometry.First[a] + 0.5 * (geometry.Points[a] - 1)), geometry.Steps[a][k]);
    }
    shift[k] = sum.value();
  }
  // The inverse by Cramer's rule, of unit vectors, whose products neither overflow nor vanish.
  const std::array<Vector3, 3> directions = directionsOf(geometry);
  const double box = boxOf(directions);
  for (int a = 0; a < 3; ++a)
  {
    const Vector3 row = scaled(1 / box, cross(directions[(a + 1) % 3], directions[(a + 2) % 3]));
    const double length = lengthOf(geometry.Steps[a]);
    for (int k = 0; k < 3; ++k)
    {
      matrix[4 * a + k] = row[k] * (frame.Radius / length);
    }
    matrix[4 * a + 3] = dot(row, shift) / length;
  }
  return matrix;
}

double latticePlace(const GridGeometry& geometry, int axis, int number)
{
  const int last = geometry.Points[axis] - 1;
  if (!geometry.isRectilinear())
  {
    return number - 0.5 * last;
  }
  const std::vector<double>& places = geometry.Coordinates[axis];
  const double mean = (places.back() - places.front()) / last;
  return 0.5 * ((places[number] - places.front()) + (places[number] - places.back())) / mean;
}

} // namespace tetmarch
