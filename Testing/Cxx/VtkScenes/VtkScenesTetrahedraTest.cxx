// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// After VTK's TestProjectedTetrahedra, ProjectedTetrahedraZoomIn, TestProjectedTetrahedraTransform,
// TestProjectedTetrahedraOffscreen and TestProjectedTetrahedraVectorComponent.
#include "CpuReference.h"
#include "CubePicture.h"
#include "VtkScene.h"

#include "vtkActor.h"
#include "vtkCellTypeSource.h"
#include "vtkConeSource.h"
#include "vtkContourFilter.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProjectedTetrahedraMapper.h"
#include "vtkProperty.h"
#include "vtkRectilinearGrid.h"
#include "vtkRectilinearGridToTetrahedra.h"
#include "vtkThreshold.h"
#include "vtkTransform.h"
#include "vtkWindowToImageFilter.h"

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 120;

// The cells of a wavelet that are above a value, about the contour of a greater one.
class Thresholded : public testing::Test
{
protected:
  Thresholded()
  {
    this->Rival->SetInputData(this->Shown.Data);
    setFunctions(this->Shown.property(), 140.0, 270.0, 0.3);
    this->Shown.property()->SetScalarOpacityUnitDistance(1.0);
    vtkNew<vtkContourFilter> contour;
    contour->SetInputData(makeWavelet());
    contour->SetValue(0, 225.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(contour->GetOutputPort());
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Shown.Renderer->AddActor(actor);
    this->Shown.Renderer->ResetCamera();
  }

  static Grid above(double value)
  {
    vtkNew<vtkThreshold> threshold;
    threshold->SetInputData(makeWavelet());
    threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_UPPER);
    threshold->SetUpperThreshold(value);
    threshold->AllScalarsOff();
    threshold->Update();
    return tetrahedraOf(threshold->GetOutput());
  }

  Scene Shown{ above(140.0), Side, Side };
  vtkNew<vtkProjectedTetrahedraMapper> Rival;
};

// The rival is cut by surfaces at whole cells, and mixes 8-bit colours.
TEST_F(Thresholded, Whole)
{
  vtkCamera* camera = this->Shown.camera();
  camera->SetPosition(0.0, 0.0, 1.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  this->Shown.Renderer->ResetCamera();
  camera->Azimuth(20.0);
  camera->Elevation(10.0);
  camera->Zoom(1.5);
  expectParityWithOpaque(this->Shown);
  expectLike(this->Shown, this->Rival, 5.0);
}

// From inside.
TEST_F(Thresholded, ZoomedIn)
{
  vtkCamera* camera = this->Shown.camera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(2.9, 1.5, 8.2);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetViewAngle(40.0);
  camera->SetClippingRange(0.1, 40.0);
  expectParityWithOpaque(this->Shown);
  expectLike(this->Shown, this->Rival, 5.0);
}

// One red and one blue cube of extinction 1, with a cone of their colour in each.
class Cubes : public testing::Test
{
protected:
  struct Cube
  {
    Vec3 Corner;
    vtkNew<vtkTetMarchVolumeMapper> Mapper;
    vtkNew<vtkVolume> Volume;
    vtkNew<vtkActor> Cone;
  };

  Cubes()
  {
    vtkNew<vtkDoubleArray> ends;
    ends->InsertNextValue(0.0);
    ends->InsertNextValue(1.0);
    vtkNew<vtkRectilinearGrid> grid;
    grid->SetDimensions(2, 2, 2);
    grid->SetXCoordinates(ends);
    grid->SetYCoordinates(ends);
    grid->SetZCoordinates(ends);
    vtkNew<vtkRectilinearGridToTetrahedra> cut;
    cut->SetInputData(grid);
    cut->Update();
    vtkUnstructuredGrid* tetrahedra = cut->GetOutput();
    vtkNew<vtkDoubleArray> zeros;
    zeros->SetNumberOfTuples(tetrahedra->GetNumberOfPoints());
    zeros->Fill(0.0);
    tetrahedra->GetPointData()->SetScalars(zeros);
    for (int i = 0; i < 2; ++i)
    {
      Cube& cube = this->Both[i];
      cube.Corner = { 2.0 * i, 2.0 * i, 0.0 };
      cube.Mapper->SetInputData(tetrahedra);
      cube.Mapper->CollectDiagnosticsOn();
      cube.Volume->SetMapper(cube.Mapper);
      vtkNew<vtkColorTransferFunction> colour;
      colour->AddRGBPoint(0.0, 1.0 - i, 0.0, i);
      cube.Volume->GetProperty()->SetColor(colour);
      vtkNew<vtkTransform> transform;
      transform->Translate(cube.Corner.data());
      cube.Volume->SetUserTransform(transform);
      vtkNew<vtkConeSource> cone;
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(cone->GetOutputPort());
      cube.Cone->SetMapper(mapper);
      cube.Cone->GetProperty()->SetColor(1.0 - i, 0.0, i);
      cube.Cone->SetUserTransform(transform);
    }
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetBackground(1.0, 1.0, 1.0);
  }

  void lookAtAll()
  {
    this->Renderer->ResetCamera();
    this->Renderer->GetActiveCamera()->Azimuth(20.0);
    this->Renderer->GetActiveCamera()->Elevation(-15.0);
    this->Renderer->ResetCameraClippingRange();
  }

  void expectClosedForm(Cube& cube)
  {
    expectCube(floatPictureOf(cube.Mapper, Side, Side), this->Renderer->GetActiveCamera(),
      cube.Corner, 1.0, 500);
  }

  vtkSmartPointer<vtkRenderWindow> Window = makeWindow(Side, Side);
  vtkNew<vtkRenderer> Renderer;
  Cube Both[2];
};

TEST_F(Cubes, BesideEachOther)
{
  for (Cube& cube : this->Both)
  {
    this->Renderer->AddVolume(cube.Volume);
  }
  this->lookAtAll();
  this->Window->Render();
  for (Cube& cube : this->Both)
  {
    this->expectClosedForm(cube);
  }
  for (Cube& cube : this->Both)
  {
    this->Renderer->AddActor(cube.Cone);
  }
  this->Window->Render();
  for (Cube& cube : this->Both)
  {
    expectReference(cube.Mapper, cube.Volume, Side, Side);
  }
}

// Both in a first frame, one with the other's cone in the next, which a filter reads, and none
// after the window's end.
TEST_F(Cubes, ComeAndGo)
{
  this->Window->SetOffScreenRendering(false);
  for (Cube& cube : this->Both)
  {
    this->Renderer->AddVolume(cube.Volume);
  }
  this->Window->Render();
  for (Cube& cube : this->Both)
  {
    this->Renderer->RemoveVolume(cube.Volume);
  }
  this->Window->SetOffScreenRendering(true);
  this->Renderer->SetBackground(0.4, 0.8, 0.4);
  this->Renderer->AddVolume(this->Both[1].Volume);
  this->lookAtAll();
  this->Window->Render();
  this->expectClosedForm(this->Both[1]);
  this->Renderer->AddActor(this->Both[0].Cone);
  this->Renderer->ResetCamera();
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(this->Window);
  filter->Update();
  expectReference(this->Both[1].Mapper, this->Both[1].Volume, Side, Side);
  const Image frame = framePictureOf(this->Window);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_EQ(filter->GetOutput()->GetScalarComponentAsFloat(Side / 3, Side / 3, 0, k),
      std::round(255.0f * frame.pixel(Side / 3, Side / 3)[k]));
  }
  this->Renderer->RemoveVolume(this->Both[1].Volume);
  this->Window->Finalize();
  this->Window->Render();
  EXPECT_EQ(this->Both[1].Mapper->GetGPUMemoryBytes(), 0);
}

