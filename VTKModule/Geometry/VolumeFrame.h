// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The normalised frame of a volume, in which rays march.
#ifndef TetMarchGeometryVolumeFrame_h
#define TetMarchGeometryVolumeFrame_h

#include "Geometry/Vector3.h"

#include <string>
#include <vector>

namespace tetmarch
{

/**
 * The origin of the frame is the centre of the volume's bounding box. Its unit of length is half of
 * the box's diagonal, so that the volume lies in the unit ball.
 */
struct VolumeFrame
{
  Vector3 Center{};     // of the bounding box, in coordinates of the data
  double Radius = 1;    // half of the bounding box's diagonal, in units of the data
  Vector3 HalfExtent{}; // half of the bounding box's sides, in the normalised frame

  /** A point of the frame in coordinates of the data. */
  Vector3 toData(const Vector3& point) const;
  /** The same as a row-major matrix. */
  std::array<double, 16> matrixToData() const;

  bool operator==(const VolumeFrame& other) const
  {
    return this->Center == other.Center && this->Radius == other.Radius &&
           this->HalfExtent == other.HalfExtent;
  }
};

/** The frame of a bounding box, from its lowest to its highest corner. Returns an empty string, or
 * an error. */
std::string findFrame(const Vector3& low, const Vector3& high, VolumeFrame& frame);

/** The frame of the bounding box of these points. Returns an empty string, or an error; without
 * points the frame is not changed. */
std::string findFrame(const std::vector<Vector3>& points, VolumeFrame& frame);

} // namespace tetmarch

#endif
