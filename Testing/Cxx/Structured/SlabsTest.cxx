// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Values in several textures make the picture that they make in one, to the last bit. The GL is
// told to take few layers a texture.
#include "Lights.h"
#include "ScenePage.h"
#include "SmallTextures.h"
#include "StructuredComponents.h"

#include "vtkActor.h"
#include "vtkOpenGLRenderUtilities.h" // the GL

#include <algorithm>
#include <gtest/gtest.h>
#include <iostream>
#include <optional>

namespace
{
using namespace tetmarch::testing;

// 16 values of points along an axis, 15 of cells: so many layers a texture make 2, 3, 8 slabs.
constexpr int Cells = 15;
struct Cut
{
  int Layers;
  int Slabs;
};
constexpr Cut Cuts[] = { { 8, 2 }, { 6, 3 }, { 2, 8 } };

TextureLimits mostLayers(int layers)
{
  TextureLimits limits;
  limits.Layers = layers;
  return limits;
}

Image drawnAnew(StructuredScene& scene)
{
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  return scene.render();
}

void expectSlabs(StructuredScene& scene, const std::string& what, int scalars = 1,
  std::initializer_list<Cut> cuts = { Cuts[0], Cuts[1], Cuts[2] })
{
  SCOPED_TRACE(what);
  const Image whole = drawnAnew(scene);
  const Image frame = scene.frame();
  const vtkTypeInt64 bytes = scene.Mapper->GetGPUMemoryBytes();
  EXPECT_GT(compare(whole, Image(whole.Width, whole.Height)).Max, 0.05) << "nothing is seen";
  for (const Cut& cut : cuts)
  {
    const SmallTextures small(mostLayers(cut.Layers));
    const Image slabs = drawnAnew(scene);
    EXPECT_EQ(small.made(), cut.Slabs * scalars);
    EXPECT_EQ(compare(slabs, whole).Max, 0.0) << cut.Slabs << " slabs";
    EXPECT_EQ(compare(scene.frame(), frame).Max, 0.0) << cut.Slabs << " slabs";
    EXPECT_EQ(scene.Mapper->GetGPUMemoryBytes(), bytes);
    expectCounters(scene);
    keepScenePage(scene.Window);
  }
}

TEST(Slabs, ValuesOfEveryKindAndType)
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT, VTK_SHORT, VTK_FLOAT, VTK_DOUBLE })
  {
    const auto image = imageOf(sineField(), unitCube(Cells));
    convertScalars(image, type);
    StructuredScene scene(image);
    scene.stretchFunctions(rangeInType(type)[0], rangeInType(type)[1]);
    for (const LatticeValues values : AllLatticeValues)
    {
      scene.draw(values);
      expectSlabs(scene, std::string(nameOf(values)) + ", type " + std::to_string(type));
    }
  }
}

TEST(Slabs, GridsWithHiddenCellsAndLeaps)
{
  const auto grid = rectilinearOf(sineField(1.5), unevenCube(Cells));
  markCells(grid, 32, [](vtkIdType id) { return id % 7 == 3; });
  StructuredScene scene(grid);
  scene.render();
  const vtkTypeInt64 all = scene.Mapper->GetNumberOfCrossedCells();
  vtkNew<vtkPiecewiseFunction> few; // most blocks are empty
  few->AddPoint(0.8, 0.0);
  few->AddPoint(0.81, 0.9);
  scene.property()->SetScalarOpacity(few);
  for (const LatticeValues values : { LatticeValues::PointsLinear, LatticeValues::CellsNearest })
  {
    scene.draw(values);
    expectSlabs(scene, nameOf(values));
  }
  EXPECT_LT(scene.Mapper->GetNumberOfCrossedCells(), 0.9 * static_cast<double>(all));
}

TEST(Slabs, BlendModesAndSamples)
{
  StructuredScene scene(imageOf(scatteredField(2), unitCube(Cells)));
  scene.setSurfaces({ 0.3, 0.6 });
  for (const int mode : { vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND,
         vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, vtkVolumeMapper::ISOSURFACE_BLEND })
  {
    scene.Mapper->SetBlendMode(mode);
    expectSlabs(scene, "blend mode " + std::to_string(mode), 1, { Cuts[1] });
  }
  scene.Mapper->SetBlendModeToComposite();
  scene.Mapper->SetAccuracyLevelToSampled();
  scene.Mapper->SetSampleDistance(0.03f);
  expectSlabs(scene, "samples");
}

