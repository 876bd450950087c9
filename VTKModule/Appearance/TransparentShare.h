// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// How much of a mesh its transfer functions leave transparent.
#ifndef TetMarchAppearanceTransparentShare_h
#define TetMarchAppearanceTransparentShare_h

#include "Mesh/TetMesh.h"
#include "Optics/IntegralTable.h"
#include "Scalars/StoredScalar.h"

#include <vector>

namespace tetmarch
{

/** From here on a loop of its own for cells in which nothing is seen earns what it costs: rays in
 * lockstep wait for each other at its end. */
constexpr double LeastShareToPass = 0.5;

/** Of the scalars, those of the vertices if there are none of cells, the share 0..1 that lies in
 * the table's transparent ranges. */
double transparentShare(const TetMesh& mesh, const std::vector<float>& cellScalars,
  const ScalarRange& range, const IntegralTable& table);

} // namespace tetmarch

#endif
