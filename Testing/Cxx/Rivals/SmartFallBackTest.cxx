// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What we don't draw is drawn by vtkSmartVolumeMapper, with one warning that says why.
#include "ErrorWatch.h"
#include "SmartScene.h"

#include "vtkAutoInit.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

VTK_MODULE_INIT(vtkRenderingVolumeOpenGL2);

namespace
{
using namespace tetmarch::testing;

struct Request
{
  const char* Name;
  const char* Words; // of the warning
  void (*Make)(vtkSmartVolumeMapper*, vtkVolumeProperty*);
  void (*Undo)(vtkSmartVolumeMapper*, vtkVolumeProperty*);
};

void chooseTwoComponents(vtkSmartVolumeMapper* mapper)
{
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectScalarArray("two");
}

void drawPlain(vtkSmartVolumeMapper* mapper, vtkVolumeProperty*)
{
  mapper->SetRequestedRenderModeToDefault();
  mapper->SetBlendModeToComposite();
  mapper->SetScalarModeToDefault();
}

const Request requests[] = {
  { "RayCast", "ray cast",
    [](vtkSmartVolumeMapper* mapper, vtkVolumeProperty*)
    { mapper->SetRequestedRenderModeToRayCast(); },
    drawPlain },
  { "Slice", "blend mode is slice",
    [](vtkSmartVolumeMapper* mapper, vtkVolumeProperty* property)
    {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(0.5, 0.5, 0.5);
      plane->SetNormal(1, -1, 0.5);
      property->SetSliceFunction(plane);
      mapper->SetBlendMode(vtkVolumeMapper::SLICE_BLEND);
    },
    drawPlain },
  { "TwoDimensionalFunctions", "two-dimensional",
    [](vtkSmartVolumeMapper*, vtkVolumeProperty* property)
    {
      vtkNew<vtkImageData> function;
      function->SetDimensions(16, 16, 1);
      function->AllocateScalars(VTK_FLOAT, 4);
      function->GetPointData()->GetScalars()->Fill(0.25);
      property->SetTransferFunction2D(function);
      property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
    },
    [](vtkSmartVolumeMapper*, vtkVolumeProperty* property)
    { property->SetTransferFunctionMode(vtkVolumeProperty::TF_1D); } },
  { "IndependentComponentsWithLights", "reflect light differently",
    [](vtkSmartVolumeMapper* mapper, vtkVolumeProperty* property)
    {
      chooseTwoComponents(mapper);
      property->ShadeOn(1);
    },
    [](vtkSmartVolumeMapper* mapper, vtkVolumeProperty* property)
    {
      property->ShadeOff(1);
      drawPlain(mapper, property);
    } },
  { "IndependentComponentsBlended", "another blend mode than composite",
    [](vtkSmartVolumeMapper* mapper, vtkVolumeProperty*)
    {
      chooseTwoComponents(mapper);
      mapper->SetBlendModeToMaximumIntensity();
    },
    drawPlain },
};

vtkSmartPointer<vtkImageData> makeImage()
{
  auto image = imageOf(sineField(), unitCube(8));
  vtkNew<vtkFloatArray> two;
  two->SetName("two");
  two->SetNumberOfComponents(2);
  two->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double f = image->GetPointData()->GetArray("f")->GetComponent(i, 0);
    two->SetTuple2(i, f, 1 - f * f);
  }
  image->GetPointData()->AddArray(two);
  return image;
}

class SmartFallBack : public testing::Test
{
protected:
  // Two components have functions.
  SmartFallBack()
  {
    vtkVolumeProperty* property = this->Shown.property();
    property->SetColor(1, property->GetRGBTransferFunction(0));
    property->SetScalarOpacity(1, property->GetScalarOpacity(0));
  }

  SmartScene Shown{ makeImage(), 96, 96 };
};

class SmartFallBackBy
  : public SmartFallBack
  , public testing::WithParamInterface<Request>
{
};

