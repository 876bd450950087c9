// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes of VTK's tests about what data are like, and where.
#include "ImageScene.h"

#include "LatticeImages.h"
#include "VtkScene.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkUniformGrid.h"

#include <cmath>

namespace tetmarch::testing
{
namespace
{
using Data = vtkSmartPointer<vtkDataSet>;
using Arrange = std::function<void(ImageStage&)>;

// Of fields with values in 0..1.
Arrange usual(double unitDistance)
{
  return [=](ImageStage& stage)
  {
    setFunctions(stage.Property, 0.0, 1.0, 0.4);
    stage.Property->SetScalarOpacityUnitDistance(unitDistance);
  };
}

Arrange nearest(double unitDistance)
{
  return [=](ImageStage& stage)
  {
    usual(unitDistance)(stage);
    stage.Property->SetInterpolationTypeToNearest();
  };
}

Arrange ofCells(const Arrange& arrange)
{
  return [=](ImageStage& stage)
  {
    arrange(stage);
    stage.Mapper->SetScalarModeToUseCellData();
  };
}

void waveletFunctions(ImageStage& stage) { setFunctions(stage.Property, 40.0, 280.0, 0.15); }

void windowLevel(ImageStage& stage)
{
  waveletFunctions(stage);
  stage.Mapper->SetFinalColorWindow(1.6);
  stage.Mapper->SetFinalColorLevel(0.7);
}

void thinShell(ImageStage& stage)
{
  vtkNew<vtkColorTransferFunction> colours;
  colours->AddRGBPoint(0.0, 0.0, 0.0, 1.0);
  colours->AddRGBPoint(40.0, 1.0, 0.0, 0.0);
  colours->AddRGBPoint(255.0, 1.0, 1.0, 1.0);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(0.0, 0.0);
  opacities->AddPoint(80.0, 0.95);
  opacities->AddPoint(80.1, 0.0);
  opacities->AddPoint(255.0, 0.0);
  stage.Property->SetColor(colours);
  stage.Property->SetScalarOpacity(opacities);
  stage.Property->SetInterpolationTypeToLinear();
}

void mirrored(ImageStage& stage)
{
  setFunctions(stage.Property, 50.0, 255.0, 0.3);
  stage.Volume->SetScale(1.0, -1.0, 1.0);
}

void stretched(ImageStage& stage)
{
  usual(1.0)(stage);
  stage.Volume->SetScale(1.0, 2.0, 0.5);
  stage.Volume->SetOrientation(10.0, 20.0, 30.0);
}

void inParallel(ImageStage& stage)
{
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetPosition(0.1, 0.2, 1.0);
  stage.Renderer->ResetCamera();
}

Data wavelet() { return makeWavelet(); }
Data shell() { return makeShell(); }
Data uneven() { return rectilinearOf(sineField(), unevenCube(14)); }

// Points at distances of 1.
std::function<Data()> cube(const Field& field, int n)
{
  return [=]() -> Data
  {
    ImagePlace place = unitCube(n);
    place.Spacing = { 1.0, 1.0, 1.0 };
    return imageOf(field, place);
  };
}

Data makeOriented()
{
  ImagePlace place;
  place.Extent = { 0, 16, 0, 16, 0, 16 };
  place.Origin = { 200.0, 100.0, 40.0 };
  place.Spacing = { 3.2, 3.2, 1.5 };
  place.Direction = { 0.9397, -0.3420, 0.0, 0.3420, 0.9397, 0.0, 0.0, 0.0, 1.0 };
  return imageOf(sineField(), place);
}

Data makeScaled()
{
  ImagePlace place;
  place.Extent = { 0, 16, 0, 16, 0, 16 };
  place.Origin = { 10.0, 20.0, 30.0 };
  place.Spacing = { 1.0, 2.0, 3.0 };
  return imageOf(sineField(), place);
}

Data makeSlab()
{
  ImagePlace place;
  place.Extent = { 0, 8, 0, 8, 0, 1 };
  return imageOf(sineField(), place);
}

// The square of the distance from the middle, in bytes, on [-1, 1]^3.
Data makeParaboloid()
{
  ImagePlace place = unitCube(62);
  place.Origin = { -1.0, -1.0, -1.0 };
  place.Spacing = { 2.0 / 62, 2.0 / 62, 2.0 / 62 };
  const Field away = radialField();
  const auto image =
    imageOf([away](double x, double y, double z) { return away(x, y, z) * away(x, y, z); }, place);
  for (vtkDataArray* array :
    { image->GetPointData()->GetScalars(), image->GetCellData()->GetScalars() })
  {
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      array->SetComponent(i, 0, std::floor(255.0 * array->GetComponent(i, 0) + 0.5));
    }
  }
  return image;
}

// What is hidden of a wavelet of 18^3 cells: columns of cells and of points, as long as so many
// layers of them.
TupleFilter columnOfCells(int layers)
{
  return [=](vtkIdType id)
  {
    const vtkIdType i = id % 18;
    const vtkIdType j = id / 18 % 18;
    return i >= 6 && i < 12 && j >= 4 && j < 13 && id / (18 * 18) < layers;
  };
}
TupleFilter columnOfPoints(int layers)
{
  return [=](vtkIdType id)
  {
    const vtkIdType j = id / 19 % 19;
    return id % 19 >= 14 && j >= 4 && j < 13 && id / (19 * 19) < layers;
  };
}

Data makeBlanked()
{
  vtkNew<vtkUniformGrid> grid;
  grid->ShallowCopy(makeWavelet(9));
  markCells(grid, vtkDataSetAttributes::HIDDENCELL, columnOfCells(5));
  markPoints(grid, vtkDataSetAttributes::HIDDENPOINT, columnOfPoints(5));
  return Data(grid);
}

// One kind of ghosts after the other.
Data makeWithGhosts()
{
  const auto image = makeWavelet(9);
  const int kinds[] = { vtkDataSetAttributes::HIDDENCELL, vtkDataSetAttributes::DUPLICATECELL,
    vtkDataSetAttributes::REFINEDCELL };
  for (int kind = 0; kind < 3; ++kind)
  {
    markCells(image, kinds[kind],
      [=](vtkIdType id) { return columnOfCells(18)(id) && id / (18 * 18) / 6 == kind; });
  }
  markPoints(image, vtkDataSetAttributes::HIDDENPOINT,
    [](vtkIdType id) { return columnOfPoints(9)(id) && id / 19 % 19 < 9; });
  markPoints(image, vtkDataSetAttributes::DUPLICATEPOINT,
    [](vtkIdType id) { return columnOfPoints(9)(id) && id / 19 % 19 >= 9; });
  return image;
}

Data makeLabels()
{
  const auto image = imageOf(noiseField(4, 12), unitCube(12));
  for (vtkDataArray* array :
    { image->GetPointData()->GetScalars(), image->GetCellData()->GetScalars() })
  {
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      array->SetComponent(i, 0, std::floor(5022.0 * array->GetComponent(i, 0)));
    }
  }
  return image;
}

