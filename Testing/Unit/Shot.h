// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A small picture, by the CPU reference and by the ground truth
 */
#ifndef tetmarch_testing_Shot_h
#define tetmarch_testing_Shot_h

#include "FreshFrame.h"
#include "GroundTruth.h"
#include "Images.h"
#include "UnitMeshes.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"
#include "vtkVolumeProperty.h"

#include <functional>
#include <memory>

namespace tetmarch::testing
{
/// Cameras and their matrices need no window.
class WindowlessRenderer : public vtkRenderer
{
public:
  static WindowlessRenderer* New();
  void DeviceRender() override {}
};

/// What a picture is taken of, and how.
struct Shot
{
  static constexpr int Size = 48;

  Grid Data = jitteredLattice(6, 0.15, 1, sineField());
  ScalarsOf Scalars = ScalarsOf::Points;
  vtkNew<vtkTransform> Transform;
  vtkNew<vtkCamera> Camera;
  OpticalModel Optics;       ///< its UnitDistance is not used
  std::vector<float> Depths; ///< of opaque geometry, a pixel each; empty: none
  ClippingOptions Cut;
  double UnitDistance = 0.25;
  VectorOptions Vector;
  BlendOptions Blend;
  std::function<void(vtkVolumeProperty*)> Adjust; ///< what Optics doesn't say; may be empty

  Shot();
};

/// What the CPU marches of a shot.
class MarchedShot
{
public:
  MarchedShot(const Shot& shot, const AccuracyLevel& level);

private:
  vtkNew<WindowlessRenderer> Renderer;
  vtkNew<vtkVolume> Volume;
  std::unique_ptr<FreshFrame> Frame;
  std::unique_ptr<FrameScene> Made;

public:
  const TetMesh& Mesh;
  const MeshScalars& Scalars;
  ReferenceScene& Scene; ///< refers to the shot's depths, too
};

/// The line of a pixel from the near plane to a depth of the window, 0..1, in world coordinates,
/// with VTK's own camera matrix.
std::array<Vec3, 2> lineOf(const Shot& shot, int x, int y, double depth = 1.0);
Image byGroundTruth(const Shot& shot);

/// In the arithmetic of Real: float or double.
template <typename Real>
ReferenceImage byMarch(const Shot& shot, const AccuracyLevel& level);
template <typename Real>
Image byReference(const Shot& shot, const AccuracyLevel& level, MarchCounters& counters);
} // namespace tetmarch::testing

#endif