TEST_P(SmartFallBackBy, DrawsAsVtkDoes)
{
  const Request& request = this->GetParam();
  const Image sound = this->Shown.frame();
  request.Make(this->Shown.Mapper, this->Shown.property());
  vtkNew<vtkSmartVolumeMapper> stock;
  request.Make(stock, this->Shown.property());
  const Image theirs = this->Shown.frameBy(stock);
  EXPECT_GT(compare(theirs, sound).Max, 0.02);

  const ErrorWatch watch(this->Shown.Mapper);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(compare(this->Shown.frame(), theirs).Max, 0.0);
    ASSERT_EQ(watch.Warnings.size(), 1u);
    EXPECT_EQ(this->Shown.Mapper->GetLastUsedRenderMode(), stock->GetLastUsedRenderMode());
    EXPECT_EQ(this->Shown.Mapper->GetGPUMemoryBytes(), 0) << "ours is not drawn";
  }
  EXPECT_NE(watch.Warnings[0].find(request.Words), std::string::npos) << watch.Warnings[0];
  EXPECT_NE(watch.Warnings[0].find("vtkSmartVolumeMapper"), std::string::npos);

  request.Undo(this->Shown.Mapper, this->Shown.property());
  EXPECT_EQ(compare(this->Shown.frame(), sound).Max, 0.0);
  EXPECT_EQ(this->Shown.Mapper->GetLastUsedRenderMode(), vtkSmartVolumeMapper::GPURenderMode);
  request.Make(this->Shown.Mapper, this->Shown.property());
  this->Shown.frame();
  EXPECT_EQ(watch.Warnings.size(), 1u) << "the same reason is said once";
  EXPECT_EQ(watch.Errors, std::vector<std::string>());
}

// VTK draws no blocks.
TEST_P(SmartFallBackBy, OfBlocksIsAnError)
{
  const Request& request = this->GetParam();
  vtkNew<vtkMultiBlockDataSet> tree;
  tree->SetBlock(0, this->Shown.Data);
  this->Shown.Mapper->SetInputDataObject(tree);
  const Image sound = this->Shown.frame();
  const ErrorWatch watch(this->Shown.Mapper);
  request.Make(this->Shown.Mapper, this->Shown.property());
  const Image empty = this->Shown.frame();
  EXPECT_EQ(compare(empty, Image(96, 96), {}, 0, Channels::Rgb).Max, 0.0);
  ASSERT_EQ(watch.Errors.size(), 1u);
  EXPECT_NE(watch.Errors[0].find(request.Words), std::string::npos) << watch.Errors[0];
  request.Undo(this->Shown.Mapper, this->Shown.property());
  EXPECT_EQ(compare(this->Shown.frame(), sound).Max, 0.0);
  EXPECT_EQ(watch.Errors.size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Request, SmartFallBackBy, testing::ValuesIn(requests),
  [](const auto& test) { return std::string(test.param.Name); });

TEST_F(SmartFallBack, TheGpuModeIsOurs)
{
  const Image sound = this->Shown.frame();
  const ErrorWatch watch(this->Shown.Mapper);
  this->Shown.Mapper->SetRequestedRenderModeToGPU();
  EXPECT_EQ(compare(this->Shown.frame(), sound).Max, 0.0);
  EXPECT_EQ(this->Shown.Mapper->GetLastUsedRenderMode(), vtkSmartVolumeMapper::GPURenderMode);
  EXPECT_GT(this->Shown.Mapper->GetGPUMemoryBytes(), 0);
  EXPECT_EQ(watch.Warnings, std::vector<std::string>());
}

// The mode is passed on, whether this VTK has OSPRay or not.
TEST_F(SmartFallBack, OSPRayIsLeftToVtk)
{
  ErrorWatch watch(this->Shown.Mapper);
  this->Shown.Mapper->SetRequestedRenderModeToOSPRay();
  this->Shown.frame();
  EXPECT_EQ(this->Shown.Mapper->GetLastUsedRenderMode(), vtkSmartVolumeMapper::OSPRayRenderMode);
  ASSERT_EQ(watch.Warnings.size(), 1u);
  EXPECT_NE(watch.Warnings[0].find("OSPRay"), std::string::npos);
}

class Masked : public vtkTetMarchSmartVolumeMapper
{
public:
  static Masked* New();
  vtkTypeMacro(Masked, vtkTetMarchSmartVolumeMapper);
  void setMask(vtkImageData* mask) { this->GPUMapper->SetMaskInput(mask); }
};
vtkStandardNewMacro(Masked);

// A class derived from vtkSmartVolumeMapper can set a mask.
TEST_F(SmartFallBack, MasksAreLeftToVtk)
{
  vtkNew<Masked> mapper;
  vtkNew<vtkImageData> mask;
  mask->CopyStructure(vtkImageData::SafeDownCast(this->Shown.Data));
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  mask->GetPointData()->GetScalars()->Fill(1);
  mapper->setMask(mask);
  const ErrorWatch watch(mapper);
  this->Shown.frameBy(mapper);
  ASSERT_EQ(watch.Warnings.size(), 1u);
  EXPECT_NE(watch.Warnings[0].find("mask"), std::string::npos);
}
} // namespace
