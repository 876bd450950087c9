// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The stored scalars that are drawn together with the first one: other components of its array.
#ifndef TetMarchScalarsFurtherScalars_h
#define TetMarchScalarsFurtherScalars_h

#include "Scalars/StoredScalar.h"

#include <vector>

namespace tetmarch
{

struct FurtherScalars
{
  std::vector<float> Values;       // as many in a row as there are ranges: those of one place
  std::vector<ScalarRange> Ranges; // one a further component

  std::size_t count() const { return this->Ranges.size(); }
};

} // namespace tetmarch

#endif
