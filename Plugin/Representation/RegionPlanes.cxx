// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RegionPlanes.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"

#include <algorithm>

namespace tetmarch
{

void findRegionPlanes(const std::vector<vtkBoundingBox>& regions, int process, vtkMatrix4x4* place,
  vtkPlaneCollection* planes)
{
  planes->RemoveAllItems();
  vtkBoundingBox all;
  for (const vtkBoundingBox& region : regions)
  {
    all.AddBox(region);
  }
  const vtkBoundingBox& own = regions[process];
  if (!own.IsValid())
  {
    return;
  }
  vtkNew<vtkMatrix4x4> normals; // takes normals of planes to the world
  vtkMatrix4x4::Invert(place, normals);
  normals->Transpose();
  double center[3];
  own.GetCenter(center);
  for (int face = 0; face < 6; ++face)
  {
    if (own.GetBound(face) == all.GetBound(face))
    {
      continue;
    }
    double origin[4] = { center[0], center[1], center[2], 1 };
    origin[face / 2] = own.GetBound(face);
    double normal[4] = { 0, 0, 0, 0 };
    normal[face / 2] = face % 2 == 0 ? 1 : -1;
    place->MultiplyPoint(origin, origin);
    normals->MultiplyPoint(normal, normal);
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(origin);
    plane->SetNormal(normal);
    planes->AddItem(plane);
  }
}

} // namespace tetmarch
