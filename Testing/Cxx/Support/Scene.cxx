// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include "Lights.h"

#include "OffscreenWindow.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <stdexcept>

namespace tetmarch::testing
{
namespace
{
vtkSmartPointer<vtkActor> flatActor(
  vtkPolyDataAlgorithm* source, const std::array<double, 3>& colour)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  return actor;
}
} // namespace

vtkSmartPointer<vtkRenderWindow> makeWindow(int width, int height)
{
  std::string error;
  auto window = MakeOffscreenWindow(width, height, &error);
  if (!window)
  {
    throw std::runtime_error(error);
  }
  return window;
}

void setBumpyFunctions(vtkVolumeProperty* property)
{
  vtkNew<vtkColorTransferFunction> colour;
  colour->AddRGBPoint(0.0, 0.1, 0.2, 1.0);
  colour->AddRGBPoint(0.45, 0.1, 1.0, 0.3);
  colour->AddRGBPoint(0.55, 1.0, 0.9, 0.0);
  colour->AddRGBPoint(1.0, 1.0, 0.1, 0.1);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.6);
  opacity->AddPoint(0.4, 0.1);
  opacity->AddPoint(0.5, 0.9);
  opacity->AddPoint(0.6, 0.02);
  opacity->AddPoint(1.0, 0.8);
  property->SetColor(colour);
  property->SetScalarOpacity(opacity);
}

void setSpikyFunctions(vtkVolumeProperty* property)
{
  setBumpyFunctions(property);
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
  opacity->RemoveAllPoints();
  for (const double middle : { 0.2, 0.45, 0.5, 0.8 })
  {
    opacity->AddPoint(middle - 0.004, 0.0);
    opacity->AddPoint(middle, 1.0);
    opacity->AddPoint(middle + 0.004, 0.0);
  }
}

void setTwoPeaks(vtkVolumeProperty* property)
{
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
  opacity->RemoveAllPoints();
  for (const double peak : { 0.3, 0.7 })
  {
    opacity->AddPoint(peak - 0.1, 0.0);
    opacity->AddPoint(peak, 0.8);
    opacity->AddPoint(peak + 0.1, 0.0);
  }
}

void setGradientOpacity(vtkVolumeProperty* property)
{
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.0, 0.1);
  function->AddPoint(1.5, 0.2);
  function->AddPoint(3.5, 1.0);
  property->SetGradientOpacity(function);
}

void setShading(vtkVolumeProperty* property)
{
  property->ShadeOn();
  property->SetAmbient(0.25);
  property->SetDiffuse(0.7);
  property->SetSpecular(0.4);
  property->SetSpecularPower(12.0);
}

