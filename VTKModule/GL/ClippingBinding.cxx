// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/ClippingBinding.h"

#include "Variants/VariantKey.h"
#include "View/Clipping.h"

#include "vtkShaderProgram.h"

namespace tetmarch
{

void bindClipping(vtkShaderProgram* program, const Clipping& clipping, const VariantKey& key)
{
  std::vector<float> planes;
  for (const std::array<double, 4>& plane : clipping.Planes)
  {
    for (double x : plane)
    {
      planes.push_back(static_cast<float>(x));
    }
  }
  const int count = static_cast<int>(clipping.Planes.size());
  program->SetUniformi("clippingPlaneCount", count);
  if (count > 0)
  {
    program->SetUniform4fv("clippingPlane", count, planes.data());
  }
  if (key.Cropped)
  {
    program->SetUniform3f("croppingLow", clipping.CroppingLow.data());
    program->SetUniform3f("croppingHigh", clipping.CroppingHigh.data());
    program->SetUniformi("croppingFlags", clipping.CroppingFlags);
  }
}

} // namespace tetmarch
