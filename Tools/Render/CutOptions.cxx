// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CutOptions.h"

#include "AnyMapper.h"
#include "Failure.h"
#include "OptionValues.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkVolumeMapper.h" // for VTK_CROP_SUBVOLUME

namespace tetmarch
{

ClippingPlaneOption ParseClippingPlane(const std::string& value)
{
  const auto n = ParseList(value, { 6 });
  const ClippingPlaneOption plane{ { { n[0], n[1], n[2] } }, { { n[3], n[4], n[5] } } };
  if (plane.Normal == std::array<double, 3>{})
  {
    throw UsageError("a plane with a normal of 0,0,0 has no sides");
  }
  return plane;
}

std::array<double, 6> ParseCrop(const std::string& value)
{
  const auto n = ParseList(value, { 6 });
  if (!(n[0] < n[1] && n[2] < n[3] && n[4] < n[5]))
  {
    throw UsageError("of each two numbers the first must be below the second");
  }
  return { { n[0], n[1], n[2], n[3], n[4], n[5] } };
}

void SetUpCuts(const CutOptions& options, AnyMapper& mapper)
{
  for (const ClippingPlaneOption& option : options.Planes)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(option.Origin[0], option.Origin[1], option.Origin[2]);
    plane->SetNormal(option.Normal[0], option.Normal[1], option.Normal[2]);
    mapper.GetMapper()->AddClippingPlane(plane);
  }
  if (options.Crop)
  {
    constexpr int flags[] = { VTK_CROP_SUBVOLUME, VTK_CROP_FENCE, VTK_CROP_INVERTED_FENCE,
      VTK_CROP_CROSS, VTK_CROP_INVERTED_CROSS };
    mapper.SetCropping(options.Crop->data(), flags[options.CropRegions]);
  }
}

} // namespace tetmarch
