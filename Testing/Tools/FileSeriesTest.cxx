// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Lists of files by time: .pvd and .series.
#include "FileSeries.h"
#include "FileContents.h"
#include "ReaderCase.h"
#include "TestGrids.h"
#include "TimeSteps.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkXMLImageDataWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

namespace
{
using namespace tetmarch;

class SeriesReader : public ReaderCase
{
protected:
  /// A small image whose value is everywhere the same.
  std::string WriteImage(const char* name, double value) const
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(2, 2, 2);
    vtkNew<vtkDoubleArray> values;
    values->SetName("s");
    values->SetNumberOfTuples(8);
    values->Fill(value);
    image->GetPointData()->SetScalars(values);
    return this->Write<vtkXMLImageDataWriter>(name, image);
  }

  std::string WritePvd(const std::string& entries) const
  {
    return this->WriteText("list.pvd",
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n" +
        entries + "</Collection>\n</VTKFile>\n");
  }

  static double GetValue(vtkDataSet* data)
  {
    return data->GetPointData()->GetArray("s")->GetComponent(0, 0);
  }
  static double GetValueOf(const std::string& path, std::optional<int> step)
  {
    return GetValue(ReadVolume(path, step).Blocks.at(0));
  }
};

TEST_F(SeriesReader, TimeStepsOfPvdAreInTheOrderOfTheirTimes)
{
  this->WriteImage("a.vti", 1.0);
  this->WriteImage("b.vti", 2.0);
  const std::string path = this->WritePvd("<DataSet timestep=\"2.5\" part=\"0\" file=\"b.vti\"/>\n"
                                          "<DataSet timestep=\"-1\" part=\"0\" file=\"a.vti\"/>\n");
  EXPECT_EQ(GetTimeSteps(path), (std::vector<double>{ -1.0, 2.5 }));
  EXPECT_EQ(GetValueOf(path, 0), 1.0);
  EXPECT_EQ(GetValueOf(path, 1), 2.0);
  EXPECT_EQ(GetValueOf(path, std::nullopt), 2.0); // the last
  const VolumeData data = ReadVolume(path, 0);
  EXPECT_TRUE(data.Structured);
  EXPECT_EQ(data.Times, (std::vector<double>{ -1.0, 2.5 }));
  EXPECT_EQ(data.TimeStep, 0);
  EXPECT_TRUE(vtkImageData::SafeDownCast(data.Input)); // one part is no tree
  EXPECT_EQ(
    this->GetError(path, 2), "time step 2 does not exist: the file has 2, counted from 0 to 1");
}

TEST_F(SeriesReader, PartsOfATimeStepAreBlocks)
{
  this->WriteImage("a.vti", 1.0);
  this->WriteImage("b.vti", 2.0);
  this->WriteImage("c.vti", 3.0);
  const std::string path =
    this->WritePvd("<DataSet timestep=\"0\" part=\"1\" name=\"second\" file=\"b.vti\"/>\n"
                   "<DataSet timestep=\"0\" part=\"0\" group=\"first\" file=\"a.vti\"/>\n"
                   "<DataSet timestep=\"1\" part=\"0\" file=\"c.vti\"/>\n");
  const FileContents step = ReadFile(path, 0, {}, {});
  auto* tree = vtkMultiBlockDataSet::SafeDownCast(step.Data);
  ASSERT_NE(tree, nullptr);
  ASSERT_EQ(tree->GetNumberOfBlocks(), 2u);
  EXPECT_EQ(GetValue(vtkDataSet::SafeDownCast(tree->GetBlock(0))), 1.0);
  EXPECT_EQ(GetValue(vtkDataSet::SafeDownCast(tree->GetBlock(1))), 2.0);
  EXPECT_STREQ(tree->GetMetaData(0u)->Get(vtkCompositeDataSet::NAME()), "first");
  EXPECT_STREQ(tree->GetMetaData(1u)->Get(vtkCompositeDataSet::NAME()), "second");
  EXPECT_EQ(ReadVolume(path, 0).Blocks.size(), 2u);
  EXPECT_EQ(ReadVolume(path, 1).Blocks.size(), 1u);
}

TEST_F(SeriesReader, WithoutTimesAllFilesAreParts)
{
  this->WriteImage("a.vti", 1.0);
  this->WriteImage("b.vti", 2.0);
  const std::string path = this->WritePvd("<DataSet file=\"a.vti\"/>\n<DataSet file=\"b.vti\"/>\n");
  EXPECT_TRUE(GetTimeSteps(path).empty());
  EXPECT_EQ(ReadVolume(path, std::nullopt).Blocks.size(), 2u);
  EXPECT_EQ(this->GetError(path, 0), "time step 0 does not exist: the file has no time steps");
}

