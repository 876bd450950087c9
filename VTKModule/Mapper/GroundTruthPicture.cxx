// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mapper/GroundTruthPicture.h"

#include "GL/Pipeline.h"
#include "Mapper/FrameMeasures.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkVolume.h"

#include <algorithm>
#include <sstream>

namespace tetmarch
{
namespace
{

void copyPixels(const std::vector<float>& values, vtkFloatArray* pixels)
{
  pixels->SetNumberOfComponents(4);
  pixels->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / 4));
  std::copy(values.begin(), values.end(), pixels->GetPointer(0));
}

} // namespace

bool renderGroundTruth(const GroundTruthOf& frame, vtkFloatArray* pixels, std::string& error)
{
  ReferenceImage image;
  error.clear();
  frame.Drawn.makeCurrent();
  if (!frame.Volume)
  {
    error = "No reference picture: no volume was given.";
    return false;
  }
  if (!(frame.Tolerance > 0.0 && frame.Tolerance <= 1.0))
  {
    std::ostringstream wrong;
    wrong << "No reference picture: its tolerance is greater than 0 and at most 1, not "
          << frame.Tolerance << '.';
    error = wrong.str();
    return false;
  }
  AccuracyLevel level = GroundTruthAccuracy;
  level.ErrorTolerance = frame.Tolerance;
  const StageResult result =
    frame.Drawn.renderReference(frame.Volume->GetProperty(), level, frame.Report, image);
  if (!result.isDone())
  {
    error = result.Error.empty() ? std::string() : "No reference picture: " + result.Error;
    return false;
  }
  copyPixels(image.Pixels, pixels);
  return true;
}

bool compareWithGroundTruth(
  const GroundTruthOf& frame, vtkTetMarchFrameStatistics* statistics, std::string& error)
{
  const Diagnostics& counted = frame.Drawn.counted();
  if (counted.measures().empty())
  {
    error = "There is no frame to compare: switch CollectDiagnostics on and render first.";
    return false;
  }
  vtkNew<vtkFloatArray> truth;
  const bool done = renderGroundTruth(frame, truth, error);
  if (done)
  {
    takeTrueErrors(counted, truth, statistics);
  }
  return done;
}

void copyDiagnosticPixels(const Pipeline& pipeline, vtkFloatArray* pixels)
{
  copyPixels(pipeline.counted().pixels(), pixels);
}

} // namespace tetmarch
