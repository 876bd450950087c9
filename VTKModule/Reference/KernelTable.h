// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The kernels for pictures, by the features that they were chosen for. Reference/Kernels.cmake
// makes the table from Variants/features.txt.
#ifndef TetMarchReferenceKernelTable_h
#define TetMarchReferenceKernelTable_h

#include <cstdint>
#include <vector>

namespace tetmarch
{

struct AccuracyLevel;
struct ReferenceImage;
struct ReferenceScene;

struct PictureKernel
{
  std::uint64_t Chosen; // bits of VariantKey
  ReferenceImage (*Float)(const ReferenceScene& scene, const AccuracyLevel& level);
  ReferenceImage (*Double)(const ReferenceScene& scene, const AccuracyLevel& level);
};

/** The features that tell kernels apart. A filtered key's bits of these are those of one kernel. */
std::uint64_t chosenFeatures();
const std::vector<PictureKernel>& pictureKernels();

} // namespace tetmarch

#endif
