// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The last frame of a vtkTetMarchVolumeMapper in numbers: its pixels, and the ground truth of them.
#include "vtkTetMarchVolumeMapperInternals.h"

#include "Mapper/FrameMeasures.h"

#include "vtkFloatArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkVolume.h"

#include <algorithm>

//------------------------------------------------------------------------------
bool vtkTetMarchVolumeMapper::RenderGroundTruth(vtkVolume* volume, vtkFloatArray* pixels)
{
  tetmarch::ReferenceImage image;
  if (vtkOpenGLRenderWindow* window = this->Internal->Pipeline.window())
  {
    window->MakeCurrent();
  }
  if (!volume || !this->Internal->Pipeline.renderReference(volume->GetProperty(),
                   static_cast<tetmarch::OpacityLaw>(this->GetOpacityLaw()), image))
  {
    vtkErrorMacro("No reference picture: " << (volume ? this->Internal->Pipeline.error()
                                                      : std::string("no volume was given.")));
    return false;
  }
  pixels->SetNumberOfComponents(4);
  pixels->SetNumberOfTuples(static_cast<vtkIdType>(image.Pixels.size() / 4));
  std::copy(image.Pixels.begin(), image.Pixels.end(), pixels->GetPointer(0));
  return true;
}

//------------------------------------------------------------------------------
bool vtkTetMarchVolumeMapper::CompareWithGroundTruth(vtkVolume* volume)
{
  const tetmarch::Diagnostics& counted = this->Internal->Pipeline.counted();
  if (counted.measures().empty())
  {
    vtkErrorMacro("There is no frame to compare: switch CollectDiagnostics on and render first.");
    return false;
  }
  vtkNew<vtkFloatArray> truth;
  if (!this->RenderGroundTruth(volume, truth))
  {
    return false;
  }
  tetmarch::takeTrueErrors(counted, truth, this->Internal->Statistics);
  return true;
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::GetDiagnosticPixels(vtkFloatArray* pixels) const
{
  const std::vector<float>& values = this->Internal->Pipeline.counted().pixels();
  pixels->SetNumberOfComponents(4);
  pixels->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / 4));
  std::copy(values.begin(), values.end(), pixels->GetPointer(0));
}
