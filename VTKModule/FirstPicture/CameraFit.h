// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A camera such that the data just fit into the picture.
#ifndef TetMarchFirstPictureCameraFit_h
#define TetMarchFirstPictureCameraFit_h

#include "FirstPicture/PicturePlane.h"

class vtkCamera;

namespace tetmarch
{

// The silhouette of the points fills a share of the picture, the room, in perspective and in
// parallel projection. aspect: width / height of the picture. VTK's ResetCamera() fits the sphere
// around the box, so that long meshes appear small.
constexpr double DefaultRoom = 1.0 / 1.05;
void fitCamera(const std::vector<Vector3>& points, const PicturePlane& plane, double aspect,
  vtkCamera* camera, double room = DefaultRoom);

/** Whether all points are nearer to the camera than any near plane that a vtkCamera has. */
bool isTooNear(const std::vector<Vector3>& points, vtkCamera* camera);

} // namespace tetmarch

#endif
