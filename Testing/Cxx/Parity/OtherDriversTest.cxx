// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What other drivers of Mesa draw, pixel by pixel against the CPU reference, in tiny windows:
// softpipe interprets shaders and takes few texels in a buffer, zink hands them to Vulkan.
// GALLIUM_DRIVER names the one that is meant.
#include "OtherDrivers.h"
#include "BlendScene.h"
#include "ComponentScene.h"
#include "ErrorWatch.h"
#include "Lights.h"
#include "StructuredScene.h"

namespace
{
using namespace tetmarch::testing;

TEST_F(OtherDrivers, MeshesOfAllKinds)
{
  const struct
  {
    const char* Name;
    Grid Mesh;
  } meshes[] = { { "lattice", jitteredLattice(6, 0.15, 1, sineField()) },
    { "shuffled", shuffled(jitteredLattice(5, 0.15, 1, noiseField())) },
    { "mixed cells", mixedCells(4, 1, 0.1, sineField()) },
    { "quadratic", quadraticTetLattice(2, 0.1, sineField()) },
    { "tunnel", latticeWithTunnel(6, 0.15, 1, sineField()) },
    { "shells", nestedShells(8, 4, 0.15, 1, sineField()) } };
  for (const auto& mesh : meshes)
  {
    Scene scene(mesh.Mesh, Side, Side);
    expectReference(scene, mesh.Name);
  }
}

TEST_F(OtherDrivers, ScalarsOfCellsAndTransparentRanges)
{
  Scene scene(jitteredLattice(6, 0.15, 1, sineField()), Side, Side);
  scene.drawCellScalars();
  expectReference(scene, "cells");
  setTwoPeaks(scene.property());
  expectReference(scene, "transparent ranges");
}

// A layer of the unit cube's lattice, a cube thick; seen from above. Most is at the boundary.
Grid slab(int cubes)
{
  return maskedLattice(
    cubes, 0.15, 1, sineField(), [cubes](int, int, int k) { return k == cubes / 2; });
}

// In softpipe's buffers 32,768 texels are read right, so that these tetrahedra lie in two. Entries
// are listed within the limit, too.
TEST_F(OtherDrivers, ManyTetrahedra)
{
  Scene scene(slab(77), Side, Side);
  lookDownZ(scene.camera(), 0.45);
  scene.property()->SetScalarOpacityUnitDistance(0.01);
  scene.Renderer->ResetCameraClippingRange();
  const ErrorWatch watch(scene.Mapper);
  expectReference(scene, "slab");
  EXPECT_EQ(watch.Errors, std::vector<std::string>());
  EXPECT_EQ(scene.Mapper->GetNumberOfRays(), Side * Side);
  EXPECT_LT(scene.Mapper->GetNumberOfCrossedCells(), 10 * Side * Side);
}

TEST_F(OtherDrivers, TooManyBoundaryFaces)
{
  if (!isSoftpipe())
  {
    GTEST_SKIP() << "there is room for them";
  }
  Scene scene(slab(100), Side, Side);
  const ErrorWatch watch(scene.Mapper);
  scene.Window->Render();
  scene.Window->Render();
  ASSERT_EQ(watch.Errors.size(), 1u);
  EXPECT_NE(watch.Errors[0].find("needs 40800 texels for its boundary faces, the GL takes 32768"),
    std::string::npos)
    << watch.Errors[0];
}

TEST_F(OtherDrivers, BlendModes)
{
  BlendScene scene(jitteredLattice(5, 0.15, 1, noiseField(3, 4)), Side, Side);
  for (const int mode : BlendModes)
  {
    scene.Mapper->SetBlendMode(mode);
    expectReference(scene, scene.Mapper->GetBlendModeAsString(), 50);
  }
}

TEST_F(OtherDrivers, Components)
{
  for (const Mix& mix : Mixes)
  {
    ComponentScene scene(jitteredLattice(4, 0.15, 1, sineField()), mix, Side, Side);
    expectReference(scene, mix.Name, 50);
  }
}

TEST_F(OtherDrivers, Light)
{
  LitScene scene(jitteredLattice(5, 0.15, 1, sineField()), Side, Side);
  expectReference(scene, "a light");
  scene.addGradientOpacity();
  expectReference(scene, "gradient opacity");
  addLightsThatCastShadows(scene.Renderer);
  scene.Mapper->AmbientOcclusionOn();
  expectReference(scene, "shadows and ambient light");
}

// A pixel writes to an array at a place of its own in the search for entries. Softpipe doesn't, and
// would search for ever.
TEST_F(OtherDrivers, SearchesForEntries)
{
  LitScene scene(latticeWithTunnel(5, 0.15, 1, sineField()), Side, Side);
  const auto expectSearched = [&](const std::string& what)
  {
    if (!isSoftpipe())
    {
      expectReference(scene, what);
      return;
    }
    const ErrorWatch watch(scene.Mapper);
    scene.Window->Render();
    ASSERT_EQ(watch.Errors.size(), 1u) << what;
    EXPECT_NE(watch.Errors[0].find("softpipe can't search"), std::string::npos) << watch.Errors[0];
  };
  scene.Mapper->AmbientOcclusionOn();
  expectSearched("ambient light");
  scene.property()->ShadeOff();
  lookFromInside(scene.camera());
  expectReference(scene, "from inside");
  scene.camera()->ParallelProjectionOn();
  scene.camera()->SetParallelScale(0.6);
  expectSearched("from inside, parallel");
}

TEST_F(OtherDrivers, Images)
{
  for (const LatticeValues values : { LatticeValues::PointsLinear, LatticeValues::CellsNearest })
  {
    StructuredScene scene(imageOf(sineField(), unitCube(6)), Side, Side);
    scene.draw(values);
    report(nameOf(values), expectParity(scene));
  }
}
} // namespace