TEST(Slabs, LightOfAllKinds)
{
  StructuredScene scene(imageOf(sineField(), unitCube(Cells)));
  setShading(scene.property());
  addLightsThatCastShadows(scene.Renderer);
  for (const bool ofCells : { false, true })
  {
    scene.Mapper->SetGradientType(
      ofCells ? scene.Mapper->CELL_GRADIENTS : scene.Mapper->VERTEX_GRADIENTS);
    expectSlabs(scene, ofCells ? "gradients of cells" : "gradients of vertices");
  }
  scene.Mapper->AmbientOcclusionOn();
  for (const int method : { scene.Mapper->SHADOWS_AT_VERTICES, scene.Mapper->SHADOWS_ALONG_RAYS })
  {
    scene.Mapper->SetShadowMethod(method);
    expectSlabs(scene, "shadow method " + std::to_string(method), 1, { Cuts[1] });
  }
}

TEST(Slabs, Picks)
{
  StructuredScene scene(imageOf(scatteredField(1), unitCube(Cells)));
  struct Picked
  {
    double X, Y, Z, Scalar;
    vtkIdType Cell;
    bool operator==(const Picked& other) const
    {
      return this->X == other.X && this->Y == other.Y && this->Z == other.Z &&
             this->Scalar == other.Scalar && this->Cell == other.Cell;
    }
  };
  const auto picks = [&]
  {
    std::vector<std::optional<Picked>> found;
    for (int i = 0; i < StructuredSize * StructuredSize; i += 5)
    {
      const bool hit =
        scene.Mapper->Pick(scene.Renderer, scene.Volume, i % StructuredSize, i / StructuredSize);
      const double* p = scene.Mapper->GetPickedPosition();
      found.push_back(!hit ? std::optional<Picked>()
                           : Picked{ p[0], p[1], p[2], scene.Mapper->GetPickedScalar(),
                               scene.Mapper->GetPickedCellId() });
    }
    return found;
  };
  for (const LatticeValues values : { LatticeValues::PointsLinear, LatticeValues::CellsNearest })
  {
    scene.draw(values);
    drawnAnew(scene);
    const auto whole = picks();
    EXPECT_GT(
      std::count_if(whole.begin(), whole.end(), [](const auto& p) { return p.has_value(); }), 20);
    for (const Cut& cut : Cuts)
    {
      const SmallTextures small(mostLayers(cut.Layers));
      drawnAnew(scene);
      EXPECT_EQ(small.made(), cut.Slabs);
      EXPECT_TRUE(picks() == whole) << cut.Slabs << " slabs, " << nameOf(values);
    }
  }
}

// What one texture takes by its size, as a driver tells that has no limit of layers.
TEST(Slabs, AsLargeAsTheGLTakes)
{
  StructuredScene scene(imageOf(scatteredField(3), unitCube(Cells)));
  const Image whole = scene.render();
  for (const int layers : { 15, 9, 5, 2 })
  {
    TextureLimits limits;
    limits.Texels = 16L * 16 * layers + 100;
    const SmallTextures small(limits);
    EXPECT_EQ(compare(drawnAnew(scene), whole).Max, 0.0) << layers;
    EXPECT_EQ(small.made(), (16 + layers - 1) / layers);
  }
}

// More layers than any driver's texture has to have, with the GL as it is.
TEST(Slabs, ManyLayers)
{
  ImagePlace place;
  place.Extent = { 0, 3, 0, 3, 0, 2999 };
  place.Spacing = { 1.0 / 3, 1.0 / 3, 1.0 / 2999 };
  int most = 0;
  const auto image = imageOf(sineField(), place);
  StructuredScene scene(image);
  scene.render();
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
  const SmallTextures counted({});
  report("3000 layers", expectParity(scene));
  drawnAnew(scene);
  EXPECT_EQ(counted.made(), (3000 + most - 1) / most);
  std::cout << "[ MEASURED ] textures of at most " << most << " layers: " << counted.made() << '\n';
}

class SlabsOfComponents : public ComponentsTest
{
};

TEST_P(SlabsOfComponents, AreThoseOfWholeTextures)
{
  const Mix& mix = GetParam();
  StructuredScene scene(imageWith(wavy(), Cells, VTK_FLOAT));
  setFunctions(scene);
  for (const LatticeValues values : AllLatticeValues)
  {
    scene.draw(values);
    expectSlabs(scene, nameOf(values), mix.Components, { Cuts[0] });
  }
  if (mix.Components == 2)
  {
    expectSlabs(scene, "eight textures", 2, { { 4, 4 } });
  }
  if (!mix.Independent)
  {
    setShading(scene.property());
    scene.draw(LatticeValues::PointsLinear);
    expectSlabs(scene, "with light", mix.Components, { Cuts[0] });
  }
}

INSTANTIATE_TEST_SUITE_P(OfAllMixes, SlabsOfComponents, ::testing::ValuesIn(Mixes),
  [](const auto& mix) { return std::string(mix.param.Name); });
} // namespace
