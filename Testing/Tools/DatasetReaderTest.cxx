// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReaderCase.h"
#include "TestGrids.h"

#include "vtkCellArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyDataWriter.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGridWriter.h"
#include "vtkXMLMultiBlockDataWriter.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <fstream>

using DatasetReader = ReaderCase;

TEST_F(DatasetReader, RefusesWhatIsNoFile)
{
  const std::string missing = this->GetPath("none.vtu");
  EXPECT_EQ(GetError(missing), "cannot read '" + missing + "': there is no such file");
  EXPECT_EQ(
    GetError(this->Folder.string()), "cannot read '" + this->Folder.string() + "': it is a folder");
}

TEST_F(DatasetReader, ReadsSurfaces)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, 1.0, 0.0);
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2 });
  surface->SetLines(cells);
  const std::string lines = this->Write<vtkXMLPolyDataWriter>("lines.vtp", surface);
  surface->SetPolys(cells);
  for (const std::string& path : { this->Write<vtkXMLPolyDataWriter>("surface.vtp", surface),
         this->Write<vtkPolyDataWriter>("surface.vtk", surface) })
  {
    EXPECT_EQ(tetmarch::ReadSurface(path)->GetNumberOfPolys(), 1);
    EXPECT_EQ(GetError(path),
      "'" + path + "' has no 3D cells, so there is no volume to render (vtkPolyData)");
  }
  try
  {
    tetmarch::ReadSurface(lines);
    ADD_FAILURE() << "lines are no surface";
  }
  catch (const tetmarch::Failure& failure)
  {
    EXPECT_EQ(failure.what(),
      "'" + lines + "' has no polygons, so there is no surface to draw (vtkPolyData)");
  }
}

TEST_F(DatasetReader, RefusesUnknownEndings)
{
  const std::string path = this->GetPath("mesh.msh");
  std::ofstream(path) << "x";
  EXPECT_EQ(GetError(path).find("cannot read '" + path + "': no reader for the ending '.msh'"), 0u);
}

TEST_F(DatasetReader, RefusesGridsWithoutSolidCells)
{
  auto grid = MakeVoxel(0.0);
  const vtkIdType ids[3] = { 0, 1, 2 };
  grid->Allocate(1);
  grid->InsertNextCell(VTK_TRIANGLE, 3, ids);
  const std::string path = this->Write<vtkXMLUnstructuredGridWriter>("surface.vtu", grid);
  EXPECT_NE(GetError(path).find("has no 3D cells"), std::string::npos) << GetError(path);
}

TEST_F(DatasetReader, RefusesTimeStepsThatAreNotThere)
{
  const std::string path = this->Write<vtkXMLUnstructuredGridWriter>("grid.vtu", MakeVoxel(0.0));
  EXPECT_EQ(GetError(path, 3), "time step 3 does not exist: the file has no time steps");
}

TEST_F(DatasetReader, ReadsXMLAndLegacy)
{
  auto voxel = MakeVoxel(0.0);
  AddArray<vtkDoubleArray>(voxel->GetPointData(), "a", 8);
  AddArray<vtkDoubleArray>(voxel->GetPointData(), "b", 8);
  for (const std::string& path : { this->Write<vtkXMLUnstructuredGridWriter>("grid.vtu", voxel),
         this->Write<vtkUnstructuredGridWriter>("grid.VTK", voxel) })
  {
    const auto grid = tetmarch::ReadUnstructuredGrid(path, std::nullopt);
    EXPECT_EQ(grid->GetNumberOfCells(), 1) << path;
    EXPECT_EQ(grid->GetNumberOfPoints(), 8) << path;
    EXPECT_TRUE(grid->GetPointData()->HasArray("a")) << path;
    EXPECT_TRUE(grid->GetPointData()->HasArray("b")) << path;
  }
}

TEST_F(DatasetReader, ReadsPartitions)
{
  this->Write<vtkXMLUnstructuredGridWriter>("0.vtu", MakeVoxel(0.0));
  this->Write<vtkXMLUnstructuredGridWriter>("1.vtu", MakeVoxel(1.0));
  const auto text = [](const std::string& type, const std::string& inner)
  {
    return "<VTKFile type=\"" + type + "\" version=\"1.0\"><" + type + ">" + inner + "</" + type +
           "></VTKFile>";
  };
  const std::string files =
    "<DataSet index=\"0\" file=\"0.vtu\"/><DataSet index=\"1\" file=\"1.vtu\"/>";
  for (const std::string& path :
    { this->WriteText("voxels.vtpd", text("vtkPartitionedDataSet", files)),
      this->WriteText("voxels.vtpc", text("vtkPartitionedDataSetCollection",
                                       "<Partitions index=\"0\">" + files + "</Partitions>")) })
  {
    const auto grid = tetmarch::ReadUnstructuredGrid(path, std::nullopt);
    EXPECT_EQ(grid->GetNumberOfCells(), 2) << path;
    EXPECT_EQ(grid->GetNumberOfPoints(), 12) << path;
  }
}

