// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What clipping planes and cropping leave of the volume, in the mesh's normalised frame.
#ifndef TetMarchRaysClipping_h
#define TetMarchRaysClipping_h

#include <array>
#include <string>
#include <vector>

class vtkPlaneCollection;
class vtkVolume;

namespace tetmarch
{

struct VolumeFrame;

/** What a user wants to be cut away. */
struct ClippingOptions
{
  vtkPlaneCollection* Planes = nullptr; // in world coordinates; may be none
  bool Cropping = false;
  /** xmin, xmax, ymin, ymax, zmin, zmax in coordinates of the data, and a bit for each of the 27
   * regions that is left; as vtkVolumeMapper has them. */
  std::array<double, 6> CroppingPlanes{};
  int CroppingFlags = 0;
};

/** Shaders/cuts/clipping_buffers.glsl has it as uniforms. */
struct Clipping
{
  static constexpr int MostUserPlanes = 32;
  static constexpr int MostPlanes = MostUserPlanes + 6; // a box of cropping is six
  static constexpr int AllRegions = 0x7ffffff;
  /** Of planes from the mesh's centre. What is as far beyond the mesh, whose radius is 1, cuts as
   * little, or as much, from anywhere farther. */
  static constexpr double Farthest = 2;

  /** Unit normal n and d: points x with n x + d >= 0 are left. */
  std::vector<std::array<double, 4>> Planes;
  bool Cropped = false; // by regions that are no box
  std::array<double, 3> CroppingLow{ { -Farthest, -Farthest, -Farthest } };
  std::array<double, 3> CroppingHigh{ { Farthest, Farthest, Farthest } };
  int CroppingFlags = AllRegions;
  bool LeavesNothing = false; // by cropping

  bool cuts() const { return this->Cropped || !this->Planes.empty(); }
};

/** Returns an empty string, or what is wrong. */
std::string makeClipping(
  const ClippingOptions& options, vtkVolume* volume, const VolumeFrame& frame, Clipping& clipping);

} // namespace tetmarch

#endif
