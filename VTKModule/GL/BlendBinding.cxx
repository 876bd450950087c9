// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/BlendBinding.h"

#include "Appearance/Blending.h"
#include "Variants/VariantKey.h"

#include "vtkShaderProgram.h"

namespace tetmarch
{

void bindBlending(vtkShaderProgram* program, const Blending& blending, const VariantKey& key)
{
  if (key.Blend == BlendGroup::Extreme)
  {
    program->SetUniformf("extremeSign", blending.extremeSign());
  }
  if (key.Blend == BlendGroup::Sum)
  {
    program->SetUniformi("averages", blending.Mode == BlendMode::Average ? 1 : 0);
    program->SetUniform2f("averageRange", blending.AverageRange.data());
  }
  if (key.Blend == BlendGroup::Isosurfaces)
  {
    const int count = static_cast<int>(blending.IsoValues.size());
    program->SetUniformi("isoSurfaceCount", count);
    if (count > 0)
    {
      program->SetUniform1fv("isoValue", count, blending.IsoValues.data());
      program->SetUniform4fv("isoColor", count, blending.IsoColors.front().data());
    }
  }
}

} // namespace tetmarch
