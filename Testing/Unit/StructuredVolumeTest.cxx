// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The stages that make a structured volume run when their own input changed, and versions tell what
// has to be uploaded again.
#include "Structured/StructuredVolume.h"

#include "StructuredGrids.h"

#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr Interpolation Linear = Interpolation::Linear;
constexpr Interpolation Nearest = Interpolation::Nearest;

class StructuredVolumes : public ::testing::Test
{
protected:
  static Image imageWith(int type, unsigned seed)
  {
    std::mt19937 random(seed);
    const Image image = imageOf(9, 6, 5);
    image->SetSpacing(1, 2, 3);
    image->GetPointData()->SetScalars(randomArray(type, 270, 1, 0, 200, random));
    image->GetCellData()->SetScalars(randomArray(type, 160, 1, 0, 200, random));
    return image;
  }

  DrawnScalars drawn(bool ofCells = false) const
  {
    return { ofCells ? this->Data->GetCellData()->GetScalars()
                     : this->Data->GetPointData()->GetScalars(),
      ofCells };
  }

  std::string update(const DrawnScalars& drawn, Interpolation interpolation = Linear)
  {
    const std::string wrong = this->Volume.updateGeometry(this->Data);
    return wrong.empty() ? this->Volume.updateScalars(this->Data, drawn, interpolation) : wrong;
  }

  // So often in all after one more update.
  void expectRuns(int lattice, int values, int ranges, const DrawnScalars& drawn,
    Interpolation interpolation = Linear)
  {
    EXPECT_EQ(this->update(drawn, interpolation), "");
    EXPECT_EQ(this->Volume.latticeRecord().Runs, lattice);
    EXPECT_EQ(this->Volume.valuesRecord().Runs, values);
    EXPECT_EQ(this->Volume.rangesRecord().Runs, ranges);
    EXPECT_EQ(this->Volume.latticeVersion().size(), 1u);
    EXPECT_EQ(this->Volume.valuesVersion().front(), this->Volume.latticeVersion().front());
  }

  Image Data = imageWith(VTK_UNSIGNED_CHAR, 1);
  StructuredVolume Volume;
};

TEST_F(StructuredVolumes, AreMadeOnce)
{
  EXPECT_TRUE(this->Volume.isEmpty());
  this->expectRuns(1, 1, 1, this->drawn());
  const Fingerprint values = this->Volume.valuesVersion();
  this->expectRuns(1, 1, 1, this->drawn());
  EXPECT_EQ(this->Volume.valuesVersion(), values);
  EXPECT_FALSE(this->Volume.isEmpty());
  EXPECT_EQ(this->Volume.runs(), 3);
  EXPECT_EQ(this->Volume.lattice().numberOfCells(), 160u);
  EXPECT_EQ(this->Volume.lattice().Frame.Center, this->Volume.frame().Center);
  ASSERT_EQ(this->Volume.values().size(), 1u);
  EXPECT_EQ(
    this->Volume.values()[0].Data, this->Data->GetPointData()->GetScalars()->GetVoidPointer(0));
  EXPECT_EQ(this->Volume.blockRanges().front().Blocks, (std::array<int, 3>{ { 2, 2, 1 } }));
}

// A step of a time series.
TEST_F(StructuredVolumes, OtherDataOfTheSameGridHasNewValuesOnly)
{
  this->expectRuns(1, 1, 1, this->drawn());
  const Fingerprint lattice = this->Volume.latticeVersion();
  const Fingerprint values = this->Volume.valuesVersion();
  this->Data = imageWith(VTK_UNSIGNED_CHAR, 2);
  this->expectRuns(1, 2, 2, this->drawn());
  EXPECT_EQ(this->Volume.latticeVersion(), lattice);
  EXPECT_NE(this->Volume.valuesVersion(), values);
  this->Data->GetPointData()->GetScalars()->Modified();
  this->expectRuns(1, 3, 3, this->drawn());
  EXPECT_EQ(this->Volume.latticeVersion(), lattice);
}

