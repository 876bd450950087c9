// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The stages that make a structured volume run when their own input changed, and versions tell what
// has to be uploaded again.
#include "Volume/StructuredVolume.h"

#include "StructuredGrids.h"

#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkMatrix4x4.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

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

  static std::string updateOf(
    StructuredVolume& volume, const VolumeInput& input, const DrawnScalars& drawn)
  {
    const std::string wrong = volume.updateGeometry(input, {}, {});
    return wrong.empty() ? volume.updateScalars(input, drawn) : wrong;
  }
  std::string update(const DrawnScalars& drawn, Interpolation interpolation = Linear)
  {
    return updateOf(this->Volume, { this->Data, {}, interpolation }, drawn);
  }

  // So often in all after one more update.
  void expectRuns(int lattice, int values, int ranges, const DrawnScalars& drawn,
    Interpolation interpolation = Linear)
  {
    EXPECT_EQ(this->update(drawn, interpolation), "");
    EXPECT_EQ(this->Volume.latticeRecord().Runs, lattice);
    EXPECT_EQ(this->Volume.valuesRecord().Runs, values);
    EXPECT_EQ(this->Volume.rangesRecord().Runs, ranges);
    EXPECT_EQ(this->Volume.geometryVersion().size(), 1u);
    EXPECT_EQ(this->Volume.scalarsVersion().front(), this->Volume.geometryVersion().front());
  }

  Image Data = imageWith(VTK_UNSIGNED_CHAR, 1);
  StructuredVolume Volume;
};