TEST_F(DatasetReader, MergesBlocksAtTheirCommonPoints)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int i = 0; i < 3; ++i)
  {
    auto voxel = MakeVoxel(i);
    AddArray<vtkDoubleArray>(voxel->GetPointData(), "everywhere", 8);
    if (i == 1)
    {
      AddArray<vtkDoubleArray>(voxel->GetPointData(), "once", 8);
    }
    blocks->SetBlock(i, voxel);
  }
  const std::string path = this->Write<vtkXMLMultiBlockDataWriter>("blocks.vtm", blocks);
  ::testing::internal::CaptureStderr();
  const auto grid = tetmarch::ReadUnstructuredGrid(path, std::nullopt);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(),
    "tetmarch-render: warning: point array 'once' is left out: only 1 of 3 blocks have it\n");
  EXPECT_EQ(grid->GetNumberOfCells(), 3);
  EXPECT_EQ(grid->GetNumberOfPoints(), 16);
  EXPECT_TRUE(grid->GetPointData()->HasArray("everywhere"));
}

TEST_F(DatasetReader, MergesPiecesOfParallelFiles)
{
  for (const int i : { 0, 1 })
  {
    auto voxel = MakeVoxel(i);
    AddArray<vtkDoubleArray>(voxel->GetPointData(), "p", 8);
    AddArray<vtkDoubleArray>(voxel->GetCellData(), "c", 1);
    this->Write<vtkXMLUnstructuredGridWriter>(i == 0 ? "0.vtu" : "1.vtu", voxel);
  }
  std::ofstream(this->GetPath("all.pvtu"))
    << R"(<VTKFile type="PUnstructuredGrid" version="0.1"><PUnstructuredGrid GhostLevel="0">)"
    << R"(<PPointData><PDataArray type="Float64" Name="p"/></PPointData>)"
    << R"(<PCellData><PDataArray type="Float64" Name="c"/></PCellData>)"
    << R"(<PPoints><PDataArray type="Float32" NumberOfComponents="3"/></PPoints>)"
    << R"(<Piece Source="0.vtu"/><Piece Source="1.vtu"/></PUnstructuredGrid></VTKFile>)";
  const auto grid = tetmarch::ReadUnstructuredGrid(this->GetPath("all.pvtu"), std::nullopt);
  EXPECT_EQ(grid->GetNumberOfCells(), 2);
  EXPECT_EQ(grid->GetNumberOfPoints(), 12);
  EXPECT_TRUE(grid->GetPointData()->HasArray("p"));
  EXPECT_TRUE(grid->GetCellData()->HasArray("c"));
}

TEST_F(DatasetReader, RefusesNumbersOfComponentsThatAreNone)
{
  auto voxel = MakeVoxel(0.0);
  AddArray<vtkDoubleArray>(voxel->GetPointData(), "p", 8);
  this->Write<vtkXMLUnstructuredGridWriter>("0.vtu", voxel);
  for (const std::string number :
    { "-1", "1e30", "nan", "", "18446744073709551616", "2147483647", "1000001" })
  {
    const std::string path = this->WriteText("a.pvtu",
      "<VTKFile type=\"PUnstructuredGrid\" version=\"0.1\"><PUnstructuredGrid GhostLevel=\"0\">"
      "<PPointData><PDataArray type=\"Float64\" Name=\"p\" NumberOfComponents=\"" +
        number +
        "\"/></PPointData><PPoints><PDataArray type=\"Float32\" NumberOfComponents=\"3\"/>"
        "</PPoints><Piece Source=\"0.vtu\"/></PUnstructuredGrid></VTKFile>");
    EXPECT_EQ(
      GetError(path), "cannot read '" + path + "': an array has '" + number + "' components");
  }
}

TEST_F(DatasetReader, RefusesLegacyFilesThatEndInTheirValues)
{
  auto voxel = MakeVoxel(0.0);
  AddArray<vtkDoubleArray>(voxel->GetPointData(), "p", 8);
  vtkNew<vtkUnstructuredGridWriter> writer;
  writer->SetFileTypeToBinary();
  writer->WriteToOutputStringOn();
  writer->SetInputData(voxel);
  writer->Write();
  const std::string bytes = writer->GetOutputStdString();
  EXPECT_EQ(GetError(this->WriteText("whole.vtk", bytes)), "accepted");
  ::testing::internal::CaptureStderr();
  const std::string path = this->WriteText("cut.vtk", bytes.substr(0, bytes.rfind("double") + 50));
  EXPECT_EQ(GetError(path),
    "cannot read '" + path + "': the file is damaged or not of the kind that its ending says");
  ::testing::internal::GetCapturedStderr();
}

TEST_F(DatasetReader, LeavesOutGhostCells)
{
  auto grid = MakeVoxel(0.0);
  vtkIdType ids[8];
  for (int i = 0; i < 8; ++i)
  {
    ids[i] = grid->GetPoints()->InsertNextPoint(1 + (i & 1), i >> 1 & 1, i >> 2 & 1);
  }
  grid->InsertNextCell(VTK_VOXEL, 8, ids);
  grid->AllocateCellGhostArray();
  grid->GetCellGhostArray()->SetValue(1, vtkDataSetAttributes::DUPLICATECELL);
  const std::string path = this->Write<vtkXMLUnstructuredGridWriter>("ghosts.vtu", grid);
  EXPECT_EQ(tetmarch::ReadUnstructuredGrid(path, std::nullopt)->GetNumberOfCells(), 1);
}
