// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VariantKey.h"

namespace tetmarch
{

VariantKey VariantKey::filtered() const
{
  VariantKey key = *this;
  key.Hierarchy = key.Hierarchy || !key.RasterEntry;
  key.Adaptive = key.Adaptive && key.PointScalars;
  return key;
}

std::string VariantKey::defines() const
{
  const auto line = [](const char* name, bool value)
  { return std::string("#define TETMARCH_") + name + (value ? " 1\n" : " 0\n"); };
  return line("POINT_SCALARS", this->PointScalars) + line("RASTER_ENTRY", this->RasterEntry) +
         line("BVH", this->Hierarchy) + line("OPAQUE_DEPTH", this->OpaqueDepth) +
         line("HAS_FMA", this->HasFma) + line("ADAPTIVE", this->Adaptive) +
         line("ERROR_BOUND", this->hasErrorBound()) + line("DIAGNOSTICS", this->Diagnostics);
}

} // namespace tetmarch
