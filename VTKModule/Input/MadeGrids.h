// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Unstructured grids that mappers draw in place of data that are no vtkDataSet: of trees their
// leaves, of cell grids their cells.
#ifndef TetMarchInputMadeGrids_h
#define TetMarchInputMadeGrids_h

#include "Caching/Fingerprint.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <map>
#include <string>

class vtkDataObject;
class vtkUnstructuredGrid;

namespace tetmarch
{

/** Whether a grid is made in place of this: of a vtkHyperTreeGrid, and of a vtkCellGrid where VTK
 * has these. */
bool isGridMadeOf(vtkDataObject* data);

/** Calls back with the names of these classes. */
void forEachTypeOfMadeGrids(const std::function<void(const char*)>& callback);

class MadeGrids
{
public:
  /**
   * The input, if no grid is made of it or of its blocks. Else a copy with these grids. A grid
   * stays the same until what it is made of changes. Null, with an error, if data aren't sound.
   */
  vtkSmartPointer<vtkDataObject> replaceIn(vtkDataObject* input, std::string& error);

  /** Whether the last replacement made this of a vtkCellGrid. To VTK all fields of that are of
   * cells; here they may be of points. */
  bool isOfCellGrid(vtkDataObject* grid) const;

private:
  struct MadeGrid
  {
    Fingerprint MadeFrom;
    vtkSmartPointer<vtkUnstructuredGrid> Grid;
  };
  using GridsByData = std::map<vtkDataObject*, MadeGrid>;

  MadeGrid gridOf(vtkDataObject* data, std::string& error);

  GridsByData Made;
};

} // namespace tetmarch

#endif
