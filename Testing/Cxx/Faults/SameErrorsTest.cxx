// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the mappers refuse the first picture refuses with the same words, and what it takes is
// drawn.
#include "ErrorScene.h"
#include "SmartScene.h"
#include "UnsoundData.h"

#include "vtkTetMarchFirstPicture.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 32;

// Without line, class and address.
std::string textOf(const ErrorWatch& watch)
{
  if (watch.Errors.empty())
  {
    return {};
  }
  const std::string begin = "): ";
  std::string text = watch.Errors.back().substr(watch.Errors.back().find(begin) + begin.size());
  while (!text.empty() && text.back() == '\n')
  {
    text.pop_back();
  }
  return text;
}

bool isLattice(vtkDataObject* data)
{
  return vtkImageData::SafeDownCast(data) || vtkRectilinearGrid::SafeDownCast(data);
}

// The mapper for unstructured grids takes curvilinear ones as blocks of a tree.
vtkSmartPointer<vtkDataObject> drawableOf(vtkDataSet* data)
{
  if (!vtkStructuredGrid::SafeDownCast(data))
  {
    return data;
  }
  auto tree = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  tree->SetBlock(0, data);
  return tree;
}

template <typename SceneType>
std::string errorOfMapper(SceneType& scene, vtkDataObject* data)
{
  scene.Mapper->SetInputDataObject(scene.Data);
  scene.Window->Render(); // an error comes again only after it was put right
  const ErrorWatch watch(scene.Mapper);
  scene.Mapper->SetInputDataObject(data);
  scene.Window->Render();
  if (watch.Errors.empty())
  {
    scene.Mapper->Render(scene.Renderer, scene.Volume); // VTK leaves out what has no bounds
  }
  return textOf(watch);
}

class SameErrors : public ::testing::Test
{
protected:
  std::string errorOfMapper(vtkDataObject* data)
  {
    return isLattice(data) ? ::errorOfMapper(this->Smart, data)
                           : ::errorOfMapper(this->Cells, data);
  }
  // Of each way in which the data is read, the error that all of them have.
  static std::string errorOfFirstPicture(vtkDataObject* data)
  {
    vtkNew<vtkTetMarchFirstPicture> first;
    const ErrorWatch watch(first);
    first->SetInputData(data);
    EXPECT_FALSE(first->Choose());
    std::string error = textOf(watch);
    first->SetArrayName("f");
    EXPECT_FALSE(first->ChooseArray());
    EXPECT_EQ(textOf(watch), error);
    EXPECT_FALSE(first->ChooseTransferFunctions());
    EXPECT_EQ(textOf(watch), error);
    return error;
  }

  Scene Cells{ ErrorScene::soundGrid(), Side, Side };
  SmartScene Smart{ imageOf(sineField(), unitCube(3)), Side, Side };
};

TEST_F(SameErrors, OfGeometry)
{
  for (const UnsoundData& unsound : unsoundGeometries())
  {
    SCOPED_TRACE(unsound.Name);
    const auto data = drawableOf(unsound.Data);
    const std::string error = errorOfFirstPicture(data);
    for (const std::string& word : unsound.Words)
    {
      EXPECT_NE(error.find(word), std::string::npos) << word << " in: " << error;
    }
    EXPECT_EQ(this->errorOfMapper(data), error);
    vtkNew<vtkTetMarchFirstPicture> first;
    const ErrorWatch watch(first);
    first->SetInputData(data);
    EXPECT_FALSE(first->ListArrays(vtkNew<vtkTable>()));
    EXPECT_FALSE(first->PlaceCamera(vtkNew<vtkCamera>(), 1.5));
    EXPECT_FALSE(first->FitCamera(vtkNew<vtkCamera>(), vtkNew<vtkVolume>(), 1.5));
    EXPECT_EQ(watch.Errors.size(), 3u);
  }
}

TEST_F(SameErrors, OfArrays)
{
  for (const UnsoundData& unsound : unsoundArrays())
  {
    SCOPED_TRACE(unsound.Name);
    const std::string error = errorOfFirstPicture(unsound.Data);
    EXPECT_NE(error.find(unsound.Words[0]), std::string::npos) << error;
    const auto data = drawableOf(unsound.Data);
    const std::string prefix = data == unsound.Data ? "" : "Block number 1: ";
    EXPECT_EQ(this->errorOfMapper(data), prefix + error);
  }
}

