// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "View/View.h"

#include "Geometry/VolumeFrame.h"
#include "Optics/TransferFunctions.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

// Classify the volume's bounding box in clip coordinates.
void classify(const VolumeFrame& frame, View& view)
{
  const auto& high = frame.HalfExtent;
  const auto& m = view.NormalizedToClip;
  for (int corner = 0; corner < 8; ++corner)
  {
    const double p[4] = { corner & 1 ? high[0] : -high[0], corner & 2 ? high[1] : -high[1],
      corner & 4 ? high[2] : -high[2], 1 };
    std::array<double, 4> clip{};
    for (int r = 0; r < 4; ++r)
    {
      for (int k = 0; k < 4; ++k)
      {
        clip[r] += m[4 * r + k] * p[k];
      }
    }
    const double z = clip[2];
    const double w = clip[3];
    view.CutsNearPlane = view.CutsNearPlane || z <= -w;
    view.CutsFarPlane = view.CutsFarPlane || z >= w;
  }
}

// Homogeneous coordinates are invariant under scaling. The entries of such a matrix are about as
// large as the scene, and overflow floats of the GL above 1e36. A power of 2 changes no digit.
void bringIntoFloatRange(vtkMatrix4x4* matrix)
{
  constexpr int leastExponent = 64;
  double* entries = matrix->GetData();
  double most = 0;
  for (int i = 0; i < 16; ++i)
  {
    most = std::max(most, std::abs(entries[i]));
  }
  int exponent = 0;
  std::frexp(most, &exponent);
  for (int i = 0; i < 16 && std::abs(exponent) > leastExponent; ++i)
  {
    entries[i] = std::ldexp(entries[i], -exponent);
  }
}

// The common point of all lines of sight in view coordinates: x = y = w = 0 in clip coordinates. It
// is the origin or, for parallel projection, the direction +z, except for the eyes of a stereo
// picture or a sheared view.
std::array<double, 4> eyeOf(vtkMatrix4x4* viewToClip)
{
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(viewToClip, inverse);
  std::array<double, 4> eye{};
  for (int r = 0; r < 4; ++r)
  {
    eye[r] = -inverse->GetElement(r, 2); // towards smaller depths
  }
  const double unit =
    eye[3] != 0 ? eye[3] : std::max({ std::abs(eye[0]), std::abs(eye[1]), std::abs(eye[2]) });
  for (double& e : eye)
  {
    e /= unit;
  }
  return eye;
}

} // namespace

std::array<double, 3> View::unproject(double x, double y, double z) const
{
  const double p[4] = { x, y, z, 1 };
  std::array<double, 4> q{};
  for (int r = 0; r < 4; ++r)
  {
    for (int c = 0; c < 4; ++c)
    {
      q[r] += this->ClipToNormalized[4 * r + c] * p[c];
    }
  }
  return { { q[0] / q[3], q[1] / q[3], q[2] / q[3] } };
}

std::array<double, 4> View::nearPlane() const
{
  std::array<double, 4> plane{};
  if (this->CutsNearPlane)
  {
    const auto& m = this->NormalizedToClip;
    const double length = std::hypot(m[8] + m[12], m[9] + m[13], m[10] + m[14]);
    for (int k = 0; k < 4; ++k)
    {
      plane[k] = (m[8 + k] + m[12 + k]) / length;
    }
  }
  return plane;
}

double View::leastPixelsPerUnit(int height) const
{
  const auto& m = this->NormalizedToClip;
  const auto length = [&](int row)
  { return std::hypot(m[4 * row], m[4 * row + 1], m[4 * row + 2]); };
  return 0.5 * height * length(1) / (m[15] + length(3));
}

bool makeView(vtkRenderer* renderer, vtkVolume* volume, const VolumeFrame& frame,
  double unitDistance, OpacityLaw law, View& view)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkNew<vtkMatrix4x4> normalized; // from the normalised frame to the data
  normalized->DeepCopy(frame.matrixToData().data());
  vtkNew<vtkMatrix4x4> toWorld, toView, toClip, inverse, eyeInverse;
  vtkMatrix4x4::Multiply4x4(volume->GetMatrix(), normalized, toWorld);
  vtkMatrix4x4::Multiply4x4(camera->GetModelViewTransformMatrix(), toWorld, toView);
  vtkMatrix4x4* projection =
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1);
  vtkMatrix4x4::Multiply4x4(projection, toView, toClip);
  bringIntoFloatRange(toClip);
  vtkMatrix4x4::Invert(toClip, inverse);
  bringIntoFloatRange(inverse);
  vtkMatrix4x4::Invert(toView, eyeInverse);

  vtkMatrix4x4* toLengths = law == OpacityLaw::Structured ? normalized : toWorld;
  view = {};
  bool usable = true;
  for (int r = 0; r < 4; ++r)
  {
    for (int c = 0; c < 4; ++c)
    {
      view.NormalizedToClip[4 * r + c] = toClip->GetElement(r, c);
      view.ClipToNormalized[4 * r + c] = inverse->GetElement(r, c);
      usable = usable && std::isfinite(toClip->GetElement(r, c)) &&
               std::isfinite(inverse->GetElement(r, c));
    }
  }
  for (int r = 0; r < 3; ++r)
  {
    for (int c = 0; c < 3; ++c)
    {
      // Beyond an optical depth of 1e15 everything is opaque, and its square overflows float.
      const double length = toLengths->GetElement(r, c) / unitDistance;
      view.ThicknessMatrix[3 * r + c] = std::min(std::max(length, -1e15), 1e15);
    }
  }
  eyeInverse->MultiplyPoint(eyeOf(projection).data(), view.Eye.data());
  view.Mirrored = toView->Determinant() < 0;
  classify(frame, view);
  return usable && toView->Determinant() != 0 && toClip->Determinant() != 0;
}

} // namespace tetmarch
