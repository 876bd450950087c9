// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "NonConvexGrids.h"

#include "GridTransforms.h"

#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace tetmarch::testing
{
int holeBegin(int n) { return n / 3; }

int holeEnd(int n) { return n - n / 3; }

Grid latticeWithHole(int n, double jitter, unsigned seed, const Field& field)
{
  const auto inMiddle = [n](int index) { return index >= holeBegin(n) && index < holeEnd(n); };
  return maskedLattice(n, jitter, seed, field,
    [=](int i, int j, int k) { return !(inMiddle(i) && inMiddle(j) && inMiddle(k)); });
}

Grid latticeWithTunnel(int n, double jitter, unsigned seed, const Field& field)
{
  const auto inMiddle = [n](int index) { return index >= holeBegin(n) && index < holeEnd(n); };
  return maskedLattice(
    n, jitter, seed, field, [=](int i, int j, int) { return !(inMiddle(i) && inMiddle(j)); });
}

Grid lShape(int n, double jitter, unsigned seed, const Field& field)
{
  return maskedLattice(
    n, jitter, seed, field, [n](int i, int j, int) { return 2 * i < n || 2 * j < n; });
}

Grid twoComponents(int n, double jitter, unsigned seed, const Field& field)
{
  const Grid first = jitteredLattice(n, jitter, seed, field);
  const Grid second = jitteredLattice(n, jitter, seed + 1, field);
  return joined(first, withOffsetAndScale(second, { 1.25, 0.25, 0.25 }, 0.5));
}

Grid nestedShells(int n, int bands, double jitter, unsigned seed, const Field& field)
{
  return maskedLattice(n, jitter, seed, field,
    [=](int i, int j, int k)
    {
      const double x = (2.0 * i + 1.0) / n - 1.0;
      const double y = (2.0 * j + 1.0) / n - 1.0;
      const double z = (2.0 * k + 1.0) / n - 1.0;
      return static_cast<int>(bands * std::sqrt(x * x + y * y + z * z)) % 2 == 0;
    });
}
} // namespace tetmarch::testing
