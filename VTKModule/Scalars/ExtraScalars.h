// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The stored scalars that are drawn with the first one: other components of its array.
#ifndef TetMarchScalarsExtraScalars_h
#define TetMarchScalarsExtraScalars_h

#include "Scalars/StoredScalar.h"

#include <vector>

namespace tetmarch
{

struct ExtraScalars
{
  std::vector<float> Values;       // one value per range for each point or cell
  std::vector<ScalarRange> Ranges; // one per extra component

  std::size_t count() const { return this->Ranges.size(); }
};

} // namespace tetmarch

#endif
