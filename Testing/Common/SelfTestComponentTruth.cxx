// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The ground truth of several components: where it has a closed form, or is that of one component.
#include "ComponentTruth.h"

#include "ClosedForms.h"
#include "ComponentFields.h"
#include "Fields.h"
#include "LatticeImages.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

namespace
{
using namespace tetmarch::testing;

vtkSmartPointer<vtkImageData> imageWith(const std::vector<Field>& fields)
{
  const auto image = imageOf(constantField(0.0), unitCube(4));
  setComponents(image, fields, VTK_DOUBLE);
  return image;
}

constexpr Vec3 Origin = { -1.0, 0.31, 0.42 };
const Vec3 Direction = { 0.96, 0.0, 0.28 };

// Two even clouds: extinctions add, and colours are mixed by them.
TEST(ComponentTruth, IsTheMixtureOfEvenClouds)
{
  const auto image = imageWith({ constantField(0.3), constantField(0.6) });
  vtkNew<vtkVolumeProperty> property;
  property->IndependentComponentsOn();
  setComponentFunctions(property, 2);
  const ComponentTruth truth(image, property, LatticeValues::PointsLinear, OpacityLaw::Linear);
  const std::array<double, 4> medium = mediumAt(property, { 0.3, 0.6 });
  const double length = boxChord(Origin, Direction, { 0, 0, 0 }, { 1, 1, 1 }) /
                        property->GetScalarOpacityUnitDistance();
  const double opacity = slabOpacity(medium[3], length);
  const std::array<double, 4> seen = truth.integrate(Origin, Direction, 0.0, 9.0);
  ASSERT_GT(opacity, 0.1);
  EXPECT_NEAR(seen[3], opacity, 1e-12);
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(seen[c], opacity * medium[c] / medium[3], 1e-9);
  }
}

// A component that absorbs nothing is not seen, whatever it does.
TEST(ComponentTruth, IsThatOfTheOnlyOneThatIsSeen)
{
  const auto image = imageWith({ sineField(2.0), radialField() });
  vtkNew<vtkVolumeProperty> property;
  property->IndependentComponentsOn();
  setComponentFunctions(property, 2);
  property->SetComponentWeight(1, 0.0);
  for (const OpacityLaw law : { OpacityLaw::Linear, OpacityLaw::Logarithmic })
  {
    const ComponentTruth truth(image, property, LatticeValues::PointsLinear, law);
    OpticalModel model;
    model.Colour = property->GetRGBTransferFunction();
    model.Opacity = property->GetScalarOpacity();
    model.UnitDistance = property->GetScalarOpacityUnitDistance();
    model.Law = law;
    const LatticeTruth one(image, model, LatticeValues::PointsLinear);
    const std::array<double, 4> expected = one.integrate(Origin, Direction, 0.0, 9.0);
    const std::array<double, 4> seen = truth.integrate(Origin, Direction, 0.0, 9.0);
    for (int c = 0; c < 4; ++c)
    {
      EXPECT_NEAR(seen[c], expected[c], 1e-8);
    }
  }
}

TEST(ComponentTruth, IsTheColourThatRisesInAnEvenFog)
{
  const std::vector<Field> fields = componentFields(4);
  const auto image = imageWith(fields);
  vtkNew<vtkVolumeProperty> property;
  property->IndependentComponentsOff();
  vtkNew<vtkPiecewiseFunction> even;
  even->AddPoint(0.0, 0.7);
  property->SetScalarOpacity(even);
  const ComponentTruth truth(image, property, LatticeValues::PointsLinear, OpacityLaw::Linear);
  const double length = boxChord(Origin, Direction, { 0, 0, 0 }, { 1, 1, 1 });
  const double entry = -Origin[0] / Direction[0];
  const std::array<double, 4> seen = truth.integrate(Origin, Direction, 0.0, 9.0);
  for (int c = 0; c < 3; ++c)
  {
    const auto at = [&](double t)
    {
      return fields[c](
        Origin[0] + t * Direction[0], Origin[1] + t * Direction[1], Origin[2] + t * Direction[2]);
    };
    EXPECT_NEAR(seen[c], slabColour(at(entry), at(entry + length), 0.7, length), 1e-9);
  }
}

TEST(ComponentTruth, RefusesComponentsThatAreNotDrawnTogether)
{
  const auto image = imageWith({ sineField(), radialField() });
  image->GetPointData()->GetScalars()->SetComponent(31, 1, std::nan(""));
  vtkNew<vtkVolumeProperty> property;
  setComponentFunctions(property, 2);
  const ComponentTruth truth(image, property, LatticeValues::PointsLinear, OpacityLaw::Linear);
  EXPECT_THROW(
    truth.integrate({ -1.0, 0.3, 0.2 }, { 1.0, 0.0, 0.0 }, 0.0, 9.0), std::invalid_argument);
}
} // namespace
