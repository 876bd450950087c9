// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the scene calls for, and so which shader is compiled.
#ifndef TetMarchSceneVariantKey_h
#define TetMarchSceneVariantKey_h

#include <string>

namespace tetmarch
{

/**
 * One bit a feature of the march shader. Values that change without recompiling are uniforms, not
 * bits. Shading, clipping and blend modes will be further members here, each with a row in
 * defines() and, where it can be irrelevant, a line in filtered().
 */
struct VariantKey
{
  bool PointScalars = true; // else one scalar a cell
  bool RasterEntry =
    true; // entries from the rasterised boundary; else searched for in the hierarchy
  bool Hierarchy = false;   // rays can enter more than once, or are not rasterised
  bool OpaqueDepth = false; // rays end at opaque geometry or the far plane
  bool HasFma = true;       // the exact predicate by fused multiply-add; else the portable one
  bool Adaptive = true;     // segments are split until the pixel keeps the error tolerance
  bool Diagnostics = false; // counters in further colour attachments

  /** Whether the error of the integration is bounded along the way; that of a constant is 0. */
  bool hasErrorBound() const { return this->PointScalars && (this->Adaptive || this->Diagnostics); }

  bool operator==(const VariantKey& other) const { return this->defines() == other.defines(); }

  /** The key without bits that change nothing, and with those that others imply. */
  VariantKey filtered() const;

  /** The preprocessor lines that select the variant in the shader text. */
  std::string defines() const;
};

} // namespace tetmarch

#endif