TEST_F(SeriesReader, AGridOfASeriesIsThatOfItsFile)
{
  // Two tetrahedra whose points coincide, but are not the same: pieces would be merged.
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  for (int k = 0; k < 2; ++k)
  {
    points->InsertNextPoint(0, 0, 0);
    points->InsertNextPoint(1, 0, 0);
    points->InsertNextPoint(0, 1, 0);
    points->InsertNextPoint(0, 0, k ? 1 : -1);
  }
  grid->SetPoints(points);
  const vtkIdType cells[2][4] = { { 0, 2, 1, 3 }, { 4, 5, 6, 7 } };
  grid->InsertNextCell(VTK_TETRA, 4, cells[0]);
  grid->InsertNextCell(VTK_TETRA, 4, cells[1]);
  AddArray<vtkDoubleArray>(grid->GetPointData(), "s", 8);
  this->Write<vtkXMLUnstructuredGridWriter>("a.vtu", grid);
  const std::string path = this->WritePvd("<DataSet timestep=\"0\" file=\"a.vtu\"/>\n");
  EXPECT_EQ(ReadVolume(path, 0).Blocks.at(0)->GetNumberOfPoints(), 8);
}

TEST_F(SeriesReader, TimeStepsOfSeries)
{
  std::filesystem::create_directories(this->Folder / "deep");
  this->WriteImage("deep/a.vti", 1.0);
  const std::string other = this->WriteImage("b.vti", 2.0);
  const std::string path = this->WriteText("x.vti.series",
    R"({"file-series-version": "1.0", "files": [{"name": "deep/a.vti", "time": 3}, {"name": ")" +
      other + R"(", "time": 0.5}]})");
  EXPECT_EQ(GetTimeSteps(path), (std::vector<double>{ 0.5, 3.0 }));
  EXPECT_EQ(GetValueOf(path, 0), 2.0);
  EXPECT_EQ(GetValueOf(path, 1), 1.0);
}

TEST_F(SeriesReader, BadListsAreRefused)
{
  const int errors = Messages::GetNumberOfErrors();
  const auto refused = [this](const std::string& path, const std::string& reason)
  {
    const std::string error = this->GetError(path);
    EXPECT_EQ(error.find("cannot read '" + path + "': "), 0u) << error;
    EXPECT_NE(error.find(reason), std::string::npos) << error;
  };
  refused(this->GetPath("none.pvd"), "there is no such file");
  refused(this->WriteText("text.pvd", "no list"), "it is no XML (");
  refused(this->WriteText("half.pvd", "<VTKFile><Collection>"), "it is no XML (");
  refused(this->WriteText("empty.pvd", ""), "it is no XML");
  refused(this->WriteText("grid.pvd", "<VTKFile type=\"ImageData\"><ImageData/></VTKFile>"),
    "it has no element <Collection>");
  refused(this->WritePvd(""), "it lists no files");
  refused(this->WritePvd("<DataSet timestep=\"0\"/>"), "it lists a file without a name");
  refused(this->WritePvd("<DataSet timestep=\"soon\" file=\"a.vti\"/>"), "'soon' is no time");
  refused(this->WritePvd("<DataSet timestep=\"nan\" file=\"a.vti\"/>"), "'nan' is no time");
  refused(this->WritePvd("<DataSet timestep=\"0\" file=\"list.pvd\"/>"),
    "it lists 'list.pvd', which is a list of files itself");
  refused(this->WritePvd("<DataSet timestep=\"0\" file=\"gone.vti\"/>"), "which isn't there");
  refused(this->WriteText("text.series", "no list"), "it is no JSON");
  refused(this->WriteText("number.series", "7"), "it has no list \"files\"");
  refused(this->WriteText("none.series", R"({"files": []})"), "it lists no files");
  refused(this->WriteText("timeless.series", R"({"files": [{"name": "a.vti"}]})"),
    "each entry of \"files\" needs");
  refused(this->WriteText("nameless.series", R"({"files": [{"name": "", "time": 1}]})"),
    "it lists a file without a name");
  EXPECT_EQ(Messages::GetNumberOfErrors(), errors); // each is told once
}

} // namespace
