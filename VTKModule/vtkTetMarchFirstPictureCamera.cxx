// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cameras with the data or a box just in view.
#include "vtkTetMarchFirstPictureInternals.h"

#include "FirstPicture/CameraFit.h"
#include "FirstPicture/Exposure.h"
#include "FirstPicture/ShownPart.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace
{

using tetmarch::Vector3;

bool checkCamera(vtkObject* self, vtkCamera* camera, double aspect)
{
  if (!camera || !(aspect > 0.0))
  {
    vtkErrorWithObjectMacro(
      self, "A camera and the width / height of the picture, above 0, are needed.");
    return false;
  }
  return true;
}

// The camera keeps its direction.
bool fitPoints(vtkObject* self, vtkCamera* camera, const std::vector<Vector3>& points,
  double aspect, double room = tetmarch::DefaultRoom)
{
  Vector3 along;
  Vector3 up;
  camera->GetDirectionOfProjection(along.data());
  camera->GetViewUp(up.data());
  const auto plane = tetmarch::planeFacing(tetmarch::scaled(-1.0, along), up);
  if (!(tetmarch::dot(plane.Up, plane.Up) > 0.5))
  {
    vtkErrorWithObjectMacro(
      self, "The view up of the camera must not be parallel to its direction.");
    return false;
  }
  tetmarch::fitCamera(points, plane, aspect, camera, room);
  if (tetmarch::isTooNear(points, camera))
  {
    vtkWarningWithObjectMacro(self, "Nothing is visible, because the data is so small that a "
                                    "vtkCamera cuts all of it off: it sees "
                                    "nothing nearer than 1e-20. Scale the data.");
  }
  return true;
}

} // namespace

std::vector<Vector3> vtkTetMarchFirstPicture::Internals::findShown(
  vtkPiecewiseFunction* opacity, bool structuredLaw) const
{
  std::vector<Vector3> points;
  if (this->Lattices)
  {
    points = tetmarch::findShownCorners(
      this->Blocks, this->Chosen, tetmarch::extinctionOf(opacity, structuredLaw));
  }
  return points.empty() ? this->Outline : points;
}

bool vtkTetMarchFirstPicture::PlaceCamera(vtkCamera* camera, double aspect)
{
  if (!checkCamera(this, camera, aspect) || !this->CheckInput())
  {
    return false;
  }
  const Internals& found = *this->Found;
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(found.Plane.Back.data());
  camera->SetViewUp(found.Plane.Up.data());
  const bool fitsAll = this->FitWholeData || !found.HasFunctions;
  return fitPoints(this, camera,
    fitsAll ? found.Outline : found.findShown(found.Opacity, this->UsesStructuredLaw()), aspect);
}

bool vtkTetMarchFirstPicture::FitCamera(vtkCamera* camera, vtkVolume* volume, double aspect)
{
  if (!volume)
  {
    vtkErrorMacro("There is no volume to fit the camera to.");
    return false;
  }
  if (!checkCamera(this, camera, aspect) || !this->CheckChosenArray())
  {
    return false;
  }
  const Internals& found = *this->Found;
  vtkPiecewiseFunction* opacity = volume->GetProperty()->GetScalarOpacity();
  std::vector<Vector3> points =
    this->FitWholeData ? found.Outline : found.findShown(opacity, this->UsesStructuredLaw());
  vtkMatrix4x4* matrix = volume->GetMatrix();
  for (Vector3& point : points)
  {
    double place[4] = { point[0], point[1], point[2], 1.0 };
    matrix->MultiplyPoint(place, place);
    point = { { place[0], place[1], place[2] } };
  }
  return fitPoints(this, camera, points, aspect);
}

bool vtkTetMarchFirstPicture::FitCameraToBox(
  vtkCamera* camera, const double bounds[6], double aspect, double room)
{
  if (!checkCamera(this, camera, aspect))
  {
    return false;
  }
  const bool isBox = bounds[0] <= bounds[1] && bounds[2] <= bounds[3] && bounds[4] <= bounds[5];
  if (!isBox || !(room > 0.0 && room <= 1.0))
  {
    vtkErrorMacro(
      "A box whose lower ends aren't above its upper ends, and the share of the picture "
      "that it fills, above 0, at most 1, are needed.");
    return false;
  }
  std::vector<Vector3> corners;
  for (int corner = 0; corner < 8; ++corner)
  {
    corners.push_back(
      { { bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2)] } });
  }
  return fitPoints(this, camera, corners, aspect, room);
}
