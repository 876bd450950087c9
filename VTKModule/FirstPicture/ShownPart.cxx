// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture/ShownPart.h"

#include "FirstPicture/PicturePlane.h"
#include "Scalars/GhostArrays.h"

#include "vtkDataSet.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{

namespace
{

constexpr int MostSteps = 100; // along an axis
constexpr double Shown = 0.01; // of the maximum extinction

// The values along an axis, of points or of cells, that are looked at.
struct Axis
{
  int Points;
  bool OfCells;
  int Step;
  std::vector<int> Places; // every n-th, and the last

  Axis(int points, bool ofCells)
    : Points(points)
    , OfCells(ofCells)
    , Step((points + MostSteps - 1) / MostSteps)
  {
    const int count = ofCells ? points - 1 : points;
    for (int i = 0; i < count; i += this->Step)
    {
      this->Places.push_back(i);
    }
    if (this->Places.back() < count - 1)
    {
      this->Places.push_back(count - 1);
    }
  }

  // The first and the last point of the cells that a value represents.
  int first(int place) const { return this->OfCells ? place : std::max(0, place - this->Step); }
  int last(int place) const { return std::min(this->Points - 1, place + this->Step); }
};

// The extinctions of the values of one block that are looked at; 0 if they're hidden.
struct Scan
{
  vtkDataSet* Block;
  std::array<Axis, 3> Axes;
  std::vector<double> Extinctions;
};

vtkIdType indexOf(const std::array<int, 3>& place, const int counts[3])
{
  return (static_cast<vtkIdType>(place[2]) * counts[1] + place[1]) * counts[0] + place[0];
}

Scan scanBlock(
  vtkDataSet* block, const DrawnValues& values, const std::function<double(double)>& extinction)
{
  int points[3];
  isLattice(block, points);
  const int cells[3] = { points[0] - 1, points[1] - 1, points[2] - 1 };
  const bool ofCells = values.ofCells();
  Scan scan{ block, { { { points[0], ofCells }, { points[1], ofCells }, { points[2], ofCells } } },
    {} };
  vtkUnsignedCharArray* ghosts = ghostArraysOf(block).OfCells;
  for (const int k : scan.Axes[2].Places)
  {
    for (const int j : scan.Axes[1].Places)
    {
      for (const int i : scan.Axes[0].Places)
      {
        const vtkIdType cell = indexOf(
          { { std::min(i, cells[0] - 1), std::min(j, cells[1] - 1), std::min(k, cells[2] - 1) } },
          cells);
        const bool hidden = ghosts && (ghosts->GetValue(cell) & HidingCell) != 0;
        const double value = values.at(ofCells ? cell : indexOf({ { i, j, k } }, points));
        scan.Extinctions.push_back(!hidden && std::isfinite(value) ? extinction(value) : 0.0);
      }
    }
  }
  return scan;
}

void addShown(const Scan& scan, double least, std::vector<Vector3>& points)
{
  const auto& [x, y, z] = scan.Axes;
  auto row = scan.Extinctions.begin();
  const auto shows = [least](double extinction) { return extinction > least; };
  for (const int k : z.Places)
  {
    for (const int j : y.Places)
    {
      const auto end = row + static_cast<std::ptrdiff_t>(x.Places.size());
      const auto first = std::find_if(row, end, shows);
      if (first != end)
      {
        const auto last =
          std::find_if(std::make_reverse_iterator(end), std::make_reverse_iterator(first), shows);
        const int low = x.Places[first - row];
        const int high = x.Places[last.base() - 1 - row];
        addCorners(scan.Block, { { x.first(low), y.first(j), z.first(k) } },
          { { x.last(high), y.last(j), z.last(k) } }, points);
      }
      row = end;
    }
  }
}

} // namespace

std::vector<Vector3> findShownCorners(const std::vector<vtkDataSet*>& lattices,
  const DrawnArray& drawn, const std::function<double(double)>& extinction)
{
  std::vector<Scan> scans;
  double most = 0;
  for (vtkDataSet* block : lattices)
  {
    if (const DrawnValues values(block, drawn); values)
    {
      scans.push_back(scanBlock(block, values, extinction));
      const std::vector<double>& found = scans.back().Extinctions;
      most = std::max(most, *std::max_element(found.begin(), found.end()));
    }
  }
  std::vector<Vector3> points;
  for (const Scan& each : scans)
  {
    addShown(each, Shown * most, points);
  }
  return points;
}

} // namespace tetmarch