// A step at each of 5,023 labels: every third is seen.
void labelFunctions(ImageStage& stage)
{
  vtkNew<vtkColorTransferFunction> colours;
  vtkNew<vtkPiecewiseFunction> opacities;
  for (int i = 0; i < 5023; ++i)
  {
    colours->AddRGBPoint(i, i % 7 / 6.0, i % 11 / 10.0, i % 13 / 12.0, 0.5, 1.0);
    opacities->AddPoint(i, i % 3 == 0 ? 0.8 : 0.0, 0.5, 1.0);
  }
  stage.Property->SetColor(colours);
  stage.Property->SetScalarOpacity(opacities);
  stage.Property->SetScalarOpacityUnitDistance(0.2);
  stage.Property->SetInterpolationTypeToNearest();
}
} // namespace

std::vector<ImageScene> imageDataScenes()
{
  const char* besideItsPlace = "values of rectilinear grids are half a cell beside their place";
  const RivalError steps = { 2.0, "its steps miss the ends of short ways" };
  const RivalError neighbours = { 1.8, "it hides the neighbours of what is hidden, too" };
  return {
    { "SmartVolumeMapper", makeParaboloid, thinShell, {} },
    { "SmartVolumeMapperWindowLevel", wavelet, windowLevel, {}, {}, true,
      "window and level are not applied yet" },
    { "GPURayCastMapperSampleDistance", wavelet, waveletFunctions, {} },
    { "GPURayCastMapperRectilinearGrid", uneven, usual(0.1), { 30.0, besideItsPlace } },
    { "GPURayCastMapperRectilinearGrid, cells", uneven, ofCells(usual(0.1)),
      { 45.0, besideItsPlace } },
    { "GPURayCastMapperRectilinearGrid, nearest", uneven, nearest(0.1), { 35.0, besideItsPlace } },
    { "GPURayCastCellData", cube(sineField(), 12), ofCells(usual(1.0)), steps },
    { "GPURayCastCellData, nearest", cube(sineField(), 12), ofCells(nearest(1.0)), steps },
    { "GPURayCastNearest", cube(sineField(), 12), nearest(1.0), steps },
    { "GPURayCastVolumeOrientation", shell, mirrored, {} },
    { "GPURayCastOrientedVolume", makeOriented, usual(3.0), {} },
    { "GPURayCastVolumeScale", makeScaled, usual(2.0), {} },
    { "GPURayCastVolumeScale, by the matrix", cube(sineField(), 16), stretched, {} },
    { "GPURayCastVolumeUniformGridBlanking", makeBlanked, waveletFunctions, neighbours },
    { "GPURayCastVolumeGhostArrays", makeWithGhosts, waveletFunctions,
      { 15.0, "it hides duplicate points, and neighbours of what is hidden" } },
    { "GPURayCastLargeColorTransferFunction", makeLabels, labelFunctions,
      { 25.0, "it has 4,096 table entries for 5,023 labels" }, inParallel },
    { "GPURayCastTextureStreaming", cube(marschnerLobbField(), 40), usual(3.0), {} },
    { "one cell thick", makeSlab, usual(1.0), steps },
  };
}
} // namespace tetmarch::testing
