// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Input that can't be drawn is reported once, with what is wrong and what helps, and leaves no
// trace when it is put right; by both mappers.
#include "ErrorCases.h"

#include "vtkCallbackCommand.h"
#include "vtkOpenGLRenderUtilities.h"

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

namespace
{
using namespace tetmarch::testing;

template <typename SceneType>
class Errors : public ErrorsIn<SceneType>
{
protected:
  Errors()
    : ErrorsIn<SceneType>(soundOf(static_cast<SceneType*>(nullptr)))
  {
  }
};
using Scenes = testing::Types<Scene, ImageScene>;
TYPED_TEST_SUITE(Errors, Scenes);

TYPED_TEST(Errors, ComeOnceAndLeaveNoTrace)
{
  ErrorCases<TypeParam> cases;
  addErrorsOfAnyMapper(cases);
  addErrorsOfOne(cases);
  for (const auto& each : cases.All)
  {
    SCOPED_TRACE(each.Name);
    this->expectError(
      [&] { each.Spoil(this->Shown); }, [&] { cases.mend(this->Shown); }, each.Said);
  }
}

TYPED_TEST(Errors, ErrorsOfOthersInTheGLAreNotOurs)
{
  this->Shown.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
  const Image expected = this->frame();
  const ErrorWatch watch(this->Shown.Mapper);
  this->Shown.Window->SetSize(this->Side + 1, this->Side); // so that textures are made anew
  this->frame();
  this->Shown.Window->SetSize(this->Side, this->Side);
  glEnable(GL_TEXTURE_BUFFER); // no capability: a GL error
  EXPECT_EQ(compare(this->frame(), expected).Max, 0.0);
  EXPECT_EQ(watch.Errors, Words());
}

std::vector<vtkSmartPointer<vtkDataObject>> emptyData(const Scene*)
{
  return { emptyGrid(), triangleAndLineGrid(), vtkNew<vtkUnstructuredGrid>() };
}
std::vector<vtkSmartPointer<vtkDataObject>> emptyData(const ImageScene*)
{
  return { vtkNew<vtkImageData>(), vtkNew<vtkRectilinearGrid>(), vtkNew<vtkMultiBlockDataSet>() };
}

TYPED_TEST(Errors, NothingToDrawIsNone)
{
  for (const auto& empty : emptyData(&this->Shown))
  {
    this->show(empty);
    this->expectEmptyWithoutErrors();
    this->showSound();
    this->expectSound();
  }
}

TYPED_TEST(Errors, TransparentFunctionsDrawNothing)
{
  vtkNew<vtkVolumeProperty> clear;
  setPlainFunctions(clear, { 1.0, 1.0, 1.0 }, 0.0);
  const vtkSmartPointer<vtkVolumeProperty> opaque = this->Shown.property();
  this->Shown.Volume->SetProperty(clear);
  this->expectNothingVisible();
  this->Shown.Volume->SetProperty(opaque);
  this->expectSound();
}

TYPED_TEST(Errors, AllScalarsNaNDrawNothing)
{
  for (const bool ofCells : { false, true })
  {
    const auto data = soundOf(&this->Shown);
    vtkDataArray* array =
      ofCells ? data->GetCellData()->GetScalars() : data->GetPointData()->GetScalars();
    array->Fill(std::nan(""));
    this->Shown.Mapper->SetScalarMode(
      ofCells ? VTK_SCALAR_MODE_USE_CELL_DATA : VTK_SCALAR_MODE_USE_POINT_DATA);
    this->showSound();
    this->frame(); // the array is not finite once more
    this->show(data);
    this->expectNothingVisible();
  }
}

TYPED_TEST(Errors, DefaultPropertyIsNone)
{
  this->Shown.Volume->SetProperty(nullptr);
  const ErrorWatch watch(this->Shown.Mapper);
  this->frame();
  EXPECT_EQ(watch.Errors, Words());
}

TEST(BlendModeNumbers, AreThoseOfVolumeMappers)
{
  using Ours = vtkTetMarchVolumeMapper;
  using Theirs = vtkVolumeMapper;
  EXPECT_EQ(int(Ours::COMPOSITE_BLEND), int(Theirs::COMPOSITE_BLEND));
  EXPECT_EQ(int(Ours::MAXIMUM_INTENSITY_BLEND), int(Theirs::MAXIMUM_INTENSITY_BLEND));
  EXPECT_EQ(int(Ours::MINIMUM_INTENSITY_BLEND), int(Theirs::MINIMUM_INTENSITY_BLEND));
  EXPECT_EQ(int(Ours::AVERAGE_INTENSITY_BLEND), int(Theirs::AVERAGE_INTENSITY_BLEND));
  EXPECT_EQ(int(Ours::ADDITIVE_BLEND), int(Theirs::ADDITIVE_BLEND));
  EXPECT_EQ(int(Ours::ISOSURFACE_BLEND), int(Theirs::ISOSURFACE_BLEND));
}

class MeshErrors : public ErrorScene
{
};

TEST_F(MeshErrors, AbortedBuildDrawsNothingAndIsMadeUpFor)
{
  const Grid grid = withCells32(soundGrid()); // another grid that looks the same
  this->show(grid);
  const ErrorWatch watch(this->Shown.Mapper);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetClientData(this->Shown.Window);
  abort->SetCallback([](vtkObject*, unsigned long, void* window, void*)
    { static_cast<vtkRenderWindow*>(window)->SetAbortRender(1); });
  const unsigned long tag = this->Shown.Window->AddObserver(vtkCommand::AbortCheckEvent, abort);
  // Windows ask at most five times a second.
  std::this_thread::sleep_for(std::chrono::milliseconds(250));
  const vtkTypeInt64 bytes = this->Shown.Mapper->GetUploadedBytes();
  this->Shown.Window->Render();
  EXPECT_EQ(this->Shown.Mapper->GetUploadedBytes(), bytes);
  EXPECT_EQ(this->Shown.Mapper->GetNumberOfTetrahedra(), 0);
  EXPECT_EQ(compare(this->Shown.frame(), this->Empty).Max, 0.0);
  this->Shown.Window->RemoveObserver(tag);
  this->expectSound();
  EXPECT_EQ(watch.Errors, Words());
}
} // namespace
