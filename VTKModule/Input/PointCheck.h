// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Checks whether the coordinates of points are in a valid range.
#ifndef TetMarchInputPointCheck_h
#define TetMarchInputPointCheck_h

#include "vtkType.h"

#include <cmath>
#include <string>
#include <vector>

class vtkPoints;

namespace tetmarch
{

/** The volume of a tetrahedron of such coordinates is in the range of double precision. */
constexpr double MostCoordinate = 1e100;

/** Finite, and not too large. */
inline bool isSound(double coordinate) { return std::abs(coordinate) <= MostCoordinate; }

/** For each point whether its coordinates are valid; empty if those of all points are. */
std::vector<char> findSoundPoints(vtkPoints* points);

/** The error of an invalid point of this cell. */
std::string describeUnsoundPoint(vtkPoints* points, vtkIdType point, vtkIdType cell);

} // namespace tetmarch

#endif
