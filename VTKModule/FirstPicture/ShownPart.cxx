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

// Every n-th of the values along an axis, of points or of cells, and the last.
struct Axis
{
  int Points;
  int Values;
  int Step;

  int count() const { return (this->Values - 2 + this->Step) / this->Step + 1; }
  int at(int i) const { return std::min(i * this->Step, this->Values - 1); }
  // The first and the last point of the cells that a value represents.
  int first(int i) const
  {
    return std::max(0, this->at(i) - (this->Values == this->Points ? this->Step : 0));
  }
  int last(int i) const { return std::min(this->Points - 1, this->at(i) + this->Step); }
};

// The extinctions of these values of one block; 0 if they're hidden.
struct Scan
{
  vtkDataSet* Block;
  std::array<Axis, 3> Axes;
  std::vector<double> Extinctions;
};

Scan scanBlock(
  vtkDataSet* block, const DrawnValues& values, const std::function<double(double)>& extinction)
{
  int n[3];
  isLattice(block, n);
  Scan scan{ block, {}, {} };
  for (int k = 0; k < 3; ++k)
  {
    scan.Axes[k] = { n[k], values.ofCells() ? n[k] - 1 : n[k], (n[k] + MostSteps - 1) / MostSteps };
  }
  vtkUnsignedCharArray* ghosts = ghostArraysOf(block).OfCells;
  const auto valueAt = [&](vtkIdType i, vtkIdType j, vtkIdType k)
  {
    const vtkIdType cell =
      (std::min<vtkIdType>(k, n[2] - 2) * (n[1] - 1) + std::min<vtkIdType>(j, n[1] - 2)) *
        (n[0] - 1) +
      std::min<vtkIdType>(i, n[0] - 2);
    const bool hidden = ghosts && (ghosts->GetValue(cell) & HidingCell) != 0;
    const vtkIdType tuple = values.ofCells() ? cell : (k * n[1] + j) * n[0] + i;
    return hidden ? std::nan("") : values.at(tuple);
  };
  const auto& [x, y, z] = scan.Axes;
  for (int k = 0; k < z.count(); ++k)
  {
    for (int j = 0; j < y.count(); ++j)
    {
      for (int i = 0; i < x.count(); ++i)
      {
        const double value = valueAt(x.at(i), y.at(j), z.at(k));
        scan.Extinctions.push_back(std::isfinite(value) ? extinction(value) : 0.0);
      }
    }
  }
  return scan;
}

void addShown(const Scan& scan, double least, std::vector<Vector3>& points)
{
  const auto& [x, y, z] = scan.Axes;
  auto extinction = scan.Extinctions.begin();
  for (int k = 0; k < z.count(); ++k)
  {
    for (int j = 0; j < y.count(); ++j)
    {
      int low = x.count();
      int high = -1;
      for (int i = 0; i < x.count(); ++i)
      {
        if (*extinction++ > least)
        {
          low = std::min(low, i);
          high = i;
        }
      }
      if (high >= 0)
      {
        addCorners(scan.Block, { { x.first(low), y.first(j), z.first(k) } },
          { { x.last(high), y.last(j), z.last(k) } }, points);
      }
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