TEST_F(StructuredVolumes, EqualCoordinatesAreTheSameGrid)
{
  const auto makeGrid = [](double last)
  {
    const Rectilinear grid = rectilinearOf({ { { 0, 1, 3 }, { 0, 2, 3 }, { 1, 2, last } } });
    vtkNew<vtkFloatArray> values;
    values->SetNumberOfTuples(27);
    values->FillValue(1);
    grid->GetPointData()->SetScalars(values);
    return grid;
  };
  const auto use = [&](const Rectilinear& grid)
  {
    EXPECT_EQ(this->Volume.updateGeometry(grid), "");
    EXPECT_EQ(this->Volume.updateScalars(grid, { grid->GetPointData()->GetScalars() }, Linear), "");
  };
  use(makeGrid(5));
  use(makeGrid(5));
  EXPECT_EQ(this->Volume.latticeRecord().Runs, 1);
  EXPECT_EQ(this->Volume.valuesRecord().Runs, 2);
  use(makeGrid(6));
  EXPECT_EQ(this->Volume.latticeRecord().Runs, 2);
}

TEST_F(StructuredVolumes, AnotherGeometryKeepsTheValues)
{
  this->expectRuns(1, 1, 1, this->drawn());
  const Fingerprint values = this->Volume.valuesVersion();
  const double radius = this->Volume.frame().Radius;
  this->Data->SetSpacing(2, 4, 6);
  this->expectRuns(2, 1, 2, this->drawn());
  EXPECT_DOUBLE_EQ(this->Volume.frame().Radius, 2 * radius);
  EXPECT_NE(this->Volume.valuesVersion(), values);
  this->Data->SetOrigin(5, 5, 5);
  this->expectRuns(3, 1, 3, this->drawn());
  this->Data->SetDirectionMatrix(0, 1, 0, -1, 0, 0, 0, 0, 1);
  this->expectRuns(4, 1, 4, this->drawn());
  this->Data->SetExtent(1, 9, 0, 5, 0, 4);
  this->expectRuns(5, 1, 5, this->drawn());
}

TEST_F(StructuredVolumes, TheCaseChangesTheLattice)
{
  this->expectRuns(1, 1, 1, this->drawn());
  this->expectRuns(2, 1, 2, this->drawn(), Nearest);
  EXPECT_TRUE(this->Volume.lattice().Constant);
  EXPECT_EQ(this->Volume.lattice().numberOfCells(), 270u);
  this->expectRuns(3, 2, 3, this->drawn(true), Nearest);
  EXPECT_EQ(this->Volume.lattice().numberOfCells(), 160u);
  this->expectRuns(4, 2, 4, this->drawn(true), Linear);
  EXPECT_EQ(this->Volume.lattice().numberOfCells(), 270u);
  EXPECT_EQ(this->Volume.values()[0].Count, 160u);
}

TEST_F(StructuredVolumes, ArraysThatMovedAreReadAgain)
{
  this->expectRuns(1, 1, 1, this->drawn());
  vtkDataArray* array = this->Data->GetPointData()->GetScalars();
  array->Resize(100000); // says nothing, but the values lie elsewhere
  this->expectRuns(1, 2, 2, this->drawn());
  EXPECT_EQ(this->Volume.values()[0].Data, array->GetVoidPointer(0));
}

TEST_F(StructuredVolumes, HiddenCellsHaveTheirOwnVersion)
{
  this->expectRuns(1, 1, 1, this->drawn());
  EXPECT_TRUE(this->Volume.hiddenCells().empty());
  EXPECT_TRUE(this->Volume.hiddenVersion().empty());
  const std::int64_t runs = this->Volume.runs();
  this->Data->AllocateCellGhostArray()->SetValue(7, vtkDataSetAttributes::HIDDENCELL);
  this->expectRuns(1, 1, 1, this->drawn());
  EXPECT_EQ(this->Volume.hiddenCells(), (std::vector<std::uint32_t>{ 1u << 7, 0, 0, 0, 0 }));
  const Fingerprint hidden = this->Volume.hiddenVersion();
  EXPECT_FALSE(hidden.empty());
  EXPECT_EQ(this->Volume.runs(), runs + 1);
  // Other data, the same cells.
  this->Data = imageWith(VTK_UNSIGNED_CHAR, 1);
  this->Data->AllocateCellGhostArray()->SetValue(7, vtkDataSetAttributes::HIDDENCELL);
  this->expectRuns(1, 2, 2, this->drawn());
  EXPECT_EQ(this->Volume.hiddenVersion(), hidden);
  // The array isn't told.
  this->Data->GetCellGhostArray()->SetValue(8, vtkDataSetAttributes::HIDDENCELL);
  this->Data->Modified();
  this->expectRuns(1, 2, 2, this->drawn());
  EXPECT_NE(this->Volume.hiddenVersion(), hidden);
  EXPECT_EQ(this->Volume.hiddenCells()[0], 3u << 7);
  this->Data->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  this->expectRuns(1, 2, 2, this->drawn());
  EXPECT_TRUE(this->Volume.hiddenCells().empty());
}

