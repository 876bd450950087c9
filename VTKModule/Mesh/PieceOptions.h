// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// How the mesh of a grid is made if other processes may have the rest of it.
#ifndef TetMarchMeshPieceOptions_h
#define TetMarchMeshPieceOptions_h

#include "Geometry/VolumeFrame.h"

namespace tetmarch
{

/**
 * A face that two pieces share is to have the same vertices in both, to the last bit, and to be cut
 * into the same triangles: then a ray leaves one piece exactly where it enters the other.
 */
struct PieceOptions
{
  /** Faces are cut through their least corner by coordinates, not by point id. */
  bool ByCoordinates = false;
  bool IsPiece = false; // what follows counts
  VolumeFrame Frame;    // of the whole
  bool InFloat = false; // points are rounded to float first: some piece has no others

  bool operator==(const PieceOptions& other) const
  {
    return this->ByCoordinates == other.ByCoordinates && this->IsPiece == other.IsPiece &&
           this->Frame == other.Frame && this->InFloat == other.InFloat;
  }
};

/** The nearest float. Not inline: where GCC 12 unrolls a loop over three coordinates at -O3, it
 * leaves the rounding of two of them out. */
double roundedToFloat(double x);

} // namespace tetmarch

#endif
