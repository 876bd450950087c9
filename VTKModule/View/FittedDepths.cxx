// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "View/FittedDepths.h"

#include "Geometry/VolumeFrame.h"
#include "View/View.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{

double reachOf(const double* row, const VolumeFrame& frame)
{
  double reach = 0;
  for (int k = 0; k < 3; ++k)
  {
    reach += std::abs(row[k]) * frame.HalfExtent[k];
  }
  return reach;
}

std::array<double, 16> fittedDepths(const View& view, const VolumeFrame& frame)
{
  std::array<double, 16> matrix = view.NormalizedToClip;
  double* z = &matrix[8];
  const double* w = &matrix[12];
  const double margin = 1.01; // against rounding
  if (w[0] == 0 && w[1] == 0 && w[2] == 0)
  {
    // Parallel projection: the middle of the volume becomes 0, its ends become w and -w.
    const double scale = w[3] / (margin * reachOf(z, frame));
    z[0] *= scale;
    z[1] *= scale;
    z[2] *= scale;
    z[3] = 0;
    return matrix;
  }
  // w is the distance d, and z / w = (far + near - 2 far near / d) / (far - near).
  const double reach = reachOf(w, frame);
  const double far = std::max(w[3] + margin * reach, 1e-3 * reach);
  const double near = std::max({ w[3] - margin * reach, 0.5 * (w[3] - reach), 1e-3 * far });
  for (int k = 0; k < 4; ++k)
  {
    z[k] = w[k] * (far + near) / (far - near);
  }
  z[3] -= 2 * far * near / (far - near);
  return matrix;
}

} // namespace tetmarch
