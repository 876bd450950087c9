// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The share of a mesh that its transfer functions leave transparent.
#ifndef TetMarchVolumeTransparentShare_h
#define TetMarchVolumeTransparentShare_h

#include "Mesh/TetMesh.h"
#include "Optics/IntegralTable.h"
#include "Scalars/StoredScalar.h"

#include <vector>

namespace tetmarch
{

/** The share 0..1 of the cell scalars, or of those of the vertices if there are none, that lies in
 * the table's transparent ranges. */
double transparentShare(const TetMesh& mesh, const std::vector<float>& cellScalars,
  const ScalarRange& range, const IntegralTable& table);

} // namespace tetmarch

#endif
