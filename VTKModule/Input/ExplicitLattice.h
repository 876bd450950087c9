// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// An explicit structured grid without faults: its cells share their points with their neighbours.
// It is drawn as a curvilinear grid, whose tetrahedra are computed.
#ifndef TetMarchInputExplicitLattice_h
#define TetMarchInputExplicitLattice_h

#include "Caching/Fingerprint.h"

#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"

#include <vector>

class vtkDataObject;
class vtkExplicitStructuredGrid;

namespace tetmarch
{

class ExplicitLattice
{
public:
  /**
   * The input if it is curvilinear. Of an explicit structured grid the same cells, with the same
   * arrays; its points stay the same until those of the input change. Null for others, and for
   * explicit grids with a fault, where neighbours have corners in different places, or with values
   * that may jump there: then points have arrays, and those of neighbours have different numbers.
   */
  vtkStructuredGrid* curvilinearOf(vtkDataObject* input);

private:
  bool findPoints(vtkExplicitStructuredGrid* grid);
  void copyAttributes(vtkExplicitStructuredGrid* grid);

  Fingerprint Cells; // of the input
  Fingerprint Arrays;
  std::vector<vtkIdType> Points; // of the input, at each vertex of the lattice; empty: it is none
  vtkSmartPointer<vtkStructuredGrid> Made;
};

} // namespace tetmarch

#endif