TEST_F(StructuredVolumes, AreMadeOnce)
{
  EXPECT_TRUE(this->Volume.isEmpty());
  this->expectRuns(1, 1, 1, this->drawn());
  const Fingerprint values = this->Volume.scalarsVersion();
  this->expectRuns(1, 1, 1, this->drawn());
  EXPECT_EQ(this->Volume.scalarsVersion(), values);
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
  const Fingerprint lattice = this->Volume.geometryVersion();
  const Fingerprint values = this->Volume.scalarsVersion();
  this->Data = imageWith(VTK_UNSIGNED_CHAR, 2);
  this->expectRuns(1, 2, 2, this->drawn());
  EXPECT_EQ(this->Volume.geometryVersion(), lattice);
  EXPECT_NE(this->Volume.scalarsVersion(), values);
  this->Data->GetPointData()->GetScalars()->Modified();
  this->expectRuns(1, 3, 3, this->drawn());
  EXPECT_EQ(this->Volume.geometryVersion(), lattice);
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
    EXPECT_EQ(
      updateOf(this->Volume, { grid, {}, Linear }, { grid->GetPointData()->GetScalars() }), "");
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
  const Fingerprint values = this->Volume.scalarsVersion();
  const double radius = this->Volume.frame().Radius;
  this->Data->SetSpacing(2, 4, 6);
  this->expectRuns(2, 1, 2, this->drawn());
  EXPECT_DOUBLE_EQ(this->Volume.frame().Radius, 2 * radius);
  EXPECT_NE(this->Volume.scalarsVersion(), values);
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

TEST_F(StructuredVolumes, ExtraScalarsComeWithTheirRanges)
{
  std::mt19937 random(9);
  const auto array = randomArray(VTK_UNSIGNED_CHAR, 270, 4, 10, 90, random);
  this->Data->GetPointData()->SetScalars(array);
  DrawnScalars drawn{ array, false, ComponentMix::DirectColor, { false, 3 }, { 0, 1, 2 }, 255 };
  this->expectRuns(1, 1, 1, drawn);
  ASSERT_EQ(this->Volume.values().size(), 4u);
  ASSERT_EQ(this->Volume.extraRanges().size(), 3u);
  EXPECT_EQ(this->Volume.extraRanges()[2].High, 255.0);
  drawn.ExtraUnit = 0;
  this->expectRuns(1, 2, 2, drawn);
  EXPECT_LT(this->Volume.extraRanges()[2].High, 91.0);
}

TEST_F(StructuredVolumes, WhatIsWrongIsSaidAndMended)
{
  this->expectRuns(1, 1, 1, this->drawn());
  const DrawnScalars ofPoints = this->drawn();
  this->Data->SetSpacing(1, 0, 1);
  EXPECT_NE(this->update(ofPoints).find("spacing"), std::string::npos);
  EXPECT_TRUE(this->Volume.isEmpty());
  EXPECT_TRUE(this->Volume.values().empty());
  this->Data->SetSpacing(1, 2, 3);
  EXPECT_EQ(this->update(ofPoints), "");
  EXPECT_FALSE(this->Volume.isEmpty());
  EXPECT_EQ(this->Volume.values().size(), 1u);
  const auto other = vtkSmartPointer<vtkUnstructuredGrid>::New();
  EXPECT_NE(this->Volume.updateGeometry({ other }, {}, {}), "");
  EXPECT_TRUE(this->Volume.isEmpty());
}

TEST_F(StructuredVolumes, WithoutPointsThereIsNothing)
{
  this->expectRuns(1, 1, 1, this->drawn());
  const Image empty = Image::New();
  EXPECT_EQ(updateOf(this->Volume, { empty }, {}), "");
  EXPECT_TRUE(this->Volume.isEmpty());
  EXPECT_TRUE(this->Volume.values().empty());
}

// Points here and there in each cell of the lattice, and the cell of the data whose planes they lie
// between.
void expectCellsOfPoints(const StructuredVolume& volume, vtkDataSet* data, std::mt19937& random)
{
  const Lattice& lattice = volume.lattice();
  std::array<double, 16> toLattice{}, toNormalized{};
  std::copy(lattice.FromNormalized.begin(), lattice.FromNormalized.end(), toLattice.begin());
  toLattice[15] = 1;
  vtkMatrix4x4::Invert(toLattice.data(), toNormalized.data());
  for (std::uint32_t cell = 0; cell < lattice.numberOfCells(); ++cell)
  {
    for (int n = 0; n < 8; ++n)
    {
      std::array<double, 4> place{ { 0, 0, 0, 1 } };
      std::uint32_t rest = cell;
      for (int a = 0; a < 3; ++a)
      {
        const LatticeAxis& axis = lattice.Axes[a];
        const int i = static_cast<int>(rest % axis.Cells);
        rest /= axis.Cells;
        const double share = 0.01 + 0.98 * (double(random()) / 4294967296.0);
        place[a] = axis.plane(i) + share * (axis.plane(i + 1) - axis.plane(i));
      }
      std::array<double, 4> point;
      vtkMatrix4x4::MultiplyPoint(toNormalized.data(), place.data(), point.data());
      const Vector3 normalized{ { point[0], point[1], point[2] } };
      const Vector3 there = lattice.Frame.toData(normalized);
      double bounds[6];
      data->GetCellBounds(volume.cellOf(cell, normalized), bounds);
      for (int a = 0; a < 3; ++a)
      {
        ASSERT_GT(there[a], bounds[2 * a] - 1e-6) << cell << ", axis " << a;
        ASSERT_LT(there[a], bounds[2 * a + 1] + 1e-6) << cell << ", axis " << a;
      }
    }
  }
}

TEST_F(StructuredVolumes, PointsOfTheLatticeKnowTheirCellOfTheData)
{
  const Rectilinear uneven =
    rectilinearOf({ { { 0, 1, 3, 3.5, 7 }, { 5, 4, 2, -1 }, { -1, 2, 2.25, 9 } } });
  std::mt19937 random(7);
  uneven->GetPointData()->SetScalars(randomArray(VTK_FLOAT, 80, 1, 0, 200, random));
  uneven->GetCellData()->SetScalars(randomArray(VTK_FLOAT, 36, 1, 0, 200, random));
  this->Data->SetOrigin(-7, 3, 2);
  for (vtkDataSet* data : std::initializer_list<vtkDataSet*>{ this->Data, uneven })
  {
    for (const LatticeCase& lies : latticeCases())
    {
      SCOPED_TRACE(nameOf(lies));
      vtkDataArray* array =
        lies.OfCells ? data->GetCellData()->GetScalars() : data->GetPointData()->GetScalars();
      ASSERT_EQ(updateOf(this->Volume, { data, {}, lies.Between }, { array, lies.OfCells }), "");
      ASSERT_NO_FATAL_FAILURE(expectCellsOfPoints(this->Volume, data, random));
    }
  }
}
} // namespace
