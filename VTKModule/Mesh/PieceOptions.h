// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Options of a mesh that may be a piece of a volume of several processes.
#ifndef TetMarchMeshPieceOptions_h
#define TetMarchMeshPieceOptions_h

#include "Geometry/VolumeFrame.h"

namespace tetmarch
{

/**
 * A face that two pieces share must have the same vertices in both, to the last bit, and the same
 * triangles: then a ray leaves one piece exactly where it enters the other.
 */
struct PieceOptions
{
  /** Faces are cut through the corner with the smallest coordinates, not with the smallest id. */
  bool ByCoordinates = false;
  /** Points with equal coordinates stay separate vertices, since their scalars differ. */
  bool SeparatePoints = false;
  /** Likewise the points of sides of a curvilinear grid that meet (JoinedSides.h). */
  bool SeparateSides = false;
  bool IsPiece = false; // the following members are used
  VolumeFrame Frame;    // of the whole
  bool InFloat = false; // points are rounded to float first, since some piece has floats

  bool operator==(const PieceOptions& other) const
  {
    return this->ByCoordinates == other.ByCoordinates &&
           this->SeparatePoints == other.SeparatePoints &&
           this->SeparateSides == other.SeparateSides && this->IsPiece == other.IsPiece &&
           this->Frame == other.Frame && this->InFloat == other.InFloat;
  }
};

/** The nearest float. Not inline: GCC 12 at -O3, unrolling a loop over three coordinates, omits the
 * rounding of two of them. */
double roundedToFloat(double x);

} // namespace tetmarch

#endif
