// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Tetrahedra in two texture buffers make the picture that they make in one, to the last bit. The GL
// claims to take few texels a buffer.
#include "BlendScene.h"
#include "ComponentScene.h"
#include "ErrorWatch.h"
#include "FaultyGL.h"
#include "GLObjects.h"
#include "GapScene.h"
#include "Lights.h"
#include "PickScene.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <iostream>
#include <optional>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 64;
constexpr int Cubes = 12;
constexpr int Tets = 6 * Cubes * Cubes * Cubes;

// One tetrahedron in the second buffer, some, and as many as there may be.
constexpr int Limits[] = { Tets - 1, 2 * Tets / 3, Tets / 2 };

Grid lattice(const Field& field = sineField()) { return jitteredLattice(Cubes, 0.15, 1, field); }

Image drawnAnew(Scene& scene)
{
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  return scene.render();
}

std::vector<vtkTypeInt64> figuresOf(const vtkTetMarchVolumeMapper* mapper)
{
  return { mapper->GetNumberOfTetrahedra(), mapper->GetNumberOfRays(),
    mapper->GetNumberOfCrossedCells(), mapper->GetNumberOfLookups(), mapper->GetNumberOfGuardHits(),
    mapper->GetNumberOfLostRays(), mapper->GetGPUMemoryBytes() };
}

// So many arrays are split.
void expectSplit(Scene& scene, const std::string& what, int arrays)
{
  SCOPED_TRACE(what);
  const Image whole = drawnAnew(scene);
  const Image frame = scene.frame();
  const auto figures = figuresOf(scene.Mapper);
  const int textures = countGLObjects()[0];
  EXPECT_EQ(figures[0], Tets);
  EXPECT_GT(compare(whole, Image(whole.Width, whole.Height)).Max, 0.05) << "nothing is seen";
  for (const int limit : Limits)
  {
    const FaultyGL few = FaultyGL::withMostTexels(limit);
    EXPECT_EQ(compare(drawnAnew(scene), whole).Max, 0.0) << limit;
    EXPECT_EQ(compare(scene.frame(), frame).Max, 0.0) << limit;
    EXPECT_EQ(figuresOf(scene.Mapper), figures) << limit;
    EXPECT_EQ(countGLObjects()[0] - textures, arrays) << limit;
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
  }
}

TEST(SplitCells, ScalarsOfPointsAndCells)
{
  Scene scene(lattice(), Side, Side);
  expectSplit(scene, "points", 1);
  lookFromInside(scene.camera());
  expectSplit(scene, "points, from inside", 1);
  scene.drawCellScalars();
  expectSplit(scene, "cells, from inside", 2);
  lookAtUnitCube(scene.camera());
  expectSplit(scene, "cells", 2);
}

TEST(SplitCells, BlendModes)
{
  BlendScene scene(lattice(noiseField(3, 4)), Side, Side);
  for (const int mode : BlendModes)
  {
    scene.Mapper->SetBlendMode(mode);
    expectSplit(scene, "blend mode " + std::to_string(mode), 1);
  }
}

TEST(SplitCells, HiddenCellsAndVisiblePart)
{
  Scene scene(lattice(), Side, Side);
  hide(scene.Data, isCrumb);
  expectSplit(scene, "hidden cells", 1);
  const vtkTypeInt64 all = scene.Mapper->GetNumberOfCrossedCells();
  vtkNew<vtkPiecewiseFunction> few;
  few->AddPoint(0.75, 0.0);
  few->AddPoint(0.95, 0.9);
  scene.property()->SetScalarOpacity(few);
  expectSplit(scene, "points", 1);
  EXPECT_LT(2 * scene.Mapper->GetNumberOfCrossedCells(), all) << "all is marched through";
  scene.drawCellScalars();
  expectSplit(scene, "cells", 2);
}

// More faces between what is seen and what is not than a buffer has texels; rays have no use for
// them, as they lie a few tetrahedra apart.
TEST(SplitCells, ManyFacesOfWhatIsVisible)
{
  Scene scene(lattice(), Side, Side);
  hide(scene.Data,
    [](double x, double y, double z) { return std::sin(997.0 * x + 1009.0 * y + 1013.0 * z) > 0; });
  expectSplit(scene, "half of the tetrahedra", 1);
}

