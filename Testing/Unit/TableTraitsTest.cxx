// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The table knows which scalars are transparent and whether there is one colour: that spares work
// and changes no picture.
#include "Reference/PointKernel.h"
#include "Volume/TransparentShare.h"

#include "RandomRays.h"
#include "UnitMeshes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

using Entries = std::vector<std::array<float, 4>>;

Entries entriesOf(const std::vector<float>& extinctions)
{
  Entries entries;
  for (float tau : extinctions)
  {
    entries.push_back({ { 0.5f, 0.25f, 0.125f, tau } });
  }
  return entries;
}

using Ranges = std::array<float, 4>;
Ranges rangesOf(const std::vector<float>& extinctions)
{
  return traitsOf(entriesOf(extinctions)).Transparent;
}

TEST(TableTraits, RangesOfEntries)
{
  const Ranges none = TableTraits::NothingTransparent;
  EXPECT_EQ(rangesOf({ 1, 1, 2, 1 }), none);
  EXPECT_FALSE(traitsOf(entriesOf({ 1, 1, 2, 1 })).hasTransparentRanges());
  EXPECT_EQ(rangesOf({ 0, 0, 0, 1, 1 }), (Ranges{ { 2, none[1], none[2], none[3] } }));
  EXPECT_EQ(rangesOf({ 1, 1, 0, 0 }), (Ranges{ { none[0], 2, none[2], none[3] } }));
  EXPECT_TRUE(traitsOf(entriesOf({ 1, 1, 0, 0 })).hasTransparentRanges());
  // Beside a single entry of 0 all is seen.
  EXPECT_EQ(rangesOf({ 1, 0, 1, 1 }), none);
  EXPECT_EQ(rangesOf({ 1, 0, 0, 1, 0, 0, 0, 1 }), (Ranges{ { none[0], none[1], 4, 6 } }));
  EXPECT_EQ(rangesOf({ 0, 0, 1, 0, 0, 1, 0 }), (Ranges{ { 1, 6, 3, 4 } }));
  EXPECT_EQ(rangesOf({ 0, 0, 0 }), (Ranges{ { 2, 0, none[2], none[3] } }));
}

TEST(TableTraits, ConstantColour)
{
  Entries entries = entriesOf({ 0, 1, 0.5f, 2 });
  EXPECT_TRUE(traitsOf(entries).ConstantColor);
  for (int k = 0; k < 3; ++k)
  {
    Entries other = entries;
    other[2][k] += 0.01f;
    EXPECT_FALSE(traitsOf(other).ConstantColor);
  }
}

// A colour that is never seen is none.
TEST(TableTraits, UnseenColours)
{
  const auto table = [](float unseen)
  {
    return tableOf(
      [unseen](double f)
      {
        const double red = f < 0.5 ? 0.25 : double(unseen);
        return std::array<double, 4>{ { red, 0.5, 0.75, f < 0.4 ? 1.0 : 0.0 } };
      });
  };
  EXPECT_TRUE(table(0.9f).Traits.ConstantColor);
}

// The same kernel with and without these traits.
TEST(TableTraits, PassedCellsChangeNoBit)
{
  TetMesh mesh = builtWithHierarchy(jitteredLattice(10, 0.15, 1, sineField()));
  for (Vertex& v : mesh.Vertices)
  {
    v.Scalar = 0.5f + 0.5f * std::sin(4.0f * v.X + 3.0f * v.Y * v.Z);
  }
  const IntegralTable table = tableOf(
    [](double f)
    {
      const bool seen = (f > 0.2 && f < 0.3) || (f > 0.7 && f < 0.8);
      return std::array<double, 4>{ { f, 1.0 - f, 0.5, seen ? 20.0 : 0.0 } };
    });
  auto knowing = kernelOf<PointKernel<float>, float>(mesh, table, DefaultAccuracy);
  auto unknowing = knowing;
  const Ranges& none = TableTraits::NothingTransparent;
  unknowing.transparentRanges = { none[0], none[1], none[2], none[3] };
  RandomRays rays(3);
  int cells = 0;
  int lookups = 0;
  int lookupsBefore = 0;
  for (int i = 0; i < 3000; ++i)
  {
    const auto ray = rays.next<PointKernel<float>, float>(knowing, mesh);
    const auto found = knowing.castPlainRay(ray, 1.0f, -1e30f, 1e30f);
    const auto expected = unknowing.castPlainRay(ray, 1.0f, -1e30f, 1e30f);
    ASSERT_EQ(found.radiance.color.x, expected.radiance.color.x);
    ASSERT_EQ(found.radiance.color.y, expected.radiance.color.y);
    ASSERT_EQ(found.radiance.color.z, expected.radiance.color.z);
    ASSERT_EQ(found.radiance.transmittance, expected.radiance.transmittance);
    ASSERT_NEAR(found.radiance.error, expected.radiance.error, 1e-25); // an error of 0 is tiny
    ASSERT_EQ(found.cells, expected.cells);
    cells += found.cells;
    lookups += found.lookups;
    lookupsBefore += expected.lookups;
  }
  std::cout << "[ MEASURED ] " << cells << " cells: " << lookups << " lookups instead of "
            << lookupsBefore << '\n';
  EXPECT_LT(lookups, 0.7 * lookupsBefore);
  EXPECT_GT(lookups, 1000);
}

TEST(TransparentShare, OfVerticesAndOfCells)
{
  const IntegralTable table = tableOf(
    [](double f) {
      return std::array<double, 4>{ { 0.5, 0.5, 0.5, f > 0.3 && f < 0.8 ? 1.0 : 0.0 } };
    });
  TetMesh mesh = built(jitteredLattice(4, 0.15, 1, sineField()));
  const std::size_t count = mesh.Vertices.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    mesh.Vertices[i].Scalar = i % 5 == 0 ? 0.1f : (i % 5 == 1 ? 0.9f : 0.5f);
  }
  const ScalarRange range{ 0.0, 1.0 };
  EXPECT_NEAR(transparentShare(mesh, {}, range, table), 0.4, 0.02);
  EXPECT_EQ(transparentShare(mesh, { 0.1f, 0.5f, 0.5f, 0.6f }, range, table), 0.25);
  EXPECT_EQ(transparentShare(mesh, { 0.1f, 0.2f }, range, whiteTable()), 0.0);
}
} // namespace
