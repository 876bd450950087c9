// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// How thick the volume is along a direction.
#ifndef TetMarchReferenceOpticalLength_h
#define TetMarchReferenceOpticalLength_h

#include "GlslLanguage.h"
#include "Scene/View.h"

namespace tetmarch
{

/** Length of a unit direction of the normalised frame, in scalar opacity unit distances. */
template <typename Real>
Real opticalLength(const View& view, glsl::Vec3<Real> direction)
{
  Real square = 0;
  for (int r = 0; r < 3; ++r)
  {
    const Real x = Real(view.LengthMatrix[3 * r]) * direction.x +
                   Real(view.LengthMatrix[3 * r + 1]) * direction.y +
                   Real(view.LengthMatrix[3 * r + 2]) * direction.z;
    square += x * x;
  }
  return std::sqrt(square);
}

} // namespace tetmarch

#endif