void setWakeFunctions(vtkVolumeProperty* property)
{
  vtkNew<vtkColorTransferFunction> colour;
  colour->SetColorSpaceToLab();
  colour->AddRGBPoint(0.15, 0.05, 0.15, 0.45);
  colour->AddRGBPoint(0.8, 0.15, 0.45, 0.85);
  colour->AddRGBPoint(2.0, 0.75, 0.9, 1.0);
  colour->AddRGBPoint(4.0, 1.0, 0.85, 0.55);
  colour->AddRGBPoint(8.0, 0.95, 0.4, 0.1);
  colour->AddRGBPoint(20.0, 0.55, 0.25, 0.15);
  colour->AddRGBPoint(45.0, 0.45, 0.45, 0.5);
  colour->AddRGBPoint(155.0, 1.0, 1.0, 1.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  const double nodes[][2] = { { 0.15, 0.0 }, { 0.8, 0.004 }, { 2.0, 0.012 }, { 5.0, 0.05 },
    { 12.0, 0.08 }, { 40.0, 0.1 }, { 70.0, 1.0 }, { 155.0, 1.0 } };
  for (const auto& node : nodes)
  {
    opacity->AddPoint(node[0], node[1]);
  }
  property->SetColor(colour);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(0.02);
}

void setPlainFunctions(
  vtkVolumeProperty* property, const std::array<double, 3>& colour, double opacity)
{
  vtkNew<vtkColorTransferFunction> colours;
  colours->AddRGBPoint(0.5, colour[0], colour[1], colour[2]);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(0.5, opacity);
  property->SetColor(colours);
  property->SetScalarOpacity(opacities);
}

void lookAtUnitCube(vtkCamera* camera)
{
  camera->SetPosition(2.1, 1.4, 2.9);
  camera->SetFocalPoint(0.5, 0.45, 0.5);
  camera->SetViewUp(0.1, 1.0, 0.0);
  camera->SetClippingRange(0.5, 10.0);
}

void lookDownZ(vtkCamera* camera, double scale)
{
  camera->ParallelProjectionOn();
  camera->SetParallelScale(scale);
  camera->SetPosition(0.5, 0.5, 3.0);
  camera->SetFocalPoint(0.5, 0.5, 0.5);
  camera->SetViewUp(0.0, 1.0, 0.0);
}

void lookFromInside(vtkCamera* camera)
{
  camera->SetPosition(0.31, 0.42, 0.57);
  camera->SetFocalPoint(1.0, 0.6, 0.4);
  camera->SetClippingRange(0.01, 5.0);
}

Image floatPictureOf(vtkTetMarchVolumeMapper* mapper, int width, int height)
{
  vtkNew<vtkFloatArray> pixels;
  mapper->GetDiagnosticPixels(pixels);
  if (pixels->GetNumberOfTuples() != vtkIdType(width) * height)
  {
    throw std::runtime_error("the last frame left " + std::to_string(pixels->GetNumberOfTuples()) +
                             " diagnostic pixels instead of " + std::to_string(width) + " x " +
                             std::to_string(height));
  }
  return Image::fromFloats(width, height, pixels->GetPointer(0));
}

Image framePictureOf(vtkRenderWindow* window)
{
  const int* size = window->GetActualSize();
  vtkNew<vtkUnsignedCharArray> bytes;
  window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 1, bytes);
  return Image::fromBytes(size[0], size[1], bytes->GetPointer(0));
}

Image cropped(const Image& image, int x, int y, int width, int height)
{
  Image part(width, height);
  for (int row = 0; row < height; ++row)
  {
    std::copy_n(image.pixel(x, y + row), 4 * width, part.pixel(0, row));
  }
  return part;
}

vtkSmartPointer<vtkActor> makePlane(
  double height, double margin, const std::array<double, 3>& colour)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-margin, -margin, height);
  plane->SetPoint1(1.0 + margin, -margin, height);
  plane->SetPoint2(-margin, 1.0 + margin, height);
  return flatActor(plane, colour);
}

vtkSmartPointer<vtkActor> makeBall(
  const Vec3& centre, double radius, const std::array<double, 3>& colour)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(centre[0], centre[1], centre[2]);
  ball->SetRadius(radius);
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(24);
  return flatActor(ball, colour);
}

Scene::Scene(vtkUnstructuredGrid* grid, int width, int height)
  : Data(grid)
  , Window(makeWindow(width, height))
{
  this->Mapper->SetInputData(grid);
  this->Mapper->CollectDiagnosticsOn();
  this->Volume->SetMapper(this->Mapper);
  setBumpyFunctions(this->property());
  this->property()->SetScalarOpacityUnitDistance(0.25);
  this->Renderer->AddVolume(this->Volume);
  this->Window->AddRenderer(this->Renderer);
  lookAtUnitCube(this->camera());
}

void Scene::drawCellScalars(const char* name)
{
  this->Mapper->SetScalarModeToUseCellFieldData();
  this->Mapper->SelectScalarArray(name);
}

Image Scene::render()
{
  this->Window->Render();
  const int* size = this->Renderer->GetSize();
  return floatPictureOf(this->Mapper, size[0], size[1]);
}

std::vector<float> windowDepthsOf(vtkRenderWindow* window)
{
  const int* size = window->GetSize();
  vtkNew<vtkFloatArray> depths;
  window->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, depths);
  return { depths->GetPointer(0), depths->GetPointer(0) + depths->GetNumberOfTuples() };
}

vtkSmartPointer<vtkLight> addLight(Scene& scene, double x, double y, double z)
{
  return addLight(scene.Renderer, x, y, z);
}
} // namespace tetmarch::testing
