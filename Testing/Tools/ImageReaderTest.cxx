// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Images and rectilinear grids stay what they are, whatever file they come from.
#include "ReaderCase.h"
#include "TestGrids.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMetaImageWriter.h"
#include "vtkRectilinearGrid.h"
#include "vtkRectilinearGridWriter.h"
#include "vtkStructuredPointsWriter.h"
#include "vtkUnsignedShortArray.h"
#include "vtkXMLImageDataWriter.h"
#include "vtkXMLRectilinearGridWriter.h"

namespace
{
using ImageReader = ReaderCase;
using tetmarch::ReadVolume;
using tetmarch::VolumeData;

constexpr int Dimensions[3] = { 12, 4, 5 };

// Of all points along x, y and z, and in all data.
double ValueAt(int i, int j, int k) { return i + 12 * j + 48 * k; }

vtkSmartPointer<vtkImageData> MakeImage(int firstSlice = 0, int lastSlice = 4)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(0, 11, 0, 3, firstSlice, lastSlice);
  image->SetSpacing(1.0, 2.0, 3.0);
  image->SetOrigin(5.0, 6.0, 7.0);
  image->AllocateScalars(VTK_UNSIGNED_SHORT, 1);
  image->GetPointData()->GetScalars()->SetName("s");
  for (int k = firstSlice; k <= lastSlice; ++k)
  {
    for (int j = 0; j < 4; ++j)
    {
      for (int i = 0; i < 12; ++i)
      {
        image->SetScalarComponentFromDouble(i, j, k, 0, ValueAt(i, j, k));
      }
    }
  }
  return image;
}

vtkSmartPointer<vtkRectilinearGrid> MakeRectilinear(int firstSlice = 0, int lastSlice = 4)
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetExtent(0, 11, 0, 3, firstSlice, lastSlice);
  const int first[3] = { 0, 0, firstSlice };
  const int last[3] = { 11, 3, lastSlice };
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkNew<vtkDoubleArray> coordinates;
    for (int i = first[axis]; i <= last[axis]; ++i)
    {
      coordinates->InsertNextValue(i * i + axis);
    }
    axis == 0   ? grid->SetXCoordinates(coordinates)
    : axis == 1 ? grid->SetYCoordinates(coordinates)
                : grid->SetZCoordinates(coordinates);
  }
  grid->GetPointData()->ShallowCopy(MakeImage(firstSlice, lastSlice)->GetPointData());
  return grid;
}

std::string DescribeExtent(int firstSlice, int lastSlice)
{
  return "0 11 0 3 " + std::to_string(firstSlice) + " " + std::to_string(lastSlice);
}

// Two pieces that share a slice, 0 to 2 and 2 to 4.
std::string DescribePieces(const std::string& type, const std::string& more,
  const std::string& inner, const std::string& ending)
{
  return "<VTKFile type=\"" + type + "\" version=\"0.1\"><" + type + " WholeExtent=\"" +
         DescribeExtent(0, 4) + "\" GhostLevel=\"0\" " + more + "><PPointData Scalars=\"s\">" +
         "<PDataArray type=\"UInt16\" Name=\"s\"/></PPointData>" + inner + "<Piece Extent=\"" +
         DescribeExtent(0, 2) + "\" Source=\"0" + ending + "\"/><Piece Extent=\"" +
         DescribeExtent(2, 4) + "\" Source=\"1" + ending + "\"/></" + type + "></VTKFile>";
}

void ExpectValues(vtkDataSet* data, const std::string& path)
{
  vtkDataArray* array = data->GetPointData()->GetArray(0);
  ASSERT_NE(array, nullptr) << path;
  ASSERT_EQ(array->GetNumberOfTuples(), 240) << path;
  for (vtkIdType i = 0; i < 240; ++i)
  {
    ASSERT_EQ(array->GetComponent(i, 0), static_cast<double>(i)) << path; // as ValueAt()
  }
}

vtkImageData* ExpectImage(const VolumeData& volume, const std::string& path)
{
  EXPECT_TRUE(volume.Structured) << path;
  EXPECT_EQ(volume.Blocks.size(), 1u) << path;
  EXPECT_EQ(volume.Blocks[0], volume.Input) << path;
  auto* image = vtkImageData::SafeDownCast(volume.Input);
  if (!image)
  {
    ADD_FAILURE() << path << " is read as " << volume.Input->GetClassName();
    return nullptr;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(image->GetDimensions()[axis], Dimensions[axis]) << path;
    EXPECT_EQ(image->GetSpacing()[axis], axis + 1.0) << path;
  }
  ExpectValues(image, path);
  return image;
}

} // namespace

