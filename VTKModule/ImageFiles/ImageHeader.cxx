// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageFiles/ImageHeader.h"

#include "ImageFiles/HeaderText.h"
#include "ImageFiles/MetaImageHeader.h"
#include "ImageFiles/NrrdHeader.h"

#include "vtkAbstractArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetmarch
{
namespace
{

// The volume of the parallelepiped of unit vectors along the axes: 1 if they are perpendicular.
constexpr double LeastBox = 1e-9;

ImageVector cross(const ImageVector& a, const ImageVector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

double dot(const ImageVector& a, const ImageVector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// A unit vector perpendicular to the given ones.
ImageVector across(const std::vector<ImageVector>& directions)
{
  if (directions.size() == 2)
  {
    ImageVector normal = cross(directions[0], directions[1]);
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    for (double& coordinate : normal)
    {
      coordinate /= length;
    }
    return normal;
  }
  const ImageVector& d = directions[0];
  const int least = std::abs(d[0]) < std::abs(d[1]) ? (std::abs(d[0]) < std::abs(d[2]) ? 0 : 2)
                                                    : (std::abs(d[1]) < std::abs(d[2]) ? 1 : 2);
  ImageVector axis{};
  axis[least] = 1;
  return across({ d, axis });
}

} // namespace

void setDimensions(ImageHeader& header, const std::vector<std::int64_t>& sizes)
{
  for (std::size_t axis = 0; axis < sizes.size(); ++axis)
  {
    if (sizes[axis] < 1 || sizes[axis] >= std::numeric_limits<int>::max())
    {
      throw ImageFileError("its header says that an axis has " + std::to_string(sizes[axis]) +
                           " values, but one has 1 to 2147483646");
    }
    header.Dimensions[axis] = static_cast<int>(sizes[axis]);
  }
}

void setSteps(ImageHeader& header, std::vector<ImageVector> steps)
{
  for (std::size_t axis = 0; axis < steps.size(); ++axis)
  {
    ImageVector& step = steps[axis];
    const double length = std::hypot(step[0], step[1], step[2]);
    if (!std::isfinite(length) || !(length > 0))
    {
      throw ImageFileError("its header says that the spacing along axis " + std::to_string(axis) +
                           " is " + std::to_string(length) + "; it must be finite and not 0");
    }
    header.Spacing[axis] = length;
    for (double& coordinate : step)
    {
      coordinate /= length;
    }
  }
  while (steps.size() < 3)
  {
    steps.push_back(across(steps));
  }
  if (!(std::abs(dot(steps[0], cross(steps[1], steps[2]))) > LeastBox))
  {
    throw ImageFileError("the directions of axes in its header lie in one plane");
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int k = 0; k < 3; ++k)
    {
      header.Direction[3 * k + axis] = steps[axis][k] + 0.0; // no -0
    }
  }
}

std::uint64_t countOf(const ImageHeader& header)
{
  return static_cast<std::uint64_t>(header.Dimensions[0]) * header.Dimensions[1] *
         header.Dimensions[2] * header.Components;
}

std::uint64_t bytesOf(const ImageHeader& header)
{
  return countOf(header) * vtkAbstractArray::GetDataTypeSize(header.Type);
}

void checkCount(const ImageHeader& header)
{
  double bytes = vtkAbstractArray::GetDataTypeSize(header.Type);
  for (const int factor :
    { header.Dimensions[0], header.Dimensions[1], header.Dimensions[2], header.Components })
  {
    bytes *= factor;
  }
  if (!(bytes < 0x1p62))
  {
    throw ImageFileError("its header says that it has more values than can be counted");
  }
}

ImageHeader readImageHeader(const std::string& path)
{
  const std::string ending = lowered(path.substr(std::min(path.rfind('.'), path.size())));
  const bool nrrd = ending == ".nrrd" || ending == ".nhdr";
  return nrrd ? readNrrdHeader(path) : readMetaImageHeader(path);
}

} // namespace tetmarch
