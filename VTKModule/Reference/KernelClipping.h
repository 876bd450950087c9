// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What cuts the volume, as members of a kernel; part of KernelBody.h. Unless useClipping() is
// called, nothing is cut away.

const Clipping* Clip = nullptr;
int clippingPlaneCount = 0;
vec3 croppingLow{ Real(-Clipping::Farthest), Real(-Clipping::Farthest), Real(-Clipping::Farthest) };
vec3 croppingHigh{ Real(Clipping::Farthest), Real(Clipping::Farthest), Real(Clipping::Farthest) };
int croppingFlags = Clipping::AllRegions;

vec4 fetchClippingPlane(int i) const
{
  const auto& p = Clip->Planes[i];
  return vec4(Real(p[0]), Real(p[1]), Real(p[2]), Real(p[3]));
}

void useClipping(const Clipping& clipping)
{
  Clip = &clipping;
  clippingPlaneCount = static_cast<int>(clipping.Planes.size());
  const auto toReal = [](const std::array<double, 3>& v)
  { return vec3(Real(v[0]), Real(v[1]), Real(v[2])); };
  croppingLow = toReal(clipping.CroppingLow);
  croppingHigh = toReal(clipping.CroppingHigh);
  croppingFlags = clipping.CroppingFlags;
}
