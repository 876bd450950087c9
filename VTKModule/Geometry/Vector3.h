// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Points and vectors in double precision.
#ifndef TetMarchGeometryVector3_h
#define TetMarchGeometryVector3_h

#include <array>

namespace tetmarch
{

using Vector3 = std::array<double, 3>;

inline Vector3 operator-(const Vector3& a, const Vector3& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

inline void add(double factor, const Vector3& v, Vector3& sum)
{
  for (int k = 0; k < 3; ++k)
  {
    sum[k] += factor * v[k];
  }
}

inline Vector3 scaled(double factor, const Vector3& v)
{
  return { { factor * v[0], factor * v[1], factor * v[2] } };
}

inline double dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector3 cross(const Vector3& a, const Vector3& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}

} // namespace tetmarch

#endif
