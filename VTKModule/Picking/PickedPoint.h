// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The point at which the ray of a pixel reaches the pick threshold.
#ifndef TetMarchPickingPickedPoint_h
#define TetMarchPickingPickedPoint_h

#include "Geometry/Vector3.h"

#include "vtkType.h"

namespace tetmarch
{

struct PickedPoint
{
  bool Hit = false;   // false: the ray does not reach the threshold, or hits opaque geometry before
  vtkIdType Cell = 0; // of the drawn data
  double Scalar = 0;  // as stored, 0..1
  Vector3 Position{}; // in the normalised frame
};

} // namespace tetmarch

#endif
