// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DefaultCamera.h"

#include "vtkCamera.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{

void PlaceDefaultCamera(vtkCamera* camera, const double bounds[6], double aspect)
{
  double back[3] = { 0.5, -1.0, 0.45 }; // towards the viewer
  double right[3];
  double up[3] = { 0.0, 0.0, 1.0 };
  vtkMath::Normalize(back);
  vtkMath::Cross(up, back, right);
  vtkMath::Normalize(right);
  vtkMath::Cross(back, right, up);

  constexpr double angle = 30.0;
  constexpr double margin = 1.05;
  const double slope = std::tan(vtkMath::RadiansFromDegrees(0.5 * angle)) / margin;
  const double centre[3] = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
    0.5 * (bounds[4] + bounds[5]) };
  double distance = 0.0;
  double halfHeight = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const double v[3] = { bounds[corner & 1] - centre[0], bounds[2 + (corner >> 1 & 1)] - centre[1],
      bounds[4 + (corner >> 2 & 1)] - centre[2] };
    const double reach =
      std::max(std::abs(vtkMath::Dot(v, right)) / aspect, std::abs(vtkMath::Dot(v, up)));
    distance = std::max(distance, vtkMath::Dot(v, back) + reach / slope);
    halfHeight = std::max(halfHeight, reach * margin);
  }
  distance = distance > 0.0 ? distance : 1.0;
  camera->SetFocalPoint(centre);
  camera->SetPosition(
    centre[0] + distance * back[0], centre[1] + distance * back[1], centre[2] + distance * back[2]);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(angle);
  camera->SetParallelScale(halfHeight > 0.0 ? halfHeight : 1.0);
}

} // namespace tetmarch
