// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Gauss-Legendre quadrature of 10 points
 */
#ifndef tetmarch_testing_GaussLegendre_h
#define tetmarch_testing_GaussLegendre_h

#include "vtkMath.h"

#include <cmath>

namespace tetmarch::testing
{
/// Nodes and weights on [0, 1], and the integrals of the Lagrange polynomials from 0 to each node:
/// exact for the polynomial through the nodes, hence the depth at each of them.
struct GaussLegendre
{
  static constexpr int Order = 10;
  double Node[Order];
  double Weight[Order];
  double UpTo[Order][Order];

  static const GaussLegendre& instance()
  {
    static const GaussLegendre rule;
    return rule;
  }

  GaussLegendre()
  {
    for (int i = 0; i < Order; ++i)
    {
      // Newton's iteration on the Legendre polynomial from the usual guess (Abramowitz and
      // Stegun 22.16.6).
      double x = std::cos(vtkMath::Pi() * (i + 0.75) / (Order + 0.5));
      double slope = 0.0;
      for (int iteration = 0; iteration < 50; ++iteration)
      {
        double p = 1.0;
        double before = 0.0;
        for (int k = 1; k <= Order; ++k)
        {
          const double next = ((2.0 * k - 1.0) * x * p - (k - 1.0) * before) / k;
          before = p;
          p = next;
        }
        slope = Order * (x * p - before) / (x * x - 1.0);
        x -= p / slope;
      }
      this->Node[i] = 0.5 * (1.0 - x);
      this->Weight[i] = 1.0 / ((1.0 - x * x) * slope * slope);
    }
    for (int i = 0; i < Order; ++i)
    {
      for (int j = 0; j < Order; ++j)
      {
        this->UpTo[i][j] = 0.0;
        for (int k = 0; k < Order; ++k)
        {
          this->UpTo[i][j] +=
            this->Node[i] * this->Weight[k] * this->lagrange(j, this->Node[i] * this->Node[k]);
        }
      }
    }
  }

private:
  double lagrange(int j, double x) const
  {
    double product = 1.0;
    for (int k = 0; k < Order; ++k)
    {
      product *= k == j ? 1.0 : (x - this->Node[k]) / (this->Node[j] - this->Node[k]);
    }
    return product;
  }
};
} // namespace tetmarch::testing

#endif
