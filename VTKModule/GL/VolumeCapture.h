// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A volume as the shaders read it, for a page that draws it in a browser.
#ifndef TetMarchGLVolumeCapture_h
#define TetMarchGLVolumeCapture_h

#include "GL/ProgramCapture.h"
#include "Geometry/VolumeFrame.h"
#include "Optics/AccuracyLevel.h"
#include "Scalars/StoredScalar.h"
#include "Variants/VariantKey.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tetmarch
{

struct CapturedVolume
{
  /** The variant of the picture without opaque geometry and without lists of entries, which the
   * page makes for each view. */
  VariantKey Key;
  /** With the visible part of a mesh (Entries/VisiblePart.h), if the mapper enters it. */
  CapturedProgram Program;
  VolumeFrame Frame;
  AccuracyLevel Level = DefaultAccuracy;
  ScalarRange Range; // of the first scalar
  std::vector<ScalarRange> ExtraRanges;
  std::vector<std::uint32_t> Cells; // of each tetrahedron: its cell in the input
  /** Of an image whose lattice has other planes: StructuredVolume::dataPlanes(). */
  std::array<std::vector<double>, 3> DataPlanes;
};

} // namespace tetmarch

#endif