// More of them, although rays have a use for them: then they march through all of the mesh.
TEST(SplitCells, TooManyFacesToEnterBy)
{
  Scene scene(lattice(), Side, Side);
  hide(scene.Data, [](double x, double y, double z)
    { return std::sin(997.0 * x + 1009.0 * y + 1013.0 * z) > -0.87; });
  const ErrorWatch watch(scene.Mapper);
  const Image whole = scene.render();
  const vtkTypeInt64 entered = scene.Mapper->GetNumberOfCrossedCells();
  const FaultyGL few = FaultyGL::withMostTexels(Tets / 2);
  const Difference difference = compare(drawnAnew(scene), whole);
  EXPECT_LE(difference.Max, 2.0 / 255.0) << difference.text();
  EXPECT_GT(scene.Mapper->GetNumberOfCrossedCells(), 3 * entered);
  EXPECT_EQ(watch.Errors, std::vector<std::string>());
}

TEST(SplitCells, LightOfAllKinds)
{
  LitScene scene(lattice(), Side, Side);
  addLightsThatCastShadows(scene.Renderer);
  expectSplit(scene, "gradients of vertices", 1);
  scene.Mapper->AmbientOcclusionOn();
  for (const int method : { scene.Mapper->SHADOWS_AT_VERTICES, scene.Mapper->SHADOWS_ALONG_RAYS })
  {
    scene.Mapper->SetShadowMethod(method);
    expectSplit(scene, "shadow method " + std::to_string(method), 1);
  }
  scene.addGradientOpacity();
  scene.Mapper->SetGradientTypeToCell();
  expectSplit(scene, "gradients of cells", 2);
  scene.Mapper->SetShadowMethodToAtVertices();
  scene.drawCellScalars();
  expectSplit(scene, "scalars of cells", 2);
}

TEST(SplitCells, Components)
{
  for (const Mix& mix : Mixes)
  {
    ComponentScene scene(lattice(), mix, Side, Side);
    expectSplit(scene, mix.Name, 1);
    scene.drawCells();
    expectSplit(scene, std::string(mix.Name) + ", cells", 3);
  }
}

TEST(SplitCells, Picks)
{
  struct Picked
  {
    Vec3 Position;
    double Scalar;
    vtkIdType Cell;
    bool operator==(const Picked& other) const
    {
      return this->Position == other.Position && this->Scalar == other.Scalar &&
             this->Cell == other.Cell;
    }
  };
  PickScene scene(lattice(), Side, Side);
  const auto picks = [&]
  {
    drawnAnew(scene);
    std::vector<std::optional<Picked>> found;
    for (int i = 0; i < Side * Side; i += 7)
    {
      const bool hit = scene.pick(i % Side, i / Side);
      found.push_back(!hit ? std::optional<Picked>()
                           : Picked{ scene.pickedPosition(), scene.Mapper->GetPickedScalar(),
                               scene.Mapper->GetPickedCellId() });
    }
    return found;
  };
  for (const bool ofCells : { false, true })
  {
    if (ofCells)
    {
      scene.drawCellScalars();
    }
    const auto whole = picks();
    const Selected selected = scene.selectAll();
    EXPECT_GT(
      std::count_if(whole.begin(), whole.end(), [](const auto& p) { return p.has_value(); }), 100);
    for (const int limit : Limits)
    {
      const FaultyGL few = FaultyGL::withMostTexels(limit);
      EXPECT_TRUE(picks() == whole) << limit;
      EXPECT_TRUE(scene.selectAll() == selected) << limit;
    }
  }
}

// Half-faces of the boundary are those of tetrahedra in either buffer.
TEST(SplitCells, ViewsOfTheBoundary)
{
  Scene scene(lattice(), Side, Side);
  for (const int mode : { scene.Mapper->VIEW_BOUNDARY_FACES, scene.Mapper->VIEW_CELLS })
  {
    scene.Mapper->SetViewMode(mode);
    scene.Mapper->ReleaseGraphicsResources(scene.Window);
    scene.Window->Render();
    const Image whole = scene.frame();
    scene.Mapper->ReleaseGraphicsResources(scene.Window);
    const FaultyGL few = FaultyGL::withMostTexels(Limits[1]);
    scene.Window->Render();
    EXPECT_EQ(compare(scene.frame(), whole).Max, 0.0) << mode;
  }
}
} // namespace
