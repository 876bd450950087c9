// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the other blend modes than composite read, as members of a kernel; part of KernelBody.h.

const Blending* Blend = nullptr;
Real extremeSign = 1;
bool averages = false;
vec2 averageRange{ 0, 0 };
int isoSurfaceCount = 0;

void useBlending(const Blending& blending)
{
  Blend = &blending;
  extremeSign = Real(blending.extremeSign());
  averages = blending.Mode == BlendMode::Average;
  averageRange = { Real(blending.AverageRange[0]), Real(blending.AverageRange[1]) };
  isoSurfaceCount = static_cast<int>(blending.IsoValues.size());
}
Real fetchIsoValue(int surface) const { return Real(Blend->IsoValues[surface]); }
vec4 fetchIsoColor(int surface) const
{
  const auto& c = Blend->IsoColors[surface];
  return vec4(Real(c[0]), Real(c[1]), Real(c[2]), Real(c[3]));
}
