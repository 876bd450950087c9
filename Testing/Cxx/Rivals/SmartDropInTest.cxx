// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Code that was written for vtkSmartVolumeMapper runs with ours, and gets the same picture.
#include "SmartScene.h"

#include "vtkActor.h"
#include "vtkAutoInit.h"
#include "vtkContourValues.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkTetMarchSettings.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

VTK_MODULE_INIT(vtkRenderingVolumeOpenGL2);

namespace
{
using namespace tetmarch::testing;

// What a program does to a mapper of VTK's and to a property.
struct Preparation
{
  const char* Name;
  void (*Make)(vtkSmartVolumeMapper*, vtkVolumeProperty*);
  double MostRms; // in units of 1/255
};

// As ParaView's representation of images does: dependent components are all drawn.
void chooseDependent(vtkSmartVolumeMapper* mapper, vtkVolumeProperty* property, const char* array)
{
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectScalarArray(array);
  mapper->SetVectorMode(vtkSmartVolumeMapper::COMPONENT);
  mapper->SetVectorComponent(0);
  property->IndependentComponentsOff();
  // VTK takes the functions of the first component, but the unit distance of that of the opacity.
  property->SetScalarOpacityUnitDistance(1, property->GetScalarOpacityUnitDistance(0));
  property->SetScalarOpacityUnitDistance(3, property->GetScalarOpacityUnitDistance(0));
}

// VTK's rays begin and end up to a sample from the faces, which counts where the extreme is there.
const Preparation preparations[] = {
  { "Composite", [](vtkSmartVolumeMapper*, vtkVolumeProperty*) {}, 1.4 },
  { "Maximum",
    [](vtkSmartVolumeMapper* mapper, vtkVolumeProperty*)
    { mapper->SetBlendModeToMaximumIntensity(); },
    3.5 },
  { "Minimum",
    [](vtkSmartVolumeMapper* mapper, vtkVolumeProperty*)
    { mapper->SetBlendModeToMinimumIntensity(); },
    3.5 },
  { "Average",
    [](vtkSmartVolumeMapper* mapper, vtkVolumeProperty*)
    { mapper->SetBlendModeToAverageIntensity(); },
    1 },
  { "Additive",
    [](vtkSmartVolumeMapper* mapper, vtkVolumeProperty* property)
    {
      mapper->SetBlendModeToAdditive();
      property->SetScalarOpacityUnitDistance(2);
    },
    0.5 },
  { "IsoSurface",
    [](vtkSmartVolumeMapper* mapper, vtkVolumeProperty* property)
    {
      mapper->SetBlendModeToIsoSurface();
      property->GetIsoSurfaceValues()->SetValue(0, 0.35);
      property->GetIsoSurfaceValues()->SetValue(1, 0.7);
    },
    3.5 },
  { "ColorWindow",
    [](vtkSmartVolumeMapper* mapper, vtkVolumeProperty*)
    {
      mapper->SetFinalColorWindow(0.6f);
      mapper->SetFinalColorLevel(0.4f);
    },
    2 },
  { "NegativeColorWindow",
    [](vtkSmartVolumeMapper* mapper, vtkVolumeProperty*) { mapper->SetFinalColorWindow(-1); },
    1.3 },
  { "ClippingPlane",
    [](vtkSmartVolumeMapper* mapper, vtkVolumeProperty*)
    {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(0.5, 0.45, 0.5);
      plane->SetNormal(1.0, 0.3, -0.2);
      mapper->AddClippingPlane(plane);
    },
    1.5 },
  { "Nearest",
    [](vtkSmartVolumeMapper*, vtkVolumeProperty* property)
    { property->SetInterpolationTypeToNearest(); },
    1.7 },
  { "CellScalars",
    [](vtkSmartVolumeMapper* mapper, vtkVolumeProperty*)
    {
      mapper->SetScalarModeToUseCellFieldData();
      mapper->SelectScalarArray("c");
    },
    1 },
  { "Magnitude",
    [](vtkSmartVolumeMapper* mapper, vtkVolumeProperty*)
    {
      mapper->SetScalarModeToUsePointFieldData();
      mapper->SelectScalarArray("v");
      mapper->SetVectorMode(vtkSmartVolumeMapper::MAGNITUDE);
    },
    0.7 },
  { "ComponentOfTwoDependent",
    [](vtkSmartVolumeMapper* mapper, vtkVolumeProperty* property)
    { chooseDependent(mapper, property, "colour and opacity"); },
    1 },
  { "ComponentOfFourDependent",
    [](vtkSmartVolumeMapper* mapper, vtkVolumeProperty* property)
    {
      chooseDependent(mapper, property, "rgba");
      vtkNew<vtkPiecewiseFunction> opacities; // of bytes
      opacities->AddPoint(20, 0);
      opacities->AddPoint(255, 0.7);
      property->SetScalarOpacity(opacities);
    },
    1 },
  { "Component",
    [](vtkSmartVolumeMapper* mapper, vtkVolumeProperty* property)
    {
      mapper->SetScalarModeToUsePointFieldData();
      mapper->SelectScalarArray("v");
      mapper->SetVectorMode(vtkSmartVolumeMapper::COMPONENT);
      mapper->SetVectorComponent(1);
      // VTK takes the functions of the first component, but not its unit distance.
      property->SetScalarOpacityUnitDistance(1, property->GetScalarOpacityUnitDistance(0));
    },
    0.7 },
};

// For each point a tuple of what the scalar "f" there and the function make of it.
void addTuples(
  vtkImageData* image, const char* name, int type, std::vector<double> (*tupleOf)(double))
{
  const auto tuples = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  tuples->SetName(name);
  tuples->SetNumberOfComponents(static_cast<int>(tupleOf(0).size()));
  tuples->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double f = image->GetPointData()->GetArray("f")->GetComponent(i, 0);
    tuples->SetTuple(i, tupleOf(f).data());
  }
  image->GetPointData()->AddArray(tuples);
}

