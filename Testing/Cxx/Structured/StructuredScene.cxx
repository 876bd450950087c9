// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StructuredScene.h"

#include "FreshFrame.h"
#include "Lights.h"
#include "MapperFrameInput.h"
#include "ScenePage.h"

#include "vtkContourValues.h"
#include "vtkFloatArray.h"
#include "vtkTetMarchFrameStatistics.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <stdexcept>

namespace tetmarch::testing
{
namespace
{
using Mapper = vtkTetMarchSmartVolumeMapper;

// What the bound leaves out: the arithmetic of float, most of all where a ray grazes a plane
// between two cells of different values.
constexpr double Rounding = 0.1 / 255.0;

Difference differenceAt(StructuredScene& scene, int level, const Image& truth)
{
  scene.Mapper->SetAccuracyLevel(level);
  const Image drawn = scene.render();
  expectCounters(scene);
  return compare(drawn, truth);
}

// Light in pictures is that of nodes and faces, unlike in the ground truth.
Image expectedOf(StructuredScene& scene)
{
  return scene.isLit() ? scene.drawnWith(LightAt::Vertices) : scene.truth();
}
} // namespace

const char* nameOf(LatticeValues values)
{
  switch (values)
  {
    case LatticeValues::PointsLinear:
      return "points, linear";
    case LatticeValues::PointsNearest:
      return "points, nearest";
    case LatticeValues::CellsLinear:
      return "cells, linear";
    default:
      return "cells, nearest";
  }
}

StructuredScene::StructuredScene(vtkDataSet* data, int width, int height)
  : Data(data)
  , Window(makeWindow(width, height))
{
  this->Mapper->SetInputDataObject(data);
  this->Mapper->CollectDiagnosticsOn();
  this->Volume->SetMapper(this->Mapper);
  setBumpyFunctions(this->property());
  this->property()->SetInterpolationTypeToLinear();
  this->property()->SetScalarOpacityUnitDistance(0.25);
  this->Renderer->AddVolume(this->Volume);
  this->Window->AddRenderer(this->Renderer);
  lookAtUnitCube(this->camera());
}

void StructuredScene::draw(LatticeValues values)
{
  this->property()->SetInterpolationType(
    isLinear(values) ? VTK_LINEAR_INTERPOLATION : VTK_NEAREST_INTERPOLATION);
  this->Mapper->SetScalarMode(
    isOfCells(values) ? VTK_SCALAR_MODE_USE_CELL_DATA : VTK_SCALAR_MODE_USE_POINT_DATA);
}

void StructuredScene::lookAtAll(double unitDistance)
{
  this->property()->SetScalarOpacityUnitDistance(unitDistance * this->Data->GetLength());
  this->Renderer->ResetCamera();
  this->camera()->Azimuth(35.0);
  this->camera()->Elevation(20.0);
  this->camera()->Roll(7.0);
  this->Renderer->ResetCamera();
  this->camera()->Zoom(1.4);
}

void StructuredScene::stretchFunctions(double low, double high)
{
  vtkNew<vtkColorTransferFunction> colours;
  vtkNew<vtkPiecewiseFunction> opacities;
  for (int i = 0; i < this->property()->GetRGBTransferFunction()->GetSize(); ++i)
  {
    double node[6];
    this->property()->GetRGBTransferFunction()->GetNodeValue(i, node);
    colours->AddRGBPoint(low + node[0] * (high - low), node[1], node[2], node[3]);
  }
  for (int i = 0; i < this->property()->GetScalarOpacity()->GetSize(); ++i)
  {
    double node[4];
    this->property()->GetScalarOpacity()->GetNodeValue(i, node);
    opacities->AddPoint(low + node[0] * (high - low), node[1]);
  }
  this->property()->SetColor(colours);
  this->property()->SetScalarOpacity(opacities);
}

void StructuredScene::setSurfaces(const std::vector<double>& values)
{
  vtkContourValues* contours = this->property()->GetIsoSurfaceValues();
  contours->SetNumberOfContours(static_cast<int>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    contours->SetValue(static_cast<int>(i), values[i]);
  }
}

vtkSmartPointer<vtkLight> StructuredScene::addLight(double x, double y, double z)
{
  return tetmarch::testing::addLight(this->Renderer, x, y, z);
}

Image StructuredScene::render()
{
  this->Window->Render();
  return this->pixels();
}

Image StructuredScene::pixels() const
{
  const int* size = this->Renderer->GetSize();
  vtkNew<vtkFloatArray> pixels;
  this->Mapper->GetDiagnosticPixels(pixels);
  if (pixels->GetNumberOfTuples() != vtkIdType(size[0]) * size[1])
  {
    throw std::runtime_error(
      "the last frame left " + std::to_string(pixels->GetNumberOfTuples()) + " diagnostic pixels");
  }
  return Image::fromFloats(size[0], size[1], pixels->GetPointer(0));
}

Image StructuredScene::drawnWith(LightAt light)
{
  FrameInput input =
    frameInputOf(this->Mapper.Get(), this->Data, this->Renderer.Get(), this->Volume.Get());
  input.Drawn.Volume.Between = this->property()->GetInterpolationType() == VTK_LINEAR_INTERPOLATION
                                 ? Interpolation::Linear
                                 : Interpolation::Nearest;
  input.Drawn.Vector.Mode = VectorMode::AllComponents;
  AccuracyLevel level = GroundTruthAccuracy;
  level.ErrorTolerance = TruthTolerance;
  const FreshFrame frame(input);
  const int* size = this->Renderer->GetSize();
  const auto made = frame.at(level, size[0], size[1]);
  const std::vector<float> depths = windowDepthsOf(this->Window);
  made->scene().WindowDepths = depths.data();
  made->scene().Light = light;
  return Image::fromFloats(size[0], size[1], made->render<double>().Pixels.data());
}

Image StructuredScene::truth()
{
  vtkNew<vtkFloatArray> pixels;
  if (!this->Mapper->RenderGroundTruth(this->Volume, pixels, TruthTolerance))
  {
    throw std::runtime_error("there is no ground truth of the last frame");
  }
  const int* size = this->Renderer->GetSize();
  return Image::fromFloats(size[0], size[1], pixels->GetPointer(0));
}

void expectCounters(StructuredScene& scene)
{
  EXPECT_EQ(scene.Mapper->GetNumberOfLostRays(), 0);
  EXPECT_EQ(scene.Mapper->GetNumberOfGuardHits(), 0);
  EXPECT_EQ(scene.Mapper->GetNumberOfRefusedEntries(), 0);
  EXPECT_GT(scene.Mapper->GetNumberOfRays(), 0);
  EXPECT_GT(scene.Mapper->GetNumberOfCrossedCells(), 0);
}

Worst expectParity(StructuredScene& scene, const Promises& promises)
{
  scene.Mapper->SetAccuracyLevelToDefault();
  scene.Window->Render();
  const Image truth = expectedOf(scene); // is that of any level
  EXPECT_GT(compare(truth, Image(truth.Width, truth.Height)).Max, 0.05) << "nothing is seen";
  Worst worst;
  for (const int level : { Mapper::DEFAULT, Mapper::ACCURATE })
  {
    const Difference difference = differenceAt(scene, level, truth);
    const double bound =
      scene.Mapper->GetLastFrameStatistics()->GetMaximum(vtkTetMarchFrameStatistics::ERROR_BOUND);
    if (level != Mapper::DEFAULT || promises.DefaultTolerance)
    {
      EXPECT_LE(difference.Max, 2.0 / 255.0) << difference.text();
    }
    EXPECT_LE(difference.Rms, 0.3 / 255.0) << difference.text();
    if (promises.Bound)
    {
      EXPECT_LE(difference.Max, bound + Rounding) << difference.text();
    }
    worst.Max = std::max(worst.Max, difference.Max);
    worst.Rms = std::max(worst.Rms, difference.Rms);
    worst.OverBound = std::max(worst.OverBound, difference.Max - bound);
    keepScenePage(scene.Window);
  }
  return worst;
}

void report(const std::string& what, const Worst& worst)
{
  std::cout << "[ MEASURED ] " << what << ": max " << 255.0 * worst.Max << "/255, RMS "
            << 255.0 * worst.Rms << "/255, over the bound by " << worst.OverBound << '\n';
}

void expectParityOf(
  KindsOfValues kinds, StructuredScene& scene, const std::string& what, const Promises& promises)
{
  for (const LatticeValues values : kinds)
  {
    const std::string each = what + ", " + nameOf(values);
    SCOPED_TRACE(each);
    scene.draw(values);
    report(each, expectParity(scene, promises));
  }
}

void expectParityButForEdges(StructuredScene& scene, const std::string& what)
{
  const Image drawn = scene.render();
  expectCounters(scene);
  const Image truth = expectedOf(scene);
  const Difference difference = compare(drawn, truth);
  std::cout << "[ MEASURED ] " << what << ": " << difference.text() << '\n';
  EXPECT_GT(compare(truth, Image(truth.Width, truth.Height)).Max, 0.05) << "nothing is seen";
  EXPECT_LE(250 * difference.Over, difference.Pixels) << what << ": " << difference.text();
  keepScenePage(scene.Window);
}

void expectPictureOfMesh(const Image& lattice, const Image& mesh, const std::string& what)
{
  Mask inside(std::size_t(lattice.Width) * lattice.Height, false);
  for (int y = 1; y + 1 < lattice.Height; ++y)
  {
    for (int x = 1; x + 1 < lattice.Width; ++x)
    {
      bool all = true;
      for (int n = 0; n < 9; ++n)
      {
        all = all && lattice.pixel(x + n % 3 - 1, y + n / 3 - 1)[3] > 0.0f;
      }
      inside[std::size_t(y) * lattice.Width + x] = all;
    }
  }
  const Difference difference = compare(mesh, lattice, inside, 0.5 / 255.0);
  std::cout << "[ MEASURED ] " << what << ": " << difference.text() << '\n';
  EXPECT_GT(difference.Pixels, 400u) << what;
  EXPECT_LE(difference.Max, 0.5 / 255.0) << what << ": " << difference.text();
}

void expectLightAlongRays(StructuredScene& scene, const std::string& what)
{
  const Image drawn = scene.render();
  expectCounters(scene);
  const Difference difference = compare(drawn, scene.drawnWith(LightAt::Faces));
  std::cout << "[ MEASURED ] " << what << ": " << difference.text() << '\n';
  EXPECT_LE(difference.Rms, 1.5 / 255.0) << what;
  keepScenePage(scene.Window);
}

void expectShadowsAlongRays(KindsOfValues kinds, StructuredScene& scene)
{
  for (const LatticeValues values : kinds)
  {
    scene.draw(values);
    scene.Mapper->SetShadowMethodToOff();
    const Image without = scene.render();
    scene.Mapper->SetShadowMethodToAlongRays();
    expectLightAlongRays(scene, std::string("shadows, ") + nameOf(values));
    EXPECT_GT(compare(without, scene.pixels()).Max, 0.02) << nameOf(values);
  }
}
} // namespace tetmarch::testing