TEST_F(StructuredVolumes, FurtherScalarsComeWithTheirRanges)
{
  std::mt19937 random(9);
  const auto array = randomArray(VTK_UNSIGNED_CHAR, 270, 4, 10, 90, random);
  this->Data->GetPointData()->SetScalars(array);
  DrawnScalars drawn{ array, false, ComponentMix::DirectColor, { false, 3 }, { 0, 1, 2 }, 255 };
  this->expectRuns(1, 1, 1, drawn);
  ASSERT_EQ(this->Volume.values().size(), 4u);
  ASSERT_EQ(this->Volume.furtherRanges().size(), 3u);
  EXPECT_EQ(this->Volume.furtherRanges()[2].High, 255.0);
  drawn.FurtherUnit = 0;
  this->expectRuns(1, 2, 2, drawn);
  EXPECT_LT(this->Volume.furtherRanges()[2].High, 91.0);
}

TEST_F(StructuredVolumes, WhatIsWrongIsSaidAndMended)
{
  this->expectRuns(1, 1, 1, this->drawn());
  const DrawnScalars ofPoints = this->drawn();
  EXPECT_NE(this->update({ ofPoints.Array, true }).find("270 tuples"), std::string::npos);
  EXPECT_TRUE(this->Volume.values().empty());
  EXPECT_EQ(this->update(ofPoints), "");
  this->Data->SetSpacing(1, 0, 1);
  EXPECT_NE(this->update(ofPoints).find("spacing"), std::string::npos);
  EXPECT_TRUE(this->Volume.isEmpty());
  EXPECT_TRUE(this->Volume.values().empty());
  this->Data->SetSpacing(1, 2, 3);
  EXPECT_EQ(this->update(ofPoints), "");
  EXPECT_FALSE(this->Volume.isEmpty());
  EXPECT_EQ(this->Volume.values().size(), 1u);
  const auto other = vtkSmartPointer<vtkUnstructuredGrid>::New();
  EXPECT_NE(this->Volume.updateGeometry(other), "");
  EXPECT_TRUE(this->Volume.isEmpty());
}

TEST_F(StructuredVolumes, WithoutPointsThereIsNothing)
{
  this->expectRuns(1, 1, 1, this->drawn());
  const Image empty = Image::New();
  EXPECT_EQ(this->Volume.updateGeometry(empty), "");
  EXPECT_TRUE(this->Volume.isEmpty());
  EXPECT_EQ(this->Volume.updateScalars(empty, {}, Linear), "");
  EXPECT_TRUE(this->Volume.values().empty());
}

// The middle of each cell of the lattice lies in the cell of the data, or on its far side.
TEST_F(StructuredVolumes, CellsOfTheLatticeKnowThoseOfTheData)
{
  for (const bool ofCells : { false, true })
  {
    for (const Interpolation interpolation : { Linear, Nearest })
    {
      EXPECT_EQ(this->update(this->drawn(ofCells), interpolation), "");
      const Lattice& lattice = this->Volume.lattice();
      std::uint32_t cell = 0;
      for (int k = 0; k < lattice.Axes[2].Cells; ++k)
      {
        for (int j = 0; j < lattice.Axes[1].Cells; ++j)
        {
          for (int i = 0; i < lattice.Axes[0].Cells; ++i, ++cell)
          {
            // The first cell of the data that it overlaps has a place just inside of its planes.
            const auto numberOf = [&](int axis, int c)
            {
              const LatticeAxis& along = lattice.Axes[axis];
              return static_cast<int>(std::floor(along.plane(c) + 1e-6 + along.HalfLength));
            };
            EXPECT_EQ(this->Volume.dataCellOf(cell),
              (numberOf(2, k) * 5 + numberOf(1, j)) * 8 + numberOf(0, i));
          }
        }
      }
    }
  }
}
} // namespace
