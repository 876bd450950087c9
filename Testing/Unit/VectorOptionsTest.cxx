// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether the mapper or the colour function says which component of an array is drawn.
#include "Scalars/DrawnScalars.h"

#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;

constexpr int Magnitude = -1;
constexpr int Missing = -2;

class VectorOptionCases : public testing::Test
{
protected:
  VectorOptionCases()
  {
    this->Array->SetName("velocity");
    this->Array->SetNumberOfComponents(3);
    this->Property->SetColor(this->Colors);
  }

  // A component, or one of the above.
  int chosen(VectorMode mode = VectorMode::Disabled, int component = 0)
  {
    DrawnScalars drawn;
    this->Error =
      chooseScalars(this->Grid, this->Array, false, { mode, component }, this->Property, drawn);
    const TupleScalar& scalar = drawn.First;
    return !this->Error.empty() ? Missing : scalar.Magnitude ? Magnitude : scalar.Component;
  }

  void expectInError(std::initializer_list<const char*> words)
  {
    for (const char* word : words)
    {
      EXPECT_NE(this->Error.find(word), std::string::npos) << word << " in: " << this->Error;
    }
  }

  vtkNew<vtkUnstructuredGrid> Grid; // without points, like the array
  vtkNew<vtkDoubleArray> Array;
  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkColorTransferFunction> Colors;
  std::string Error;
};

TEST_F(VectorOptionCases, TheFirstComponentUnlessAsked) { EXPECT_EQ(this->chosen(), 0); }

TEST_F(VectorOptionCases, TheModeOfTheMapper)
{
  this->Colors->SetVectorModeToMagnitude();
  EXPECT_EQ(this->chosen(VectorMode::Component, 2), 2);
  this->Colors->SetVectorModeToComponent();
  this->Colors->SetVectorComponent(1);
  EXPECT_EQ(this->chosen(VectorMode::Magnitude, 2), Magnitude);
  EXPECT_EQ(this->chosen(VectorMode::Component, 0), 0);
}

TEST_F(VectorOptionCases, TheColourFunctionsOtherwise)
{
  this->Colors->SetVectorComponent(2);
  EXPECT_EQ(this->chosen(VectorMode::Disabled, 1), 2);
  this->Colors->SetVectorModeToMagnitude();
  EXPECT_EQ(this->chosen(VectorMode::Disabled, 1), Magnitude);
}

TEST_F(VectorOptionCases, DependentComponentsUnlessAsked)
{
  this->Colors->SetVectorModeToMagnitude();
  this->Property->IndependentComponentsOff();
  EXPECT_EQ(this->chosen(), Missing); // three of them
  this->expectInError({ "\"velocity\"", "3 components", "dependent" });
  EXPECT_EQ(this->chosen(VectorMode::Magnitude), Magnitude);
  EXPECT_EQ(this->chosen(VectorMode::Component, 1), 1);
}

TEST_F(VectorOptionCases, AGrayFunctionHasNone)
{
  vtkNew<vtkPiecewiseFunction> gray;
  this->Property->SetColor(gray);
  EXPECT_EQ(this->chosen(), 0);
  EXPECT_EQ(this->Property->GetColorChannels(), 1);
}

TEST_F(VectorOptionCases, ASingleComponentIsWhatItIs)
{
  this->Array->SetNumberOfComponents(1);
  this->Colors->SetVectorModeToMagnitude();
  EXPECT_EQ(this->chosen(), 0);
  EXPECT_EQ(this->chosen(VectorMode::Magnitude), 0);
  this->Colors->SetVectorModeToComponent();
  this->Colors->SetVectorComponent(2);
  EXPECT_EQ(this->chosen(), 0);
}

TEST_F(VectorOptionCases, ComponentsThatAreNotThere)
{
  EXPECT_EQ(this->chosen(VectorMode::Component, 3), Missing);
  this->expectInError({ "\"velocity\"", "no component 3", "VectorComponent", "has 3" });
  for (const int component : { -1, 7 })
  {
    this->Colors->SetVectorComponent(component);
    EXPECT_EQ(this->chosen(), Missing);
    this->expectInError({ "no component ", "colour function" });
  }
  this->Array->SetNumberOfComponents(1);
  EXPECT_EQ(this->chosen(VectorMode::Component, 1), Missing);
  EXPECT_EQ(this->chosen(VectorMode::Component, 0), 0);
}
} // namespace
