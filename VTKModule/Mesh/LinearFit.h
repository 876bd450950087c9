// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Least-squares fit of a linear function.
#ifndef TetMarchMeshLinearFit_h
#define TetMarchMeshLinearFit_h

#include "Geometry/Vector3.h"

namespace tetmarch
{

/** Three linear equations, by Cramer's rule. */
struct System3
{
  std::array<Vector3, 3> Rows{};
  Vector3 Right{};

  double determinant() const { return dot(cross(this->Rows[0], this->Rows[1]), this->Rows[2]); }

  Vector3 solution(double determinant) const
  {
    Vector3 sum{};
    for (int i = 0; i < 3; ++i)
    {
      add(this->Right[i], cross(this->Rows[(i + 1) % 3], this->Rows[(i + 2) % 3]), sum);
    }
    return scaled(1 / determinant, sum);
  }
};

/** The least-squares gradient of changes of a scalar along steps. */
struct FittedGradient
{
  System3 Normal;

  void add(double weight, const Vector3& step, double change)
  {
    tetmarch::add(weight * change, step, this->Normal.Right);
    for (int i = 0; i < 3; ++i)
    {
      tetmarch::add(weight * step[i], step, this->Normal.Rows[i]);
    }
  }

  /** Returns false and sets nothing if the steps are so nearly coplanar that rounding errors would
   * dominate. */
  bool solve(Vector3& gradient) const
  {
    const double mean =
      (this->Normal.Rows[0][0] + this->Normal.Rows[1][1] + this->Normal.Rows[2][2]) / 3;
    const double determinant = this->Normal.determinant();
    // At this limit seven of sixteen digits are left: as many as the float result has.
    if (!(determinant > 1e-9 * mean * mean * mean))
    {
      return false;
    }
    gradient = this->Normal.solution(determinant);
    return true;
  }
};

} // namespace tetmarch

#endif
