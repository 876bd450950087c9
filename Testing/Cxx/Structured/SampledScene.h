// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scene of the accuracy level Sampled
 */
#ifndef tetmarch_testing_SampledScene_h
#define tetmarch_testing_SampledScene_h

#include "StructuredScene.h"

namespace tetmarch::testing
{
/// Two samples to a voxel of six along an edge, seen from a corner.
struct SampledScene : StructuredScene
{
  explicit SampledScene(vtkDataSet* data, double distance = 1.0 / 12)
    : StructuredScene(data)
  {
    this->Mapper->SetAccuracyLevelToSampled();
    this->Mapper->InteractiveAdjustSampleDistancesOff();
    this->Mapper->AutoAdjustSampleDistancesOff();
    this->Mapper->SetSampleDistance(static_cast<float>(distance));
  }
};
} // namespace tetmarch::testing

#endif