// Coordinates as vectors: what is shown of them is what the colour function says.
TEST(VectorComponent, OfCoordinates)
{
  vtkNew<vtkCellTypeSource> source;
  source->SetCellType(VTK_TETRA);
  source->SetBlocksDimensions(10, 10, 10);
  source->Update();
  vtkUnstructuredGrid* grid = source->GetOutput();
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->DeepCopy(grid->GetPoints()->GetData());
  coordinates->SetName("coords");
  grid->GetPointData()->AddArray(coordinates);
  const char* names[] = { "x", "y", "z" };
  for (int k = 0; k < 3; ++k)
  {
    vtkNew<vtkDoubleArray> one;
    one->SetName(names[k]);
    one->SetNumberOfTuples(coordinates->GetNumberOfTuples());
    one->CopyComponent(0, coordinates, k);
    grid->GetPointData()->AddArray(one);
  }
  Scene scene(grid, Side, Side);
  setFunctions(scene.property(), 0.0, 10.0, 0.2);
  scene.property()->SetScalarOpacityUnitDistance(1.0);
  scene.camera()->SetPosition(25.0, 20.0, 30.0);
  scene.camera()->SetFocalPoint(5.0, 5.0, 5.0);
  scene.Renderer->ResetCameraClippingRange();
  scene.Mapper->SetScalarModeToUsePointFieldData();
  vtkNew<vtkProjectedTetrahedraMapper> rival;
  rival->SetInputData(grid);
  rival->SetScalarModeToUsePointFieldData();
  rival->SelectScalarArray("coords");
  vtkColorTransferFunction* colours = scene.property()->GetRGBTransferFunction();
  for (int k = 0; k < 3; ++k)
  {
    scene.Mapper->SelectScalarArray(names[k]);
    const Image expected = scene.render();
    colours->SetVectorModeToComponent();
    colours->SetVectorComponent(k);
    scene.Mapper->SelectScalarArray("coords");
    EXPECT_EQ(scene.render().Rgba, expected.Rgba) << names[k];
    expectParity(scene);
    expectLike(scene, rival, 2.0, names[k]);
  }
}
} // namespace
