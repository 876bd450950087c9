// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The point at which the ray of a pixel has gathered as much as the volume is picked by.
#ifndef TetMarchPickingPickedPoint_h
#define TetMarchPickingPickedPoint_h

#include "Geometry/Vector3.h"

#include "vtkType.h"

namespace tetmarch
{

struct PickedPoint
{
  bool Hit = false;   // false: the ray gathers less, or meets something opaque before
  vtkIdType Cell = 0; // of the data that is drawn
  double Scalar = 0;  // as it is stored, 0..1
  Vector3 Position{}; // in the normalised frame
};

} // namespace tetmarch

#endif
