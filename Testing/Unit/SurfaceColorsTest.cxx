// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Colours of surfaces: at points, at repeated points of cells, and in a table.
#include "SurfacesOfRenderer.h"

#include "vtkCellData.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"

#include <limits>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

using Numbers = std::vector<std::uint32_t>;
using Bytes = std::vector<std::uint8_t>;
using SurfaceColors = SurfacesOfRenderer;

// Red for scalars below 0.5, else blue.
vtkSmartPointer<vtkLookupTable> twoColors()
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(2);
  table->SetTableValue(0, 1.0, 0.0, 0.0);
  table->SetTableValue(1, 0.0, 0.0, 1.0);
  return table;
}
const Bytes Red = { 255, 0, 0, 255 };
const Bytes Blue = { 0, 0, 255, 255 };

Bytes colorAt(const Surface& surface, std::size_t point)
{
  const auto at = surface.Colors.begin() + 4 * static_cast<std::ptrdiff_t>(point);
  return { at, at + 4 };
}

TEST_F(SurfaceColors, HaveColorsOfPointsByTheMappersTable)
{
  const auto data = patch();
  data->GetPointData()->SetScalars(arrayOf("s", { 0, 1, 0, 1, 0, 0, 0, 1 }));
  vtkMapper* mapper = this->add(data)->GetMapper();
  mapper->SetLookupTable(twoColors());
  const Surface surface = this->only();
  ASSERT_EQ(surface.Colors.size(), 32u);
  EXPECT_TRUE(surface.TableCoordinates.empty());
  // Points are in the order of their first triangle: 0 1 3 2, 4 5 6 7.
  const Bytes expected[] = { Red, Blue, Blue, Red, Red, Red, Red, Blue };
  for (std::size_t i = 0; i < 8; ++i)
  {
    EXPECT_EQ(colorAt(surface, i), expected[i]) << i;
  }
  mapper->ScalarVisibilityOff();
  EXPECT_TRUE(this->only().Colors.empty());
}

// The colour of the table nearest to a point's coordinates.
Bytes tableColorAt(const Surface& surface, std::size_t point)
{
  const auto height = surface.Table.size() / 4 / surface.TableWidth;
  const auto place = [&](int k, std::size_t size)
  {
    const float x = surface.TableCoordinates[2 * point + k] * size;
    return static_cast<std::size_t>(std::min(std::max(x, 0.0f), size - 1.0f));
  };
  const std::size_t texel = place(1, height) * surface.TableWidth + place(0, surface.TableWidth);
  const auto at = surface.Table.begin() + static_cast<std::ptrdiff_t>(4 * texel);
  return { at, at + 4 };
}

TEST_F(SurfaceColors, HaveCoordinatesInATableIfScalarsAreInterpolated)
{
  const auto data = patch();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  data->GetPointData()->SetScalars(arrayOf("s", { 0, 0.4f, 0.6f, 1, 0, 0, 0, nan }));
  vtkMapper* mapper = this->add(data)->GetMapper();
  const auto table = twoColors();
  table->SetNanColor(0.0, 1.0, 0.0, 1.0);
  mapper->SetLookupTable(table);
  mapper->InterpolateScalarsBeforeMappingOn();
  const Surface surface = this->only();
  EXPECT_TRUE(surface.Colors.empty());
  ASSERT_EQ(surface.TableCoordinates.size(), 16u);
  const Bytes expected[] = { Red, Red, Blue, Blue, Red, Red, Red, { 0, 255, 0, 255 } };
  for (std::size_t i = 0; i < 8; ++i)
  {
    EXPECT_EQ(tableColorAt(surface, i), expected[i]) << i;
  }
}

// The first cell is a vertex, which the page does not show.
TEST_F(SurfaceColors, HaveColorsOfCellsAtRepeatedPoints)
{
  const auto data = plate({ { 0.0, 0.0, 0.0 } }, { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } });
  vtkNew<vtkCellArray> vertices, polygons;
  vertices->InsertNextCell({ 0 });
  polygons->InsertNextCell({ 0, 1, 2 });
  polygons->InsertNextCell({ 2, 1, 3 });
  data->SetVerts(vertices);
  data->SetPolys(polygons);
  data->GetCellData()->SetScalars(arrayOf("s", { 0, 0, 1 }));
  vtkMapper* mapper = this->add(data)->GetMapper();
  mapper->SetLookupTable(twoColors());
  const Surface surface = this->only();
  EXPECT_EQ(surface.Triangles, (Numbers{ 0, 1, 2, 3, 4, 5 }));
  for (std::size_t i = 0; i < 6; ++i)
  {
    EXPECT_EQ(colorAt(surface, i), i < 3 ? Red : Blue) << i;
  }
  EXPECT_EQ(placeOf(surface, 3), placeOf(surface, 2));
}
} // namespace
