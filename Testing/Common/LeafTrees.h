// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Trees in the unit cube, divided where a test wants it, and their leaves as hexahedra
 */
#ifndef tetmarch_testing_LeafTrees_h
#define tetmarch_testing_LeafTrees_h

#include "GridBuilder.h"

#include "vtkSmartPointer.h"

#include <functional>

class vtkHyperTreeGrid;

namespace tetmarch::testing
{
/// A cube of a tree: a leaf, or one that is divided. The level of a root is 0.
struct Node
{
  Vec3 Low;
  double Width;
  int Level;

  Vec3 middle() const;
};
using NodeTest = std::function<bool(const Node&)>;

struct LeafTrees
{
  vtkSmartPointer<vtkHyperTreeGrid> Trees; ///< cell scalars "c", by the middle of each node
  Grid Leaves; ///< those that aren't masked: hexahedra with points of their own and the same "c"
};

/// Trees with the same number of roots along each axis.
LeafTrees leafTrees(
  int roots, const Field& field, const NodeTest& divides, const NodeTest& masks = {});
} // namespace tetmarch::testing

#endif