// The first picture goes by another array, if there is one.
TEST_F(SameErrors, OneArrayThatFitsIsEnough)
{
  for (const UnsoundData& unsound : unsoundArrays())
  {
    SCOPED_TRACE(unsound.Name);
    vtkNew<vtkDoubleArray> fits;
    fits->SetName("fits");
    for (vtkIdType i = 0; i < unsound.Data->GetNumberOfPoints(); ++i)
    {
      fits->InsertNextValue(0.5 * double(i));
    }
    unsound.Data->GetPointData()->AddArray(fits);
    vtkNew<vtkTetMarchFirstPicture> first;
    first->SetInputData(unsound.Data);
    ASSERT_TRUE(first->Choose());
    EXPECT_STREQ(first->GetChosenArray()->GetName(), "fits");
    vtkNew<vtkTable> arrays;
    EXPECT_TRUE(first->ListArrays(arrays));
    EXPECT_EQ(arrays->GetNumberOfRows(), 1);
  }
}

// Where VTK itself doesn't read them: see unsoundGeometries() for curvilinear grids.
TEST_F(SameErrors, GhostsThatDoNotFitHideNothing)
{
  for (const auto& data : soundData())
  {
    if (vtkStructuredGrid::SafeDownCast(data))
    {
      continue;
    }
    SCOPED_TRACE(data->GetClassName());
    vtkNew<vtkTetMarchFirstPicture> first;
    first->SetInputData(data);
    ASSERT_TRUE(first->Choose());
    const double before = first->GetUnitDistance();
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfValues(5);
    ghosts->Fill(vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::HIDDENPOINT);
    data->GetPointData()->AddArray(ghosts);
    data->GetCellData()->AddArray(ghosts);
    ASSERT_TRUE(first->Choose());
    EXPECT_EQ(first->GetUnitDistance(), before);
    EXPECT_EQ(this->errorOfMapper(data), "");
    EXPECT_EQ(data->GetPointData()->GetNumberOfArrays(), 2) << "the data stays as it is";
  }
}

// Values and coordinates at the ends of double precision.
class Extremes : public SameErrors
{
protected:
  template <typename SceneType>
  void expectDrawn(SceneType& scene, vtkDataObject* data)
  {
    vtkNew<vtkTetMarchFirstPicture> first;
    const ErrorWatch choosing(first);
    const ErrorWatch drawing(scene.Mapper);
    first->SetInputData(data);
    ASSERT_TRUE(first->Choose());
    EXPECT_LT(first->GetChosenRange()[0], first->GetChosenRange()[1]);
    EXPECT_TRUE(std::isfinite(first->GetChosenRange()[1] - first->GetChosenRange()[0]));
    EXPECT_TRUE(std::isfinite(first->GetUnitDistance()));
    scene.Mapper->SetInputDataObject(data);
    first->ApplyTo(scene.Volume);
    first->PlaceCamera(scene.Renderer->GetActiveCamera(), 1.0);
    scene.Renderer->ResetCameraClippingRange();
    scene.Window->Render();
    const Image drawn = framePictureOf(scene.Window);
    scene.Volume->VisibilityOff();
    scene.Window->Render();
    EXPECT_GT(compare(drawn, framePictureOf(scene.Window)).Max, 0.05);
    scene.Volume->VisibilityOn();
    EXPECT_EQ(textOf(choosing), "");
    EXPECT_EQ(textOf(drawing), "");
  }
};

TEST_F(Extremes, OfValues)
{
  constexpr double most = std::numeric_limits<double>::max();
  constexpr double least = std::numeric_limits<double>::denorm_min();
  const std::vector<std::vector<double>> values{ { -most, most }, { 0.9 * most, most },
    { 0, least, 2 * least, 3 * least }, { -1e-300, 1e-300 }, { 1e300, 1e300 } };
  for (const auto& data : soundData())
  {
    for (std::size_t k = 0; k < values.size(); ++k)
    {
      SCOPED_TRACE(std::string(data->GetClassName()) + ", values " + std::to_string(k));
      vtkDataArray* array = data->GetPointData()->GetScalars();
      for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
      {
        array->SetComponent(i, 0, values[k][i / 3 % values[k].size()]);
      }
      array->Modified();
      const auto drawable = drawableOf(data);
      isLattice(drawable) ? this->expectDrawn(this->Smart, drawable)
                          : this->expectDrawn(this->Cells, drawable);
    }
  }
}

TEST_F(Extremes, OfCoordinates)
{
  for (const double scale : { 1e-15, 1e15, 1e30, 1e37, 1e45, 1e99 })
  {
    SCOPED_TRACE(scale);
    this->expectDrawn(this->Cells, withOffsetAndScale(ErrorScene::soundGrid(), { 0, 0, 0 }, scale));
    const auto image = imageOf(sineField(), unitCube(6));
    image->SetSpacing(0.2 * scale, 0.2 * scale, 0.2 * scale);
    this->expectDrawn(this->Smart, image);
  }
}
} // namespace
