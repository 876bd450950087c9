// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Files whose arrays contradict each other are refused right after they were read, with all that is
// wrong, before blocks are merged or anything is chosen.
#include "GridMerging.h"
#include "ReaderCase.h"

#include "UnsoundData.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLImageDataWriter.h"
#include "vtkXMLRectilinearGridWriter.h"
#include "vtkXMLStructuredGridWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using tetmarch::testing::UnsoundData;

class UnsoundFiles : public ReaderCase
{
protected:
  std::string WriteAny(vtkDataSet* data) const
  {
    if (vtkUnstructuredGrid::SafeDownCast(data))
    {
      return this->Write<vtkXMLUnstructuredGridWriter>("a.vtu", data);
    }
    if (vtkStructuredGrid::SafeDownCast(data))
    {
      return this->Write<vtkXMLStructuredGridWriter>("a.vts", data);
    }
    return vtkImageData::SafeDownCast(data)
             ? this->Write<vtkXMLImageDataWriter>("a.vti", data)
             : this->Write<vtkXMLRectilinearGridWriter>("a.vtr", data);
  }
};

/// VTK's writers trust the numbers of values.
bool CanBeWritten(const UnsoundData& unsound)
{
  const auto begins = [&unsound](const char* word) { return unsound.Name.find(word) == 0; };
  return !begins("fewer") && !begins("five ghost") && !begins("a curvilinear grid of 40");
}
} // namespace

TEST_F(UnsoundFiles, AreRefusedWithWhatIsWrong)
{
  int said = 0;
  for (const UnsoundData& unsound : tetmarch::testing::unsoundGeometries())
  {
    if (!CanBeWritten(unsound))
    {
      continue;
    }
    SCOPED_TRACE(unsound.Name);
    const std::string path = this->WriteAny(unsound.Data);
    ::testing::internal::CaptureStderr();
    const std::string error = GetError(path);
    ::testing::internal::GetCapturedStderr(); // VTK's reader may have found it, too
    const bool all = std::all_of(unsound.Words.begin(), unsound.Words.end(),
      [&error](const std::string& word) { return error.find(word) != std::string::npos; });
    EXPECT_TRUE(all || error.find("cannot read '") == 0) << error;
    said += all ? 1 : 0;
    if (all)
    {
      EXPECT_EQ(error.find("'" + path + "' can't be drawn: "), 0u) << error;
      ASSERT_EQ(tetmarch::ListFaults(path, std::nullopt).size(), 1u);
      EXPECT_NE(error.find(tetmarch::ListFaults(path, std::nullopt)[0]), std::string::npos);
    }
  }
  EXPECT_GE(said, 15);
}

TEST_F(UnsoundFiles, SoundOnesHaveNoFault)
{
  for (const auto& data : tetmarch::testing::soundData())
  {
    const std::string path = this->WriteAny(data);
    EXPECT_EQ(GetError(path), "accepted");
    EXPECT_TRUE(tetmarch::ListFaults(path, std::nullopt).empty());
  }
}

// Of fields a legacy file says itself how many values there are.
TEST_F(UnsoundFiles, ArraysThatDoNotFitAreLeftOut)
{
  const std::string path = this->WriteText("a.vtk",
    "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n"
    "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\nPOINT_DATA 4\n"
    "FIELD FieldData 3\nshort 1 3 double\n1 2 3\nfits 1 4 double\n1 2 3 4\nlong 1 5 int\n1 2 3 4 "
    "5\n");
  ::testing::internal::CaptureStderr();
  const tetmarch::VolumeData volume = tetmarch::ReadVolume(path, std::nullopt);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(),
    "tetmarch-render: warning: point array 'long' is left out: it has 5 tuples, but the grid has 4 "
    "points\ntetmarch-render: warning: point array 'short' is left out: it has 3 tuples, but the "
    "grid has 4 points\n");
  ASSERT_EQ(volume.Blocks[0]->GetPointData()->GetNumberOfArrays(), 1);
  EXPECT_STREQ(volume.Blocks[0]->GetPointData()->GetArrayName(0), "fits");
  const std::vector<std::string> faults = tetmarch::ListFaults(path, std::nullopt);
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0], "The scalar array \"short\" has 3 tuples, but the grid has 4 points.");
}

// Points that no cell has may be anything; merging would recurse among infinite ones.
TEST_F(UnsoundFiles, StrayPointsAreMerged)
{
  const auto blocks = tetmarch::testing::soundData();
  auto* grid = vtkUnstructuredGrid::SafeDownCast(blocks[0]);
  ASSERT_NE(grid, nullptr);
  grid->GetPointData()->Initialize();
  const vtkIdType before = grid->GetNumberOfPoints();
  for (int i = 0; i < 100; ++i)
  {
    const double far = std::numeric_limits<double>::infinity();
    grid->GetPoints()->InsertNextPoint(i % 2 == 0 ? far : -far, i, std::nan(""));
  }
  const auto merged = tetmarch::MergeBlocks({ grid, grid });
  EXPECT_EQ(merged->GetNumberOfPoints(), before);
  EXPECT_EQ(merged->GetNumberOfCells(), 2 * grid->GetNumberOfCells());
  EXPECT_EQ(grid->GetNumberOfPoints(), before + 100) << "the block itself stays as it was";
}
