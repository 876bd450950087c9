// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The pixels whose rays may enter a mesh through a face. A footprint exceeds the face by the
// maximum effect of rounding of rays and vertices in the march.
#ifndef TetMarchEntriesFootprint_h
#define TetMarchEntriesFootprint_h

#include "Mesh/TetMesh.h"

#include <array>
#include <cstdint>

namespace tetmarch
{

struct View;

/** The vertices of a face, counter-clockwise seen from outside. */
using FaceCorners = std::array<const Vertex*, 3>;

/** A rectangle of pixels, from Left to Right and from Bottom to Top, and the minimum depth. */
struct Footprint
{
  std::uint16_t Left = 1; // empty: Left > Right
  std::uint16_t Right = 0;
  std::uint16_t Bottom = 0;
  std::uint16_t Top = 0;
  std::uint16_t Nearest = 0;

  bool isEmpty() const { return this->Left > this->Right; }
  std::uint64_t pixels() const
  {
    return this->isEmpty() ? 0
                           : std::uint64_t(this->Right - this->Left + 1) *
                               std::uint64_t(this->Top - this->Bottom + 1);
  }
};

/** A face on the picture, in pixels. */
struct ProjectedFace
{
  std::array<double, 3> X{}, Y{};
  double Margin = 0; // maximum distance at which a ray can enter through the face by rounding; any
                     // distance if a corner isn't before the eye

  /** Narrow the columns left to right to those in which the face covers a pixel of the rows bottom
   * to top; left > right if there is none. */
  void narrow(int bottom, int top, int& left, int& right) const;
};

/** Projects the faces of a volume. */
class FaceProjection
{
public:
  /** Onto a picture of width x height pixels. */
  FaceProjection(const VolumeFrame& frame, const View& view, int width, int height);

  /** EntryLists::DepthPlane. */
  std::array<float, 4> depthPlane() const;
  ProjectedFace project(const FaceCorners& corners) const;
  /** Empty if the face is back-facing, or no pixel sees it. */
  Footprint footprintOf(const FaceCorners& corners) const;
  /** Of a face around the eye: all pixels. */
  Footprint wholePicture(const FaceCorners& corners) const;

private:
  std::uint16_t nearestOf(const FaceCorners& corners) const;
  bool isOutOfSight(const FaceCorners& corners) const;

  std::array<double, 4> ToX{}, ToY{}, ToW{}; // (x, y, z, 1) . row: pixels times w, and w
  std::array<double, 4> Depth{};
  double LengthX = 0, LengthY = 0, LengthW = 0; // of the rows
  double LeastW = 0;                            // of what is before the eye for sure
  bool Mirrored = false;
  int LastX, LastY; // pixels
};

} // namespace tetmarch

#endif
