// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mapper/GroundTruthPicture.h"

#include "GL/Pipeline.h"
#include "Mapper/FrameMeasures.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkTetMarchSettings.h"
#include "vtkVolume.h"

#include <algorithm>

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

std::string renderGroundTruth(
  Pipeline& pipeline, vtkTetMarchSettings* settings, vtkVolume* volume, vtkFloatArray* pixels)
{
  ReferenceImage image;
  pipeline.makeCurrent();
  if (!volume || !pipeline.renderReference(volume->GetProperty(),
                   static_cast<OpacityLaw>(settings->GetOpacityLaw()), image))
  {
    return "No reference picture: " + (volume ? pipeline.error() : "no volume was given.");
  }
  copyPixels(image.Pixels, pixels);
  return {};
}

std::string compareWithGroundTruth(Pipeline& pipeline, vtkTetMarchSettings* settings,
  vtkVolume* volume, vtkTetMarchFrameStatistics* statistics)
{
  const Diagnostics& counted = pipeline.counted();
  if (counted.measures().empty())
  {
    return "There is no frame to compare: switch CollectDiagnostics on and render first.";
  }
  vtkNew<vtkFloatArray> truth;
  std::string error = renderGroundTruth(pipeline, settings, volume, truth);
  if (error.empty())
  {
    takeTrueErrors(counted, truth, statistics);
  }
  return error;
}

void copyDiagnosticPixels(const Pipeline& pipeline, vtkFloatArray* pixels)
{
  copyPixels(pipeline.counted().pixels(), pixels);
}

} // namespace tetmarch
