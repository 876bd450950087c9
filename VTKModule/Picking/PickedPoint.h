// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the ray of a pixel has gathered as much as the volume is picked by.
#ifndef TetMarchPickingPickedPoint_h
#define TetMarchPickingPickedPoint_h

#include "Mesh/TetMesh.h"

namespace tetmarch
{

struct PickedPoint
{
  bool Hit = false; // else the ray gathers less, or something opaque comes first
  Id Tet = 0;
  double Scalar = 0;                // as it is stored, 0..1
  std::array<double, 3> Position{}; // in the normalised frame
};

} // namespace tetmarch

#endif
