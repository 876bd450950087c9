// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Of a structured volume only that is done again whose input has changed, and nothing stays behind.
#include "ErrorWatch.h"
#include "GLObjects.h"
#include "StructuredScene.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"

#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;

constexpr int Cells = 12;
constexpr vtkTypeInt64 ValueBytes = 4 * (Cells + 1) * (Cells + 1) * (Cells + 1);

vtkSmartPointer<vtkImageData> image() { return imageOf(sineField(), unitCube(Cells)); }

class StructuredStages : public testing::Test
{
protected:
  StructuredStages() { this->Before = this->Shown.render(); }

  // Runs of the lattice, the values and the tables, and bytes, since the last time.
  void expectDone(int lattices, int values, int tables, vtkTypeInt64 bytes, bool changes)
  {
    const Image now = this->Shown.render();
    const auto* mapper = this->Shown.Mapper.Get();
    EXPECT_EQ(mapper->GetMeshBuilds() - this->Lattices, lattices);
    EXPECT_EQ(mapper->GetScalarsBuilds() - this->Values, values);
    EXPECT_EQ(mapper->GetTablesBuilds() - this->Tables, tables);
    EXPECT_EQ(mapper->GetUploadedBytes() - this->Bytes, bytes);
    const double most = compare(now, this->Before).Max;
    EXPECT_EQ(most > 0.02, changes) << most;
    EXPECT_EQ(most > 0.0, changes) << most;
    this->remember(now);
    expectCounters(this->Shown);
  }
  void remember(const Image& picture)
  {
    const auto* mapper = this->Shown.Mapper.Get();
    this->Lattices = mapper->GetMeshBuilds();
    this->Values = mapper->GetScalarsBuilds();
    this->Tables = mapper->GetTablesBuilds();
    this->Bytes = mapper->GetUploadedBytes();
    this->Before = picture;
  }

  StructuredScene Shown{ image() };
  Image Before;
  vtkTypeInt64 Lattices = 1;
  vtkTypeInt64 Values = 1;
  vtkTypeInt64 Tables = 1;
  vtkTypeInt64 Bytes = Shown.Mapper->GetUploadedBytes();
};

TEST_F(StructuredStages, NothingWhenNothingChanges)
{
  this->remember(this->Before);
  this->expectDone(0, 0, 0, 0, false);
  this->Shown.camera()->Azimuth(20.0);
  this->expectDone(0, 0, 0, 0, true);
}

// A time series: other values, in place and in another array, of the same range.
TEST_F(StructuredStages, OnlyValuesOfAnotherArray)
{
  this->remember(this->Before);
  const vtkSmartPointer<vtkDataArray> scalars = this->Shown.Data->GetPointData()->GetScalars();
  const vtkIdType count = scalars->GetNumberOfTuples();
  vtkNew<vtkDoubleArray> turned;
  turned->SetName("turned");
  turned->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    turned->SetValue(i, scalars->GetTuple1(count - 1 - i));
  }
  this->Shown.Data->GetPointData()->SetScalars(turned);
  this->expectDone(0, 1, 0, ValueBytes, true);
  for (vtkIdType i = 0; i < count; ++i)
  {
    turned->SetValue(i, scalars->GetTuple1(i));
  }
  turned->Modified();
  this->expectDone(0, 1, 0, ValueBytes, true);
}

TEST_F(StructuredStages, OnlyTablesOfOtherFunctions)
{
  this->remember(this->Before);
  this->Shown.property()->GetRGBTransferFunction()->AddRGBPoint(0.3, 1.0, 0.0, 1.0);
  const Image now = this->Shown.render();
  EXPECT_GT(compare(now, this->Before).Max, 0.02);
  EXPECT_EQ(this->Shown.Mapper->GetMeshBuilds(), this->Lattices);
  EXPECT_EQ(this->Shown.Mapper->GetScalarsBuilds(), this->Values);
  EXPECT_EQ(this->Shown.Mapper->GetTablesBuilds(), this->Tables + 1);
  this->remember(now);
  // Which blocks are empty is found again: their distances come, the values stay.
  setTwoPeaks(this->Shown.property());
  this->Shown.render();
  EXPECT_EQ(this->Shown.Mapper->GetScalarsBuilds(), this->Values);
  report("other functions", expectParity(this->Shown));
}

TEST_F(StructuredStages, AnotherDataSetAndBack)
{
  const Image first = this->Before;
  const auto grid = rectilinearOf(scatteredField(1), unevenCube(7));
  this->Shown.Mapper->SetInputDataObject(grid);
  EXPECT_GT(compare(this->Shown.render(), first).Max, 0.02);
  report("another data set", expectParity(this->Shown));
  this->Shown.Mapper->SetAccuracyLevelToDefault();
  this->Shown.Mapper->SetInputDataObject(this->Shown.Data);
  EXPECT_EQ(compare(this->Shown.render(), first).Max, 0.0);
}

TEST_F(StructuredStages, InterpolationAndScalarsOfCellsAndBack)
{
  const Image first = this->Before;
  for (const LatticeValues values : AllLatticeValues)
  {
    this->Shown.draw(values);
    this->Shown.render();
  }
  this->Shown.draw(LatticeValues::PointsLinear);
  EXPECT_EQ(compare(this->Shown.render(), first).Max, 0.0);
}

