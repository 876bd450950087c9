// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The leaves of a vtkHyperTreeGrid.
#include "Leaves/LeafList.h"

#include "Input/TreeCheck.h"
#include "Scalars/GhostArrays.h"

#include "vtkCellData.h"
#include "vtkHyperTreeGrid.h"
#include "vtkHyperTreeGridNonOrientedCursor.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace tetmarch
{
namespace
{

class TreeWalk
{
public:
  TreeWalk(vtkHyperTreeGrid* grid, LeafList& found)
    : Found(found)
    , Branches(static_cast<int>(grid->GetBranchFactor()))
    , Ghosts(grid->GetGhostCells())
  {
  }

  void visit(vtkHyperTreeGridNonOrientedCursor* cursor, const Leaf& box)
  {
    const vtkIdType node = cursor->GetGlobalNodeIndex();
    if (cursor->IsMasked())
    {
      this->Found.add(box, false, 0, node);
    }
    else if (cursor->IsLeaf())
    {
      const bool hidden = this->Ghosts && (this->Ghosts->GetValue(node) & HidingCell);
      this->Found.add(box, !hidden, 0, node);
    }
    else
    {
      for (int child = 0; child < cursor->GetNumberOfChildren(); ++child)
      {
        cursor->ToChild(static_cast<unsigned char>(child));
        this->visit(cursor, this->childOf(box, child));
        cursor->ToParent();
      }
    }
  }

private:
  Leaf childOf(const Leaf& box, int child) const
  {
    const int n = this->Branches;
    const std::array<int, 3> at{ { child % n, child / n % n, child / (n * n) } };
    Leaf made;
    for (int a = 0; a < 3; ++a)
    {
      made.Size[a] = box.Size[a] / n;
      made.Low[a] = box.Low[a] + at[a] * made.Size[a];
    }
    return made;
  }

  LeafList& Found;
  int Branches;
  vtkUnsignedCharArray* Ghosts;
};

// Of the smallest cells, along an axis.
double widthOfRoot(vtkHyperTreeGrid* grid)
{
  return std::pow(grid->GetBranchFactor(), static_cast<double>(grid->GetNumberOfLevels()) - 1);
}

std::string checkExtent(vtkHyperTreeGrid* grid)
{
  if (grid->GetDimension() != 3)
  {
    return "The tree has " + std::to_string(grid->GetDimension()) +
           " dimension(s); only trees in three have an inside.";
  }
  const unsigned int* roots = grid->GetCellDims();
  const double cells = widthOfRoot(grid);
  for (int a = 0; a < 3; ++a)
  {
    if (!(roots[a] * cells < MostLeafPlaces))
    {
      return "The tree is " + std::to_string(roots[a] * cells) +
             " of its smallest cells wide, more than 2^30: vtkHyperTreeGridDepthLimiter leaves the "
             "finest levels out.";
    }
  }
  return {};
}

std::string findAxis(vtkDataArray* coordinates, unsigned int points, LeafAxis& axis)
{
  for (unsigned int i = 0; i < points; ++i)
  {
    axis.Breaks.push_back(coordinates->GetComponent(i, 0));
  }
  bool ascends = true;
  for (std::size_t i = 1; i < axis.Breaks.size(); ++i)
  {
    ascends = ascends && axis.Breaks[i] > axis.Breaks[i - 1] && std::isfinite(axis.Breaks[i]);
  }
  return ascends && std::isfinite(axis.Breaks.front())
           ? std::string()
           : "The tree needs coordinates that ascend along each axis.";
}

} // namespace

std::string listLeaves(vtkHyperTreeGrid* grid, LeafList& list, LeafAxes& axes)
{
  std::string error = checkExtent(grid);
  error = error.empty() ? checkTree(grid) : error;
  const std::array<vtkDataArray*, 3> coordinates{ { grid->GetXCoordinates(),
    grid->GetYCoordinates(), grid->GetZCoordinates() } };
  const unsigned int* points = grid->GetDimensions();
  for (int a = 0; a < 3 && error.empty(); ++a)
  {
    error = findAxis(coordinates[a], points[a], axes[a]);
  }
  if (!error.empty())
  {
    return error;
  }
  const int width = static_cast<int>(std::lround(widthOfRoot(grid)));
  TreeWalk walk(grid, list);
  vtkNew<vtkHyperTreeGridNonOrientedCursor> cursor;
  for (vtkIdType root = 0; root < grid->GetMaxNumberOfTrees(); ++root)
  {
    std::array<unsigned int, 3> at{};
    grid->GetLevelZeroCoordinatesFromIndex(root, at[0], at[1], at[2]);
    Leaf box;
    for (int a = 0; a < 3; ++a)
    {
      axes[a].CellsBetweenBreaks = width;
      box.Size[a] = width;
      box.Low[a] = static_cast<int>(at[a]) * width;
    }
    if (grid->GetTree(root))
    {
      grid->InitializeNonOrientedCursor(cursor, root);
      walk.visit(cursor, box);
    }
    else
    {
      list.add(box, false, 0, 0);
    }
  }
  return {};
}

std::string findLeaves(vtkHyperTreeGrid* grid, Leaves& leaves)
{
  LeafList list;
  LeafAxes axes;
  std::string error = listLeaves(grid, list, axes);
  if (!error.empty())
  {
    return error;
  }
  leaves = list.made(std::move(axes), { valueArraysOf(grid->GetCellData()) });
  leaves.ActiveScalars = activeScalarsOf(grid->GetCellData());
  return leaves.Shown == 0 ? "The tree has no leaf that is drawn." : std::string();
}

} // namespace tetmarch