vtkSmartPointer<vtkImageData> makeImage()
{
  using Tuple = std::vector<double>;
  auto image = imageOf(sineField(), unitCube(20));
  addTuples(image, "v", VTK_FLOAT,
    [](double f) {
      return Tuple{ 0.5 * f, 0.9 * f * f, 0.3 - 0.2 * f };
    });
  addTuples(image, "colour and opacity", VTK_FLOAT,
    [](double f) {
      return Tuple{ 1 - f, 0.2 + 0.6 * f };
    });
  addTuples(image, "rgba", VTK_UNSIGNED_CHAR, // of the whole range: VTK stretches others to it
    [](double f) {
      return Tuple{ 255 * f, 255 - 255 * f, 255 * f * f, 255 * f };
    });
  return image;
}

class SmartDropIn : public testing::Test
{
protected:
  SmartScene Shown{ makeImage() };
};

class SmartDropInOf
  : public SmartDropIn
  , public testing::WithParamInterface<Preparation>
{
};

TEST_P(SmartDropInOf, LooksAsByVtk)
{
  const Preparation& preparation = this->GetParam();
  vtkNew<vtkSmartVolumeMapper> stock;
  sampleFinely(stock);
  preparation.Make(stock, this->Shown.property());
  const Image theirs = this->Shown.frameBy(stock);
  preparation.Make(this->Shown.Mapper, this->Shown.property());
  const Image ours = this->Shown.frame();
  const Difference difference = compare(ours, theirs, {}, 2.0 / 255, Channels::Rgb);
  std::printf("%s: %s\n", preparation.Name, difference.text().c_str());
  EXPECT_LE(255 * difference.Rms, preparation.MostRms);
  EXPECT_EQ(this->Shown.Mapper->GetLastUsedRenderMode(), vtkSmartVolumeMapper::GPURenderMode);
}

TEST_P(SmartDropInOf, IsNotThePlainPicture)
{
  const Preparation& preparation = this->GetParam();
  const Image plain = this->Shown.frame();
  preparation.Make(this->Shown.Mapper, this->Shown.property());
  const bool changes = std::string(preparation.Name) != "Composite";
  EXPECT_EQ(255 * compare(this->Shown.frame(), plain).Rms > 2 * preparation.MostRms, changes);
}

INSTANTIATE_TEST_SUITE_P(Program, SmartDropInOf, testing::ValuesIn(preparations),
  [](const auto& test) { return std::string(test.param.Name); });

TEST(SmartDropInClass, IsAVtkSmartVolumeMapper)
{
  vtkNew<vtkTetMarchSmartVolumeMapper> mapper;
  EXPECT_EQ(vtkSmartVolumeMapper::SafeDownCast(mapper), mapper.Get());
  EXPECT_TRUE(mapper->IsA("vtkSmartVolumeMapper"));
  EXPECT_EQ(mapper->GetOpacityLaw(), vtkTetMarchSettings::STRUCTURED);
  mapper->SetSettings(vtkNew<vtkTetMarchSettings>());
  EXPECT_EQ(mapper->GetOpacityLaw(), vtkTetMarchSettings::UNSTRUCTURED);
  mapper->SetSettings(nullptr);
  EXPECT_EQ(mapper->GetOpacityLaw(), vtkTetMarchSettings::STRUCTURED);
}

