// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The pixels of a pipeline's last frame, and the ground truth of them.
#ifndef TetMarchMapperGroundTruthPicture_h
#define TetMarchMapperGroundTruthPicture_h

#include <string>

class vtkFloatArray;
class vtkTetMarchFrameStatistics;
class vtkTetMarchSettings;
class vtkVolume;

namespace tetmarch
{

class Pipeline;

// Pixels are premultiplied red, green, blue and opacity, rows from the bottom. These two return an
// empty string, or why there is no such picture.

std::string renderGroundTruth(
  Pipeline& pipeline, vtkTetMarchSettings* settings, vtkVolume* volume, vtkFloatArray* pixels);
/** The true errors of a frame that was counted go to the statistics. */
std::string compareWithGroundTruth(Pipeline& pipeline, vtkTetMarchSettings* settings,
  vtkVolume* volume, vtkTetMarchFrameStatistics* statistics);

/** Of the last frame that was counted; none if there was no such frame. */
void copyDiagnosticPixels(const Pipeline& pipeline, vtkFloatArray* pixels);

} // namespace tetmarch

#endif
