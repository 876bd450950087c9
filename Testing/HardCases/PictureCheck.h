// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Pictures of a hard case by the CPU reference, and what a picture may be
 *
 * The ground truth is the CPU reference in double at the reference level. A pixel is right if each
 * channel is within 1/255 of it, or of what the ground truth is while vertices move by the rounding
 * of float (2^-20 mesh radii, see MarchCheck.h), and of a picture by the GL, the ray by 1/100 of a
 * pixel, which is what the rasteriser takes. That is sampled, pixel by pixel, where it matters:
 * where a ray runs within the surface, or grazes it.
 */
#ifndef tetmarch_testing_PictureCheck_h
#define tetmarch_testing_PictureCheck_h

#include "HardCase.h"

#include "FreshFrame.h"
#include "Images.h"

#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <string>
#include <vector>

namespace tetmarch::testing
{
/// Gives the volume its optics and matrix, and the camera its place; the clipping range is that of
/// the volume's bounds. The volume may have any mapper, or none.
void setUpHardCase(const HardCase& hard, const HardView& view, vtkUnstructuredGrid* grid,
  vtkRenderer* renderer, vtkVolume* volume);

/// How a picture compares with the ground truth.
struct PictureResult
{
  MarchCounters Counters;
  int NotFinite = 0;       ///< pixels with a value that is NaN, infinite, or outside of 0..1
  int OutOfBound = 0;      ///< pixels that no mesh within the rounding shows
  double WorstError = 0;   ///< of a channel, 0..1, against the ground truth of the mesh as it is
  double TypicalError = 0; ///< the 99th percentile of it over the pixels that show something
  std::int64_t failures() const;
};

/// How strict a picture is looked at.
struct PictureBounds
{
  int Channels = 4; ///< 3: without alpha
  double Tolerance = 1.0 / 255.0;
  double Reach = 0.0; ///< how far from its pixel's centre a ray may run, in pixels
  int Samples = 640;  ///< of what may be seen, for a pixel
};
/// For our picture by the CPU; for ours by the GL, whose rasteriser rounds; for another mapper, of
/// which less is asked: 16/255, half a pixel.
PictureBounds boundsOfReference();
PictureBounds boundsOfGL();
PictureBounds boundsOfOthers();

/// The width and height of its pictures in pixels.
int sizeOf(const HardView& view);

/// The pictures of one view.
class PictureCheck
{
public:
  /// Throws std::runtime_error with what is wrong.
  PictureCheck(const HardCase& hard, const HardView& view);

  /// By the reference in float, at the default level.
  Image reference(MarchCounters& counters) const;
  /// By the reference in double, at the reference level.
  const Image& groundTruth() const { return this->GroundTruth; }
  PictureResult compare(
    const Image& picture, const MarchCounters& counters, const PictureBounds& bounds);

private:
  std::array<float, 4> pixelOf(const TetMesh& mesh, int x, int y,
    const std::array<double, 2>& aside, const std::array<double, 2>& entries) const;
  bool isWithinBounds(const Image& picture, int x, int y, const PictureBounds& bounds);

  int Size;
  Grid Data;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVolume> Volume;
  std::unique_ptr<FreshFrame> Frame;
  std::unique_ptr<FrameScene> AtDefault, AtReference;
  Image GroundTruth;
  std::vector<TetMesh> Displaced; // made when first needed
};
} // namespace tetmarch::testing

#endif
