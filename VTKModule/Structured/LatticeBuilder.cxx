// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Structured/LatticeBuilder.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace tetmarch
{
namespace
{

// Along an axis of N points and C = N - 1 cells of the data:
//
//   values of  interpolation  cells     values  first value  planes at
//   points     linear         C         N       0            points
//   points     nearest        N         N       0            first point, centres, last point
//   cells      nearest        C         C       0            points
//   cells      linear         C + 1     C       -1           first point, centres, last point
//
// Linear cell values, as in VTK, are interpolated between centres, and are constant in the outer
// half cells.
LatticeAxis axisOf(int points, const LatticeCase& lies)
{
  const bool linear = lies.Between == Interpolation::Linear;
  LatticeAxis axis;
  axis.Cells = lies.isShifted() ? points : points - 1;
  axis.Values = lies.OfCells ? points - 1 : points;
  axis.FirstValue = lies.OfCells && linear ? -1 : 0;
  axis.HalfLength = 0.5 * (points - 1);
  axis.Shift = -axis.HalfLength - (lies.isShifted() ? 0.5 : 0.0);
  return axis;
}

std::vector<float> planesOf(const GridGeometry& geometry, int axis, const LatticeCase& lies)
{
  const int last = geometry.Points[axis] - 1;
  const auto place = [&](int number) { return latticePlace(geometry, axis, number); };
  std::vector<float> planes{ static_cast<float>(-0.5 * last) };
  for (int i = 1; i <= last; ++i)
  {
    if (lies.isShifted())
    {
      planes.push_back(static_cast<float>(0.5 * (place(i - 1) + place(i))));
    }
    else if (i < last)
    {
      planes.push_back(static_cast<float>(place(i)));
    }
  }
  planes.push_back(static_cast<float>(0.5 * last));
  return planes;
}

std::string checkPlanes(const char* name, const LatticeAxis& axis)
{
  for (std::size_t i = 1; i < axis.Planes.size(); ++i)
  {
    if (!(axis.Planes[i] > axis.Planes[i - 1]))
    {
      return std::string("The rectilinear grid's ") + name +
             " coordinates lie too close to each other for single precision near number " +
             std::to_string(i) + ". Leave out some there, or extract a part of the grid.";
    }
  }
  return {};
}

std::string checkNumber(const Lattice& lattice)
{
  // 64-bit integers might overflow.
  const double cells =
    double(lattice.Axes[0].Cells) * lattice.Axes[1].Cells * lattice.Axes[2].Cells;
  if (cells <= double(std::numeric_limits<std::uint32_t>::max()))
  {
    return {};
  }
  return "The volume has " + std::to_string(lattice.Axes[0].Cells) + " x " +
         std::to_string(lattice.Axes[1].Cells) + " x " + std::to_string(lattice.Axes[2].Cells) +
         " cells, but at most 4294967295 can be numbered. Extract or coarsen a part of it.";
}

} // namespace

std::string makeLattice(
  const GridGeometry& geometry, const VolumeFrame& frame, const LatticeCase& lies, Lattice& lattice)
{
  constexpr const char* Names[] = { "x", "y", "z" };
  Lattice made;
  for (int a = 0; a < 3; ++a)
  {
    made.Axes[a] = axisOf(geometry.Points[a], lies);
    if (geometry.isRectilinear())
    {
      made.Axes[a].Planes = planesOf(geometry, a, lies);
      const std::string wrong = checkPlanes(Names[a], made.Axes[a]);
      if (!wrong.empty())
      {
        return wrong;
      }
    }
    made.Axes[a].Values = lies.isOfLeaves() ? lies.ValuesOfLeaves[a] : made.Axes[a].Values;
  }
  const std::string wrong = lies.isOfLeaves() ? std::string() : checkNumber(made);
  if (!wrong.empty())
  {
    return wrong;
  }
  made.Constant = lies.Between == Interpolation::Nearest;
  made.Frame = frame;
  made.FromNormalized = latticeFromNormalized(geometry, frame);
  lattice = std::move(made);
  return {};
}

} // namespace tetmarch