// What both classes have by the same name is one thing.
TEST(SmartDropInClass, ItsSettingsAreSetByEitherClass)
{
  vtkNew<vtkTetMarchSmartVolumeMapper> mapper;
  vtkSmartVolumeMapper* base = mapper;
  vtkTetMarchSettings* settings = mapper->GetSettings();
  EXPECT_EQ(base->GetMaxMemoryInBytes(), 0);
  base->SetMaxMemoryInBytes(12345);
  EXPECT_EQ(settings->GetMaxMemoryInBytes(), 12345);
  settings->SetMaxMemoryInBytes(54321);
  EXPECT_EQ(base->GetMaxMemoryInBytes(), 54321);
  EXPECT_EQ(base->GetAutoAdjustSampleDistances(), 1);
  base->AutoAdjustSampleDistancesOff();
  EXPECT_FALSE(settings->GetAutoAdjustSampleDistances());
  base->SetAutoAdjustSampleDistances(1);
  EXPECT_TRUE(settings->GetAutoAdjustSampleDistances());
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  base->SetGlobalIlluminationReach(0.25f);
  base->SetVolumetricScatteringBlending(1.5f);
  EXPECT_EQ(settings->GetGlobalIlluminationReach(), 0.25f);
  EXPECT_EQ(settings->GetVolumetricScatteringBlending(), 1.5f);
#endif
}

TEST_F(SmartDropIn, ThePropertyIsNotWrittenTo)
{
  preparations[std::size(preparations) - 1].Make(this->Shown.Mapper, this->Shown.property());
  const vtkMTimeType before = this->Shown.property()->GetMTime();
  this->Shown.frame();
  EXPECT_EQ(this->Shown.property()->GetMTime(), before);
}

// The window and level of each pixel's colour, of which the rounding is left.
TEST_F(SmartDropIn, WindowAndLevelAreExact)
{
  const Image plain = this->Shown.floats();
  for (const auto& [window, level] : { std::pair(0.3, 0.6), { 2.0, 0.1 }, { -0.5, 0.5 } })
  {
    this->Shown.Mapper->SetFinalColorWindow(static_cast<float>(window));
    this->Shown.Mapper->SetFinalColorLevel(static_cast<float>(level));
    const Image frame = this->Shown.frame();
    const double scale = 1.0 / window;
    const double shift = 0.5 - level / window;
    double most = 0;
    for (std::size_t i = 0; i < plain.Rgba.size(); ++i)
    {
      const double colour = plain.Rgba[i];
      const double opacity = plain.Rgba[i - i % 4 + 3];
      const double expected = i % 4 == 3 ? opacity : scale * colour + shift * opacity;
      most = std::max(most, std::abs(std::clamp(expected, 0.0, 1.0) - double(frame.Rgba[i])));
    }
    // Half a byte is its rounding; GPUs may be off by 0.6 (Direct3D 11.3 specification, 3.2.3.6).
    EXPECT_LE(255 * most, 0.6) << window << ", " << level;
    EXPECT_EQ(compare(this->Shown.floats(), plain).Max, 0.0);
  }
}

// Between peels each part of a ray is mapped, which is the same: the map is linear in premultiplied
// colour and opacity. A surface behind the volume is drawn before it without peeling, too.
TEST_F(SmartDropIn, WindowAndLevelBetweenPeels)
{
  SmartScene& scene = this->Shown;
  scene.Window->AlphaBitPlanesOn();
  const auto plane = makePlane(-0.2, 0.3, { { 0.9, 0.2, 0.1 } });
  plane->GetProperty()->SetOpacity(0.5);
  scene.Renderer->AddActor(plane);
  scene.Mapper->SetFinalColorWindow(0.6f);
  scene.Mapper->SetFinalColorLevel(0.4f);
  const Image whole = scene.frame();
  scene.Renderer->SetUseDepthPeeling(true);
  scene.Renderer->SetUseDepthPeelingForVolumes(true);
  const Difference difference = compare(scene.frame(), whole, {}, 2.0 / 255, Channels::Rgb);
  EXPECT_LE(255 * difference.Max, 2.01) << difference.text();
}
} // namespace
