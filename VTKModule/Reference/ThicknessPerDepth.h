// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Thickness of a unit of depth along a direction.
#ifndef TetMarchReferenceThicknessPerDepth_h
#define TetMarchReferenceThicknessPerDepth_h

#include "Reference/GlslLanguage.h"
#include "View/View.h"

namespace tetmarch
{

/** Length of a unit direction of the normalised frame, in scalar opacity unit distances. */
template <typename Real>
Real thicknessPerDepth(const View& view, glsl::Vec3<Real> direction)
{
  Real square = 0;
  for (int r = 0; r < 3; ++r)
  {
    const Real x = Real(view.ThicknessMatrix[3 * r]) * direction.x +
                   Real(view.ThicknessMatrix[3 * r + 1]) * direction.y +
                   Real(view.ThicknessMatrix[3 * r + 2]) * direction.z;
    square += x * x;
  }
  return std::sqrt(square);
}

} // namespace tetmarch

#endif
