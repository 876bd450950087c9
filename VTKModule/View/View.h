// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The camera in the volume's normalised frame.
#ifndef TetMarchViewView_h
#define TetMarchViewView_h

#include <array>

class vtkRenderer;
class vtkVolume;

namespace tetmarch
{

struct VolumeFrame;
enum class OpacityLaw; // Optics/TransferFunctions.h

/** Row-major matrices, applied to column vectors; clip coordinates as in OpenGL. */
struct View
{
  std::array<double, 16> NormalizedToClip{};
  std::array<double, 16> ClipToNormalized{};
  std::array<double, 9> ThicknessMatrix{}; // normalised direction -> scalar opacity unit distances
  std::array<double, 4> Eye{}; // (eye, 1) or, for parallel projection, (direction towards it, 0)
  bool Mirrored = false;       // counter-clockwise faces appear clockwise on the screen
  bool CutsNearPlane = false;  // a part of the volume lies before the near plane
  bool CutsFarPlane = false;   // a part of the volume lies behind the far plane

  /** The point of clip coordinates (x, y, z), each in -1..1, in the normalised frame. */
  std::array<double, 3> unproject(double x, double y, double z) const;
  /** The near plane, if it cuts the volume: n and c, where n . p + c is the distance of p behind
   * it. Else 0: rays begin before the volume. */
  std::array<double, 4> nearPlane() const;
  /** Of a picture of that height: the pixels that a length of 1 in the normalised frame covers, at
   * the farthest point of the volume. */
  double leastPixelsPerUnit(int height) const;
};

/**
 * The unit distance is a length in coordinates of the data with the structured law, so that the
 * volume's matrix does not change its density, and in world coordinates with the other. Returns
 * false if a matrix is singular or not finite: then nothing is visible.
 */
bool makeView(vtkRenderer* renderer, vtkVolume* volume, const VolumeFrame& frame,
  double unitDistance, OpacityLaw law, View& view);

} // namespace tetmarch

#endif
