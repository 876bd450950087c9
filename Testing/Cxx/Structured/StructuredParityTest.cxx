// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws of images and rectilinear grids of every kind, pixel by pixel against the CPU
// reference in double precision.
#include "StructuredScene.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkTetMarchFrameStatistics.h"

#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;

TEST(StructuredParity, ImagesInAllPlaces)
{
  for (const ImagePlace& place : imagePlaces())
  {
    StructuredScene scene(imageOf(scatteredField(1), place), 20, 20);
    scene.lookAtAll();
    Worst worst;
    for (const LatticeValues values : AllLatticeValues)
    {
      SCOPED_TRACE(place.Name + ", " + nameOf(values));
      scene.draw(values);
      const Worst found = expectParity(scene);
      worst.Max = std::max(worst.Max, found.Max);
      worst.Rms = std::max(worst.Rms, found.Rms);
      worst.OverBound = std::max(worst.OverBound, found.OverBound);
    }
    report(place.Name, worst);
  }
}

TEST(StructuredParity, RectilinearGridsOfAllAxes)
{
  for (const AxisCoordinates& axes : rectilinearAxes())
  {
    StructuredScene scene(rectilinearOf(scatteredField(2), axes), 20, 20);
    scene.lookAtAll();
    expectParityOf(AllLatticeValues, scene, axes.Name);
  }
}

TEST(StructuredParity, AllTypesOfNumbers)
{
  for (const int type : numberTypes())
  {
    const auto image = imageOf(sineField(), unitCube(5));
    convertScalars(image, type);
    StructuredScene scene(image, 16, 16);
    scene.stretchFunctions(rangeInType(type)[0], rangeInType(type)[1]);
    expectParityOf({ LatticeValues::PointsLinear, LatticeValues::CellsNearest }, scene,
      image->GetPointData()->GetScalars()->GetDataTypeAsString());
  }
}

// Over larger volumes: smooth, and with noise of which cells show all of the functions.
TEST(StructuredParity, SmoothAndScattered)
{
  StructuredScene smooth(imageOf(sineField(), unitCube(10)));
  expectParityOf(AllLatticeValues, smooth, "smooth");
  StructuredScene scattered(imageOf(scatteredField(3), unitCube(10)));
  expectParityOf(AllLatticeValues, scattered, "scattered");
}

TEST(StructuredParity, ThickThinAndPeaks)
{
  StructuredScene scene(imageOf(sineField(), unitCube(12)));
  for (const LatticeValues values : AllLatticeValues)
  {
    SCOPED_TRACE(nameOf(values));
    scene.draw(values);
    setBumpyFunctions(scene.property());
    for (const double unit : { 0.005, 10.0 })
    {
      scene.property()->SetScalarOpacityUnitDistance(unit);
      report("unit distance " + std::to_string(unit) + ", " + nameOf(values), expectParity(scene));
    }
    setTwoPeaks(scene.property());
    scene.property()->SetScalarOpacityUnitDistance(0.05);
    report(std::string("peaks, ") + nameOf(values), expectParity(scene, { false, true }));
  }
}

// Bends and peaks take the most trials at the finest level of all. llvmpipe ends a ray after 65,535
// rounds of its loops, and light would be lost there: it must be far away. Then the error is within
// the bound, but for the rounding of some thousand floats.
TEST(StructuredParity, PeaksAtTheLevelReference)
{
  for (const auto& field : { sineField(), scatteredField(3) })
  {
    for (const LatticeValues values : AllLatticeValues)
    {
      SCOPED_TRACE(nameOf(values));
      StructuredScene scene(imageOf(field, unitCube(12)), 28, 28);
      scene.draw(values);
      setTwoPeaks(scene.property());
      scene.Mapper->SetAccuracyLevelToReference();
      for (const double unit : { 2.0, 0.05 })
      {
        scene.property()->SetScalarOpacityUnitDistance(unit);
        const Image picture = scene.render();
        const Difference difference = compare(picture, scene.truth());
        vtkTetMarchFrameStatistics* frame = scene.Mapper->GetLastFrameStatistics();
        const double bound = frame->GetMaximum(vtkTetMarchFrameStatistics::ERROR_BOUND);
        const double lookups = frame->GetMaximum(vtkTetMarchFrameStatistics::LOOKUPS);
        std::cout << "[ MEASURED ] " << nameOf(values) << ", unit distance " << unit << ": max "
                  << 255.0 * difference.Max << "/255, bound " << 255.0 * bound << "/255, "
                  << lookups << " lookups\n";
        EXPECT_LE(difference.Max, bound + 0.01 / 255.0) << difference.text();
        EXPECT_GT(lookups, 10.0);
        EXPECT_LT(lookups, 65535.0 / 8.0);
        expectCounters(scene);
      }
    }
  }
}

