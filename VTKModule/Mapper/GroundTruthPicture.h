// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The pixels of a pipeline's last frame, and the ground truth of them.
#ifndef TetMarchMapperGroundTruthPicture_h
#define TetMarchMapperGroundTruthPicture_h

#include "Optics/AccuracyLevel.h"
#include "Parallel/Progress.h"

#include <string>

class vtkFloatArray;
class vtkTetMarchFrameStatistics;
class vtkVolume;

namespace tetmarch
{

class Pipeline;

/** What is drawn once more, progress may ask to stop. */
struct GroundTruthOf
{
  Pipeline& Drawn;
  vtkVolume* Volume;
  Progress Report;
  double Tolerance = GroundTruthAccuracy.ErrorTolerance;
};

// Pixels are premultiplied red, green, blue and opacity, rows from the bottom. These two return
// whether it was done. If not, the error says why there is no such picture; it is empty if progress
// asked to stop.

bool renderGroundTruth(const GroundTruthOf& frame, vtkFloatArray* pixels, std::string& error);
/** The true errors of a frame that was counted go to the statistics. */
bool compareWithGroundTruth(
  const GroundTruthOf& frame, vtkTetMarchFrameStatistics* statistics, std::string& error);

/** Of the last frame that was counted; none if there was no such frame. */
void copyDiagnosticPixels(const Pipeline& pipeline, vtkFloatArray* pixels);

} // namespace tetmarch

#endif
