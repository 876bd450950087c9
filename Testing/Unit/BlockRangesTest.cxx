// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The least and greatest scalar of blocks against all values that their cells read, one by one.
#include "Structured/EmptySpace.h"

#include "StoredScalars.h"
#include "StructuredGrids.h"

#include "vtkType.h"

#include <algorithm>
#include <cmath>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// The numbers of the values that a cell reads, by the definition in Lattice.h.
std::vector<std::size_t> valuesOf(const Lattice& lattice, const std::array<int, 3>& cell)
{
  std::vector<std::size_t> values;
  for (int c = 0; c < (lattice.Constant ? 1 : 8); ++c)
  {
    std::array<std::size_t, 3> at;
    for (int a = 0; a < 3; ++a)
    {
      const LatticeAxis& axis = lattice.Axes[a];
      at[a] = static_cast<std::size_t>(
        std::clamp(cell[a] + axis.FirstValue + (c >> a & 1), 0, axis.Values - 1));
    }
    values.push_back((at[2] * lattice.Axes[1].Values + at[1]) * lattice.Axes[0].Values + at[0]);
  }
  return values;
}

struct ExpectedRange
{
  float Least = 1;
  float Greatest = 0;
  bool Undrawn = false;
};

std::vector<ExpectedRange> expectedRanges(
  const Lattice& lattice, const StoredValues& values, const std::array<int, 3>& blocks)
{
  std::vector<ExpectedRange> expected(std::size_t(blocks[0]) * blocks[1] * blocks[2]);
  const auto& axes = lattice.Axes;
  for (int k = 0; k < axes[2].Cells; ++k)
  {
    for (int j = 0; j < axes[1].Cells; ++j)
    {
      for (int i = 0; i < axes[0].Cells; ++i)
      {
        ExpectedRange& block =
          expected[(std::size_t(k / 4) * blocks[1] + j / 4) * blocks[0] + i / 4];
        for (const std::size_t v : valuesOf(lattice, { { i, j, k } }))
        {
          const float scalar = values.scalar(v);
          if (scalar == UndrawnScalar)
          {
            block.Undrawn = true;
          }
          else
          {
            block.Least = std::min(block.Least, scalar);
            block.Greatest = std::max(block.Greatest, scalar);
          }
        }
      }
    }
  }
  return expected;
}

// rounding: of the scale and the offset of integers.
void expectRanges(const Lattice& lattice, const StoredValues& values, float rounding)
{
  const BlockRanges ranges = findBlockRanges(lattice, values);
  for (int a = 0; a < 3; ++a)
  {
    EXPECT_EQ(ranges.Blocks[a], (lattice.Axes[a].Cells + 3) / 4);
  }
  const auto expected = expectedRanges(lattice, values, ranges.Blocks);
  ASSERT_EQ(ranges.Scalars.size(), expected.size());
  const bool anyUndrawn =
    std::any_of(expected.begin(), expected.end(), [](const ExpectedRange& r) { return r.Undrawn; });
  ASSERT_EQ(ranges.Undrawn.size(), anyUndrawn ? expected.size() : 0);
  for (std::size_t b = 0; b < expected.size(); ++b)
  {
    EXPECT_NEAR(ranges.Scalars[b][0], expected[b].Least, rounding) << b;
    EXPECT_NEAR(ranges.Scalars[b][1], expected[b].Greatest, rounding) << b;
    EXPECT_EQ(anyUndrawn && ranges.Undrawn[b] != 0, expected[b].Undrawn) << b;
  }
}

TEST(BlockRanges, CoverWhatTheirCellsRead)
{
  std::mt19937 random(2);
  for (const int type :
    { VTK_UNSIGNED_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_SHORT, VTK_SHORT, VTK_INT, VTK_FLOAT })
  {
    for (int n = 0; n < 12; ++n)
    {
      std::array<int, 3> size;
      for (int& points : size)
      {
        points = 2 + static_cast<int>(random() % 13);
      }
      const Image image = imageOf(size[0], size[1], size[2]);
      for (const LatticeCase& lies : latticeCases())
      {
        SCOPED_TRACE(nameOf(lies) + ", type " + std::to_string(type));
        const Lattice lattice = latticeOf(image, lies);
        const auto count = static_cast<vtkIdType>(lattice.numberOfValues());
        const double low = type == VTK_UNSIGNED_CHAR || type == VTK_UNSIGNED_SHORT ? 10 : -100;
        const StoredValues values = storedOf(randomArray(type, count, 1, low, low + 120, random));
        const bool isFloat = values.Type == ValueType::Float32;
        expectRanges(lattice, values, isFloat ? 0.0f : 1e-6f);
      }
    }
  }
}

TEST(BlockRanges, LeaveOutWhatIsNotFinite)
{
  std::mt19937 random(3);
  for (int n = 0; n < 12; ++n)
  {
    const Image image = imageOf(17, 10, 6);
    for (const LatticeCase& lies : latticeCases())
    {
      SCOPED_TRACE(nameOf(lies));
      const Lattice lattice = latticeOf(image, lies);
      const auto array = randomArray(
        VTK_FLOAT, static_cast<vtkIdType>(lattice.numberOfValues()), 1, 0, 1000, random);
      // A corner of the volume without any, and some anywhere.
      for (int k = 0; k < 5; ++k)
      {
        for (int j = 0; j < 5; ++j)
        {
          for (int i = 0; i < 5; ++i)
          {
            array->SetComponent(
              (k * lattice.Axes[1].Values + j) * lattice.Axes[0].Values + i, 0, std::nan(""));
          }
        }
      }
      for (int i = 0; i < n; ++i)
      {
        array->SetComponent(
          static_cast<vtkIdType>(random() % array->GetNumberOfTuples()), 0, std::nan(""));
      }
      const StoredValues values = storedOf(array);
      expectRanges(lattice, values, 0.0f);
      const BlockRanges ranges = findBlockRanges(lattice, values);
      EXPECT_EQ(ranges.Scalars[0], (std::array<float, 2>{ { 1.0f, 0.0f } }));
      EXPECT_EQ(ranges.Undrawn[0], 1);
    }
  }
}

// Of borrowed integers, too, whose Scale u + Offset may be a rounding off.
TEST(BlockRanges, EndsOfTheRangeAreExact)
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT })
  {
    for (double low = 0; low < 100; ++low)
    {
      const std::vector<double> values{ low, low + 99, low, low + 99, low, low, low, low };
      const BlockRanges ranges =
        findBlockRanges(latticeOf(imageOf(2, 2, 2), { false, Interpolation::Linear }),
          storedOf(arrayOf(type, values)));
      ASSERT_EQ(ranges.Scalars.size(), 1u);
      EXPECT_EQ(ranges.Scalars[0], (std::array<float, 2>{ { 0.0f, 1.0f } })) << low;
      EXPECT_TRUE(ranges.Undrawn.empty());
    }
  }
}

TEST(BlockRanges, OfExtraScalarsByTheirUnit)
{
  const auto array = arrayOf(VTK_UNSIGNED_CHAR, { 10, 51, 20, 102, 30, 40, 50, 60 }, 2, 1);
  const auto all =
    storeValues({ array, false, ComponentMix::DirectColor, { false, 0 }, { 1 }, 255 });
  const BlockRanges ranges =
    findBlockRanges(latticeOf(imageOf(2, 2, 2), { false, Interpolation::Linear }), all[1]);
  EXPECT_EQ(ranges.Scalars[0], (std::array<float, 2>{ { 10.0f / 255, 0.4f } }));
}
} // namespace