TEST_F(ImageReader, ReadsImagesOfVTK)
{
  const auto image = MakeImage();
  for (const std::string& path : { this->Write<vtkXMLImageDataWriter>("image.vti", image),
         this->Write<vtkStructuredPointsWriter>("image.vtk", image) })
  {
    const VolumeData volume = ReadVolume(path, std::nullopt);
    vtkImageData* read = ExpectImage(volume, path);
    ASSERT_NE(read, nullptr);
    EXPECT_EQ(read->GetOrigin()[2], 7.0) << path;
    EXPECT_STREQ(read->GetPointData()->GetArray(0)->GetName(), "s") << path;
    EXPECT_EQ(read->GetScalarType(), VTK_UNSIGNED_SHORT) << path;
  }
}

TEST_F(ImageReader, ReadsPiecesOfImages)
{
  this->Write<vtkXMLImageDataWriter>("0.vti", MakeImage(0, 2));
  this->Write<vtkXMLImageDataWriter>("1.vti", MakeImage(2, 4));
  const std::string path = this->WriteText(
    "all.pvti", DescribePieces("PImageData", "Origin=\"5 6 7\" Spacing=\"1 2 3\"", "", ".vti"));
  ExpectImage(ReadVolume(path, std::nullopt), path);
}

TEST_F(ImageReader, ReadsRectilinearGrids)
{
  const auto grid = MakeRectilinear();
  this->Write<vtkXMLRectilinearGridWriter>("0.vtr", MakeRectilinear(0, 2));
  this->Write<vtkXMLRectilinearGridWriter>("1.vtr", MakeRectilinear(2, 4));
  const std::string axis = "<PDataArray type=\"Float64\"/>";
  for (const std::string& path : { this->Write<vtkXMLRectilinearGridWriter>("grid.vtr", grid),
         this->Write<vtkRectilinearGridWriter>("grid.vtk", grid),
         this->WriteText(
           "all.pvtr", DescribePieces("PRectilinearGrid", "",
                         "<PCoordinates>" + axis + axis + axis + "</PCoordinates>", ".vtr")) })
  {
    const VolumeData volume = ReadVolume(path, std::nullopt);
    EXPECT_TRUE(volume.Structured) << path;
    auto* read = vtkRectilinearGrid::SafeDownCast(volume.Input);
    ASSERT_NE(read, nullptr) << path;
    EXPECT_EQ(read->GetNumberOfPoints(), 240) << path;
    EXPECT_EQ(read->GetXCoordinates()->GetComponent(11, 0), 121.0) << path;
    EXPECT_EQ(read->GetZCoordinates()->GetComponent(4, 0), 18.0) << path;
    ExpectValues(read, path);
  }
}

TEST_F(ImageReader, ReadsMetaImages)
{
  const auto image = MakeImage();
  for (const std::string& path : { this->Write<vtkMetaImageWriter>("image.mha", image),
         this->Write<vtkMetaImageWriter>("image.mhd", image) })
  {
    ExpectImage(ReadVolume(path, std::nullopt), path);
  }
}

TEST_F(ImageReader, TellsOfImagesWithoutVolume)
{
  const auto image = MakeImage(2, 2);
  const std::string path = this->Write<vtkXMLImageDataWriter>("flat.vti", image);
  EXPECT_EQ(GetError(path),
    "'" + path +
      "' has no 3D cells, so there is no volume to render (vtkImageData of 12 x 4 x 1 points)");
}

// Also of a thousand million cells: none of them is looked at.
TEST_F(ImageReader, KnowsLargeImagesToBeSolid)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(100000, 100000, 2);
  EXPECT_TRUE(tetmarch::HasSolidCells(image));
  image->SetDimensions(100000, 1, 100000);
  EXPECT_FALSE(tetmarch::HasSolidCells(image));
  image->SetDimensions(0, 0, 0);
  EXPECT_FALSE(tetmarch::HasSolidCells(image));
}