// Optical depths beyond the range of float: opaque, and no NaN (compare() takes one for an infinite
// difference).
TEST(StructuredParity, ThickerThanFloatsTell)
{
  StructuredScene scene(imageOf(constantField(0.5), unitCube(4)));
  scene.property()->SetScalarOpacityUnitDistance(1e-9);
  const Image opaque = scene.render();
  EXPECT_GT(compare(opaque, Image(opaque.Width, opaque.Height)).Max, 0.9);
  scene.property()->SetScalarOpacityUnitDistance(1e-200);
  EXPECT_LE(compare(scene.render(), opaque).Max, 1.0 / 255.0);
}

TEST(StructuredParity, OneColourGrayAndTheOtherLaw)
{
  StructuredScene scene(imageOf(sineField(), unitCube(9)));
  for (const LatticeValues values : { LatticeValues::PointsLinear, LatticeValues::CellsNearest })
  {
    SCOPED_TRACE(nameOf(values));
    scene.draw(values);
    setBumpyFunctions(scene.property());
    scene.property()->GetRGBTransferFunction()->RemoveAllPoints();
    scene.property()->GetRGBTransferFunction()->AddRGBPoint(0.0, 0.9, 0.5, 0.1);
    report(std::string("one colour, ") + nameOf(values), expectParity(scene));
    vtkNew<vtkPiecewiseFunction> gray;
    gray->AddPoint(0.0, 0.0);
    gray->AddPoint(0.7, 1.0);
    scene.property()->SetColor(gray);
    scene.Mapper->SetOpacityLawToUnstructured();
    report(std::string("gray, ") + nameOf(values), expectParity(scene));
    scene.Mapper->SetOpacityLawToStructured();
  }
}

bool isSome(vtkIdType id) { return id % 7 == 3 || id % 11 == 5; }

TEST(StructuredParity, HiddenCellsAndPoints)
{
  for (const bool ofPoints : { false, true })
  {
    const auto image = imageOf(scatteredField(4), unitCube(8));
    const auto grid = rectilinearOf(scatteredField(4), unevenCube(8));
    for (vtkDataSet* data : { (vtkDataSet*)image, (vtkDataSet*)grid })
    {
      ofPoints ? markPoints(data, vtkDataSetAttributes::HIDDENPOINT,
                   [](vtkIdType id) { return id % 31 == 3; })
               : markCells(data, vtkDataSetAttributes::HIDDENCELL, isSome);
      StructuredScene scene(data);
      expectParityOf(AllLatticeValues, scene,
        std::string(ofPoints ? "points of " : "cells of ") + data->GetClassName() + " hidden");
    }
  }
}

TEST(StructuredParity, ScalarsThatAreNotFinite)
{
  const auto image = imageOf(scatteredField(5), unitCube(8));
  spoilScalars(
    image, [](vtkIdType id) { return id % 37 == 5; }, isSome);
  StructuredScene scene(image);
  scene.property()->GetRGBTransferFunction()->SetNanColorRGBA(0.9, 0.2, 0.7, 0.4);
  for (const bool shown : { false, true })
  {
    scene.Mapper->SetDrawNanCells(shown);
    expectParityOf(AllLatticeValues, scene, shown ? "shown" : "not shown");
  }
}

// Rays leap over blocks that the functions don't show; the reference does not leap.
TEST(StructuredParity, MuchEmptySpace)
{
  for (const auto& nodes :
    { std::array<double, 3>{ { 0.0, 0.05, 0.12 } }, std::array<double, 3>{ { 0.8, 0.95, 1.1 } },
      std::array<double, 3>{ { 0.5, 0.505, 0.51 } } })
  {
    const auto image = imageOf(sineField(1.5), unitCube(40));
    const auto grid = rectilinearOf(radialField(), unevenCube(37));
    for (vtkDataSet* data : { (vtkDataSet*)image, (vtkDataSet*)grid })
    {
      StructuredScene scene(data);
      vtkPiecewiseFunction* opacity = scene.property()->GetScalarOpacity();
      opacity->RemoveAllPoints();
      opacity->AddPoint(nodes[0], 0.0);
      opacity->AddPoint(nodes[1], 0.9);
      opacity->AddPoint(nodes[2], 0.0);
      scene.property()->SetScalarOpacityUnitDistance(0.05);
      // A narrow peak lies between few entries of the tables, which the bound leaves out.
      expectParityOf(AllLatticeValues, scene,
        std::string(data->GetClassName()) + " at " + std::to_string(nodes[1]),
        { nodes[2] - nodes[0] > 0.02, true });
    }
  }
}
} // namespace
