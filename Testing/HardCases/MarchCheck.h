// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Send rays through a hard case and hold each against what it must be
 *
 * Each ray is marched in float, as on the GPU: in every second chunk with the fused predicate, in
 * every second one with the portable one. Lengths are looked at (LengthCheck.h), or, in cases about
 * optics, colours (ColourCheck.h).
 */
#ifndef tetmarch_testing_MarchCheck_h
#define tetmarch_testing_MarchCheck_h

#include "MarchedCase.h"
#include "RayTotals.h"

namespace tetmarch::testing
{
class MarchCheck
{
public:
  /// Throws std::runtime_error if the mesh can't be built.
  explicit MarchCheck(const HardCase& hard)
    : March(hard)
  {
  }

  /// The rays of one chunk, always the same ones; may be called from several threads.
  RayTotals run(unsigned chunk, int rays) const;

  const TetMesh& mesh() const { return this->March.Mesh; }

private:
  MarchedCase March;
};
} // namespace tetmarch::testing

#endif
