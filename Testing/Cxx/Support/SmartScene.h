// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A window with a volume of structured data in it, drawn by any mapper of images
 */
#ifndef tetmarch_testing_SmartScene_h
#define tetmarch_testing_SmartScene_h

#include "vtkTetMarchSmartVolumeMapper.h"

#include "LatticeImages.h"
#include "Scene.h"

#include "vtkFloatArray.h"

namespace tetmarch::testing
{
struct SmartScene
{
  /// Linear interpolation, the bumpy functions, unit distance 0.25, seen by lookAtUnitCube().
  explicit SmartScene(vtkDataObject* data, int width = SceneSize, int height = SceneSize)
    : Data(data)
    , Window(makeWindow(width, height))
  {
    this->Mapper->SetInputDataObject(data);
    this->Volume->SetMapper(this->Mapper);
    setBumpyFunctions(this->property());
    this->property()->SetScalarOpacityUnitDistance(0.25);
    this->property()->SetInterpolationTypeToLinear();
    this->Renderer->AddVolume(this->Volume);
    this->Window->AddRenderer(this->Renderer);
    lookAtUnitCube(this->Renderer->GetActiveCamera());
  }
  SmartScene(const SmartScene&) = delete;
  SmartScene& operator=(const SmartScene&) = delete;

  vtkVolumeProperty* property() { return this->Volume->GetProperty(); }

  Image frame()
  {
    this->Window->Render();
    return framePictureOf(this->Window);
  }
  /// The same drawn by another mapper, which gets the data.
  Image frameBy(vtkSmartVolumeMapper* mapper)
  {
    mapper->SetInputDataObject(this->Data);
    this->Volume->SetMapper(mapper);
    const Image image = this->frame();
    this->Volume->SetMapper(this->Mapper);
    return image;
  }
  /// One frame with diagnostics; the colours before they are rounded.
  Image floats()
  {
    this->Mapper->CollectDiagnosticsOn();
    this->Window->Render();
    this->Mapper->CollectDiagnosticsOff();
    vtkNew<vtkFloatArray> pixels;
    this->Mapper->GetDiagnosticPixels(pixels);
    const int* size = this->Renderer->GetSize();
    return Image::fromFloats(size[0], size[1], pixels->GetPointer(0));
  }

  vtkSmartPointer<vtkDataObject> Data;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkTetMarchSmartVolumeMapper> Mapper;
};

/// As finely as VTK's mapper does: it goes by the spacing, whatever its sample distance is.
inline void sampleFinely(vtkSmartVolumeMapper* mapper)
{
  mapper->InteractiveAdjustSampleDistancesOff();
  mapper->AutoAdjustSampleDistancesOff();
}
} // namespace tetmarch::testing

#endif
