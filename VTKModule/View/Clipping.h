// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of the volume that remains after clipping and cropping, in the normalised frame.
#ifndef TetMarchViewClipping_h
#define TetMarchViewClipping_h

#include <array>
#include <string>
#include <vector>

class vtkPlaneCollection;
class vtkVolume;

namespace tetmarch
{

struct VolumeFrame;

/** The user's settings. */
struct ClippingOptions
{
  vtkPlaneCollection* Planes = nullptr; // in world coordinates; may be none
  bool Cropping = false;
  /** xmin, xmax, ymin, ymax, zmin, zmax in coordinates of the data, and a bit for each remaining
   * region of 27, as in vtkVolumeMapper. */
  std::array<double, 6> CroppingPlanes{};
  int CroppingFlags = 0;
};

/** The uniforms of Shaders/cuts/clipping_buffers.glsl. */
struct Clipping
{
  static constexpr int MostUserPlanes = 32;
  static constexpr int MostPlanes = MostUserPlanes + 6; // a cropping box is six planes
  static constexpr int AllRegions = 0x7ffffff;
  /** Distances of planes from the centre are clamped to this. Farther away, a plane removes all or
   * nothing of the volume, whose radius is 1. */
  static constexpr double Farthest = 2;

  /** Unit normal n and distance d: points x with n x + d >= 0 remain. */
  std::vector<std::array<double, 4>> Planes;
  bool Cropped = false; // the remaining regions do not form a box
  std::array<double, 3> CroppingLow{ { -Farthest, -Farthest, -Farthest } };
  std::array<double, 3> CroppingHigh{ { Farthest, Farthest, Farthest } };
  int CroppingFlags = AllRegions;
  bool LeavesNothing = false; // by cropping

  bool cuts() const { return this->Cropped || !this->Planes.empty(); }
};

/** Returns an empty string, or an error. */
std::string makeClipping(
  const ClippingOptions& options, vtkVolume* volume, const VolumeFrame& frame, Clipping& clipping);

} // namespace tetmarch

#endif
