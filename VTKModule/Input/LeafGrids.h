// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Unstructured grids of the leaves of trees, which mappers draw in place of these.
#ifndef TetMarchInputLeafGrids_h
#define TetMarchInputLeafGrids_h

#include "Caching/Fingerprint.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <map>
#include <string>
#include <vector>

class vtkDataObject;
class vtkHyperTreeGrid;
class vtkUnstructuredGrid;

namespace tetmarch
{

class LeafGrids
{
public:
  /**
   * The input, if there is no vtkHyperTreeGrid in it. Else a copy, with a grid of the leaves of
   * each: a hexahedron for each leaf that is not masked, with its values. A grid stays the same
   * until its tree changes. Null, with an error, if a tree can't be read.
   */
  vtkSmartPointer<vtkDataObject> replaceTrees(vtkDataObject* input, std::string& error);

private:
  struct LeafGrid
  {
    Fingerprint MadeFrom;
    vtkSmartPointer<vtkUnstructuredGrid> Grid;
  };
  using GridsOfTrees = std::map<vtkHyperTreeGrid*, LeafGrid>;

  LeafGrid gridOf(vtkHyperTreeGrid* tree);

  GridsOfTrees Made;
};

} // namespace tetmarch

#endif
