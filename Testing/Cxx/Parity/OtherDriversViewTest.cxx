// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The view modes by other drivers of Mesa: the numbers, or colours, of the CPU reference.
#include "BoundaryParity.h"
#include "LitScene.h"
#include "OtherDrivers.h"
#include "ViewScene.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkTable.h"

#include <cstdlib>
#include <set>

namespace
{
using namespace tetmarch::testing;
using Mapper = vtkTetMarchVolumeMapper;
using Statistics = vtkTetMarchFrameStatistics;

// What the CPU's march of the pixel's ray, in float, counts.
double numberOf(Scene& scene, int quantity, int x, int y)
{
  vtkNew<vtkTable> ray;
  EXPECT_TRUE(scene.Mapper->TraceRay(scene.Volume, x, y, Mapper::TRACE_FLOAT, ray));
  const auto fact = [&](const char* name)
  { return ray->GetFieldData()->GetArray(name)->GetComponent(0, 0); };
  return quantity == Statistics::CELLS     ? static_cast<double>(ray->GetNumberOfRows())
         : quantity == Statistics::LOOKUPS ? fact("Lookups")
                                           : fact("ErrorBound");
}

TEST_F(OtherDrivers, NumbersAsColors)
{
  ViewScene scene(jitteredLattice(5, 0.15, 1, noiseField(3, 4)), Side, Side);
  for (const auto& [mode, quantity] : Views)
  {
    const Image frame = scene.view(mode);
    SCOPED_TRACE(scene.Mapper->GetViewModeAsString());
    expectColorsOfStatistics(scene, frame, quantity);
    const std::vector<int> entries = entriesOf(frame, scene.table());
    const Mask inside = regionsOf(scene).Inside;
    std::set<int> seen;
    int pixels = 0, off = 0;
    for (int i = 0; i < Side * Side; ++i)
    {
      if (inside[i])
      {
        const auto expected =
          static_cast<int>(scene.table()->GetIndex(numberOf(scene, quantity, i % Side, i / Side)));
        ++pixels;
        off += std::abs(entries[i] - expected) > 1;
        seen.insert(expected);
      }
    }
    std::cout << "[ MEASURED ] " << scene.Mapper->GetViewModeAsString() << ": " << off << " of "
              << pixels << " pixels have another number, of " << seen.size() << " colours\n";
    EXPECT_GT(pixels, 100);
    EXPECT_GT(seen.size(), 10u);
    EXPECT_LE(off, pixels / 50);
  }
}

// The light alone is the picture of a white volume. How far segments are split depends on colours,
// but not at this level.
TEST_F(OtherDrivers, Illumination)
{
  LitScene scene(jitteredLattice(4, 0.15, 1, sineField()), Side, Side);
  scene.Mapper->SetAccuracyLevelToFast();
  scene.Mapper->SetViewModeToIllumination();
  const Image illumination = scene.render();
  EXPECT_LE(compare(illumination, scene.renderWhite()).Max, 1e-4);
  scene.Mapper->SetAccuracyLevelToDefault();
  expectReference(scene, "white volume");
}

// Of a linear field they have one direction, which is one colour.
TEST_F(OtherDrivers, Gradients)
{
  const Vec3 direction{ { 0.48, -0.6, 0.64 } };
  LitScene scene(
    jitteredLattice(4, 0.15, 1, linearFieldAlong(direction[0], direction[1], direction[2])), Side,
    Side);
  scene.Mapper->SetViewModeToGradients();
  const Image drawn = scene.render();
  Image expected = referenceOf(scene).Picture;
  for (std::size_t i = 0; i < expected.Rgba.size(); i += 4)
  {
    for (int k = 0; k < 3; ++k)
    {
      expected.Rgba[i + k] = static_cast<float>(0.5 + 0.5 * direction[k]) * expected.Rgba[i + 3];
    }
  }
  const Difference inside = compare(drawn, expected, regionsOf(scene).Inside);
  std::cout << "[ MEASURED ] gradients: " << inside.text() << '\n';
  EXPECT_GT(inside.Pixels, 100u);
  EXPECT_EQ(inside.Over, 0u) << inside.text();
}

TEST_F(OtherDrivers, Boundary)
{
  for (const Grid& grid : { boundaryLattice(), latticeWithTunnel(6), twoComponents(6) })
  {
    BoundaryScene scene(grid, Side, Side);
    EXPECT_GT(expectAsReference(scene), 60);
  }
}
} // namespace