TEST_F(StructuredStages, ReleasedAndDrawnAgain)
{
  const vtkTypeInt64 bytes = this->Shown.Mapper->GetGPUMemoryBytes();
  EXPECT_GT(bytes, ValueBytes);
  this->Shown.Mapper->ReleaseGraphicsResources(this->Shown.Window);
  EXPECT_EQ(this->Shown.Mapper->GetGPUMemoryBytes(), 0);
  EXPECT_EQ(compare(this->Shown.render(), this->Before).Max, 0.0);
  EXPECT_EQ(this->Shown.Mapper->GetGPUMemoryBytes(), bytes);
  EXPECT_EQ(this->Shown.Mapper->GetMeshBuilds(), 1);
  this->Shown.Window->Finalize();
  EXPECT_EQ(compare(this->Shown.render(), this->Before).Max, 0.0);
}

// Textures of layers, buffers, framebuffers and units of textures.
TEST_F(StructuredStages, LeavesNoObjectsOfTheGL)
{
  this->Shown.Mapper->ReleaseGraphicsResources(this->Shown.Window);
  const auto none = countGLObjects();
  this->Shown.render();
  const auto held = countGLObjects();
  EXPECT_GT(held[0], none[0]);
  const int units = unitsInUse(this->Shown.Window);
  for (int i = 0; i < 3; ++i)
  {
    // Planes, hidden cells and distances come and go.
    const auto grid = rectilinearOf(sineField(), unevenCube(20));
    markCells(grid, 32, [](vtkIdType id) { return id % 7 == 3; });
    this->Shown.Mapper->SetInputDataObject(grid);
    setTwoPeaks(this->Shown.property());
    this->Shown.render();
    this->Shown.Mapper->Pick(this->Shown.Renderer, this->Shown.Volume, 20, 20);
    EXPECT_EQ(unitsInUse(this->Shown.Window), units);
    setBumpyFunctions(this->Shown.property());
    this->Shown.Mapper->SetInputDataObject(this->Shown.Data);
    EXPECT_EQ(compare(this->Shown.render(), this->Before).Max, 0.0);
    EXPECT_EQ(countGLObjects()[0], held[0]);
    EXPECT_EQ(unitsInUse(this->Shown.Window), units);
  }
  this->Shown.Mapper->ReleaseGraphicsResources(this->Shown.Window);
  EXPECT_EQ(countGLObjects(), none);
  EXPECT_EQ(unitsInUse(this->Shown.Window), units);
}

TEST_F(StructuredStages, TwoWindowsByTurns)
{
  auto second = makeWindow(StructuredSize, StructuredSize);
  vtkNew<vtkRenderer> renderer;
  renderer->SetActiveCamera(this->Shown.camera());
  renderer->AddVolume(this->Shown.Volume);
  second->AddRenderer(renderer);
  for (int i = 0; i < 2; ++i)
  {
    second->Render();
    EXPECT_EQ(compare(this->Shown.pixels(), this->Before).Max, 0.0);
    EXPECT_EQ(compare(this->Shown.render(), this->Before).Max, 0.0);
  }
}

class StructuredCoarse : public testing::Test
{
protected:
  Image draw(double distance)
  {
    this->Shown.Mapper->CollectDiagnosticsOff();
    this->Shown.Mapper->InteractiveAdjustSampleDistancesOff();
    this->Shown.Mapper->AutoAdjustSampleDistancesOff();
    this->Shown.Mapper->SetImageSampleDistance(distance);
    this->Shown.Window->Render();
    EXPECT_EQ(this->Shown.Mapper->GetUsedImageSampleDistance(), distance);
    return this->Shown.frame();
  }
  StructuredScene Shown{ image(), 150, 150 };
};

// Every third pixel lies in the middle of a coarse pixel and has the same ray.
TEST_F(StructuredCoarse, RaysAreThoseOfPixels)
{
  this->Shown.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
  const Image full = this->draw(1.0);
  const Image coarse = this->draw(3.0);
  Mask middles(150 * 150, false);
  for (int i = 0; i < 50 * 50; ++i)
  {
    middles[150 * (3 * (i / 50) + 1) + 3 * (i % 50) + 1] = true;
  }
  const Difference difference = compare(full, coarse, middles, 2.0 / 255.0, Channels::Rgb);
  std::cout << "[ MEASURED ] every third pixel: " << difference.text() << '\n';
  EXPECT_LE(difference.Max, 1.5 / 255.0) << difference.text();
  EXPECT_GT(compare(full, coarse).Max, 0.1);
  EXPECT_EQ(compare(full, this->draw(1.0)).Max, 0.0);
}

TEST_F(StructuredCoarse, IsLikeTheFullPicture)
{
  const Image full = this->draw(1.0);
  double last = 0.0;
  for (const double distance : { 1.5, 2.0, 4.0 })
  {
    const Difference difference =
      compare(full, this->draw(distance), {}, 2.0 / 255.0, Channels::Rgb);
    std::cout << "[ MEASURED ] distance " << distance << ": " << difference.text() << '\n';
    EXPECT_GT(difference.Rms, last) << distance;
    EXPECT_LT(difference.Rms, 0.0055 * distance) << distance;
    last = difference.Rms;
  }
}
} // namespace
