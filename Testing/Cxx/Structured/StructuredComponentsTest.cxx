// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws of several components of an image or a rectilinear grid: pixel by pixel against
// the CPU reference, and against the picture of a mesh with the same linear fields.
#include "ComponentScene.h"
#include "ComponentTruth.h"
#include "StructuredScene.h"
#include "Unprojection.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPlane.h"

#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;

// Of the components that a mix asks for, of which each point of noise has a number of its own.
std::vector<Field> scatteredFields(int count)
{
  std::vector<Field> fields;
  for (int k = 0; k < count; ++k)
  {
    fields.push_back(scatteredField(3 + 7 * k));
  }
  return fields;
}

vtkSmartPointer<vtkImageData> imageWith(const std::vector<Field>& fields, int cells, int type)
{
  const auto image = imageOf(fields[0], unitCube(cells));
  setComponents(image, fields, type);
  return image;
}

class StructuredComponents : public testing::TestWithParam<Mix>
{
protected:
  static std::vector<Field> wavy() { return wavyFields(GetParam().Components); }

  static void setFunctions(StructuredScene& scene)
  {
    setComponentFunctions(scene.property(), GetParam().Components);
    scene.property()->SetIndependentComponents(GetParam().Independent);
  }
};

TEST_P(StructuredComponents, ImagesAndGrids)
{
  const auto image = imageWith(wavy(), 9, VTK_DOUBLE);
  const auto grid = rectilinearOf(constantField(0.0), unevenCube(8));
  setComponents(grid, wavy(), VTK_FLOAT);
  for (vtkDataSet* data : { static_cast<vtkDataSet*>(image), static_cast<vtkDataSet*>(grid) })
  {
    StructuredScene scene(data);
    setFunctions(scene);
    for (const LatticeValues values : AllLatticeValues)
    {
      const std::string what =
        std::string(GetParam().Name) + ", " + data->GetClassName() + ", " + nameOf(values);
      SCOPED_TRACE(what);
      scene.draw(values);
      report(what, expectParity(scene));
    }
  }
}

TEST_P(StructuredComponents, ScatteredThinAndThick)
{
  const auto image = imageWith(scatteredFields(GetParam().Components), 8, VTK_DOUBLE);
  StructuredScene scene(image);
  setFunctions(scene);
  for (const double unit : { 0.02, 0.25, 5.0 })
  {
    scene.property()->SetScalarOpacityUnitDistance(unit);
    report("scattered, unit " + std::to_string(unit), expectParity(scene));
  }
  scene.Mapper->SetOpacityLawToUnstructured();
  report("the other law", expectParity(scene));
  scene.property()->SetScalarOpacityUnitDistance(1e-9); // beyond the range of float
  const Image opaque = scene.render();
  EXPECT_GT(compare(opaque, Image(opaque.Width, opaque.Height)).Max, 0.2);
}

TEST_P(StructuredComponents, BytesAndWords)
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_SHORT })
  {
    const auto image = imageWith(wavy(), 7, type);
    StructuredScene scene(image);
    setFunctions(scene);
    for (int k = 0; k < GetParam().Components; ++k)
    {
      vtkNew<vtkColorTransferFunction> colours;
      vtkNew<vtkPiecewiseFunction> opacities;
      colours->AddRGBPoint(0.0, 0.2 * k, 0.9, 0.1);
      colours->AddRGBPoint(255.0, 0.9, 0.1, 1.0 - 0.2 * k);
      opacities->AddPoint(0.0, 0.1);
      opacities->AddPoint(130.0 + 20.0 * k, 0.8);
      opacities->AddPoint(255.0, 0.2);
      scene.property()->SetColor(k, colours);
      scene.property()->SetScalarOpacity(k, opacities);
    }
    for (const LatticeValues values : { LatticeValues::PointsLinear, LatticeValues::CellsNearest })
    {
      const std::string what = image->GetPointData()->GetScalars()->GetDataTypeAsString() +
                               std::string(", ") + nameOf(values);
      SCOPED_TRACE(what);
      scene.draw(values);
      report(what, expectParity(scene));
    }
  }
}

TEST_P(StructuredComponents, HiddenAndNotFinite)
{
  const auto image = imageWith(wavy(), 8, VTK_DOUBLE);
  for (const auto& scalars :
    { image->GetPointData()->GetScalars(), image->GetCellData()->GetScalars() })
  {
    const int last = scalars->GetNumberOfComponents() - 1;
    for (vtkIdType i = 5; i < scalars->GetNumberOfTuples(); i += 37)
    {
      scalars->SetComponent(i, i % 2 ? 0 : last, std::nan(""));
    }
  }
  markCells(image, vtkDataSetAttributes::HIDDENCELL, [](vtkIdType id) { return id % 11 == 3; });
  StructuredScene scene(image);
  setFunctions(scene);
  for (const bool shown : { false, true })
  {
    scene.Mapper->SetDrawNanCells(shown);
    scene.property()->GetRGBTransferFunction()->SetNanColorRGBA(0.9, 0.2, 0.7, 0.4);
    for (const LatticeValues values : AllLatticeValues)
    {
      const std::string what = std::string(shown ? "shown, " : "not shown, ") + nameOf(values);
      SCOPED_TRACE(what);
      scene.draw(values);
      report(what, expectParity(scene));
    }
  }
}

TEST_P(StructuredComponents, CutBeforeOpaqueGeometryAndFromInside)
{
  const auto image = imageWith(wavy(), 9, VTK_DOUBLE);
  StructuredScene scene(image);
  setFunctions(scene);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.5, 0.45, 0.4);
  plane->SetNormal(-0.6, 0.3, -1.0);
  scene.Mapper->AddClippingPlane(plane);
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(0.237, 0.711, 0.313, 0.564, 0.159, 0.823);
  scene.Mapper->SetCroppingRegionFlagsToFence();
  report("cut", expectParity(scene));
  scene.Mapper->RemoveAllClippingPlanes();
  scene.Mapper->CroppingOff();
  const auto ball = makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 1.0, 1.0 });
  scene.Renderer->AddActor(ball);
  expectParityButForEdges(scene, "before a ball");
  scene.Renderer->RemoveActor(ball);
  lookFromInside(scene.camera());
  report("inside", expectParity(scene));
}

// Most of the volume is transparent, and rays leap over it: of independent components only where
// none of them shows anything.
TEST_P(StructuredComponents, MuchEmptySpace)
{
  const auto image = imageWith(wavy(), 36, VTK_FLOAT);
  StructuredScene scene(image);
  setFunctions(scene);
  for (int k = 0; k < GetParam().Components; ++k)
  {
    vtkPiecewiseFunction* opacity = scene.property()->GetScalarOpacity(k);
    opacity->RemoveAllPoints();
    opacity->AddPoint(0.8 + 0.02 * k, 0.0);
    opacity->AddPoint(0.85 + 0.02 * k, 0.9);
  }
  report(std::string(GetParam().Name) + ", empty space", expectParity(scene));
}

// That a pick is where half of the light is left, by the brute force of all components together.
void expectPicks(StructuredScene& scene, const ComponentTruth& truth)
{
  constexpr double slack = 1.0 / 255.0;
  const int side = scene.Renderer->GetSize()[0];
  const Unprojection unproject(scene.camera());
  int hits = 0;
  for (int y = 2; y < side; y += 5)
  {
    for (int x = 1; x < side; x += 5)
    {
      const double u = 2.0 * (x + 0.5) / side - 1.0;
      const double v = 2.0 * (y + 0.5) / side - 1.0;
      const Vec3 near = unproject(u, v, -1.0);
      const Vec3 far = unproject(u, v, 1.0);
      Vec3 d{ far[0] - near[0], far[1] - near[1], far[2] - near[2] };
      const double length = std::hypot(d[0], d[1], d[2]);
      d = { d[0] / length, d[1] / length, d[2] / length };
      const bool hit = scene.Mapper->Pick(scene.Renderer, scene.Volume, x, y);
      const double opacity = truth.integrate(near, d, 0.0, 10.0)[3];
      EXPECT_EQ(hit, std::abs(opacity - 0.5) < slack ? hit : opacity > 0.5);
      if (hit && opacity > 0.5 + slack)
      {
        ++hits;
        const double* p = scene.Mapper->GetPickedPosition();
        const double found =
          (p[0] - near[0]) * d[0] + (p[1] - near[1]) * d[1] + (p[2] - near[2]) * d[2];
        EXPECT_NEAR(truth.integrate(near, d, 0.0, found)[3], 0.5, slack);
      }
    }
  }
  EXPECT_GT(hits, 8);
}

TEST_P(StructuredComponents, Picks)
{
  const int count = GetParam().Components;
  const auto linear = imageWith(componentFields(count), 6, VTK_DOUBLE);
  const auto scattered = imageWith(scatteredFields(count), 6, VTK_DOUBLE);
  for (const LatticeValues values : AllLatticeValues)
  {
    SCOPED_TRACE(nameOf(values));
    const bool nearest =
      values == LatticeValues::PointsNearest || values == LatticeValues::CellsNearest;
    vtkImageData* image = nearest ? scattered : linear;
    StructuredScene scene(image, 32, 32);
    setFunctions(scene);
    scene.draw(values);
    scene.property()->SetScalarOpacityUnitDistance(0.1);
    scene.Window->Render();
    expectPicks(scene, { image, scene.property(), values, OpacityLaw::Logarithmic });
  }
}

// A mesh of tetrahedra with the same linear fields gives the same picture.
TEST_P(StructuredComponents, ThoseOfAMesh)
{
  constexpr int side = 96;
  const std::vector<Field> fields = componentFields(GetParam().Components);
  Scene mesh(
    withComponents(jitteredLattice(8, 0.15, 1, linearField()), fields, VTK_DOUBLE), side, side);
  drawComponents(mesh, GetParam());
  mesh.Mapper->SetOpacityLawToStructured();
  mesh.Mapper->SetAccuracyLevelToAccurate();
  const auto image = imageWith(fields, 8, VTK_DOUBLE);
  StructuredScene lattice(image, side, side);
  setFunctions(lattice);
  lattice.Mapper->SetAccuracyLevelToAccurate();
  const Image ofMesh = mesh.render();
  const Image ofLattice = lattice.render();
  // At the silhouette the rasteriser decides which pixels see tetrahedra.
  Mask inside(std::size_t(side) * side, false);
  for (int y = 1; y + 1 < side; ++y)
  {
    for (int x = 1; x + 1 < side; ++x)
    {
      bool all = true;
      for (int n = 0; n < 9; ++n)
      {
        all = all && ofLattice.pixel(x + n % 3 - 1, y + n / 3 - 1)[3] > 0.0f;
      }
      inside[std::size_t(y) * side + x] = all;
    }
  }
  const Difference difference = compare(ofMesh, ofLattice, inside, 0.5 / 255.0);
  std::cout << "[ MEASURED ] " << GetParam().Name << ": " << difference.text() << '\n';
  EXPECT_GT(difference.Pixels, 400u);
  EXPECT_LE(difference.Max, 0.5 / 255.0) << difference.text();
}

INSTANTIATE_TEST_SUITE_P(Of, StructuredComponents, testing::ValuesIn(Mixes),
  [](const auto& of) { return std::string(of.param.Name); });

class LitStructuredComponents : public StructuredComponents
{
protected:
  LitStructuredComponents()
    : Made(imageWith(wavy(), 8, VTK_DOUBLE))
    , Shown(Made)
  {
    setFunctions(this->Shown);
    setShading(this->Shown.property());
  }
  // The level's tolerance does not cover light.
  static constexpr Promises Lit{ true, false };

  vtkSmartPointer<vtkImageData> Made;
  StructuredScene Shown;
};

TEST_P(LitStructuredComponents, EachEffect)
{
  for (const LatticeValues values : { LatticeValues::PointsLinear, LatticeValues::CellsNearest })
  {
    SCOPED_TRACE(nameOf(values));
    this->Shown.draw(values);
    report("headlight", expectParity(this->Shown, Lit));
  }
  this->Shown.draw(LatticeValues::PointsLinear);
  this->Shown.addLight(3.0, 4.0, 1.5);
  this->Shown.Mapper->SetGradientTypeToCell();
  report("sun, cell gradients", expectParity(this->Shown, Lit));
  this->Shown.Mapper->SetGradientTypeToVertex();
  setGradientOpacity(this->Shown.property());
  report("gradient opacity", expectParity(this->Shown, { false, false }));
}

// The light is that of the component that gives the opacity, which has the same illumination if it
// is alone. Extremes of a colour's scalar cut trilinear cells, so that light is found at more
// points.
TEST_P(LitStructuredComponents, LightIsThatOfTheOpacity)
{
  this->Shown.addLight(3.0, 4.0, 1.5);
  this->Shown.Mapper->SetViewModeToIllumination();
  for (const LatticeValues values : AllLatticeValues)
  {
    const bool nearest =
      values == LatticeValues::PointsNearest || values == LatticeValues::CellsNearest;
    if (nearest || GetParam().Components == 4)
    {
      this->Shown.draw(values);
      this->Shown.Mapper->SetVectorMode(vtkSmartVolumeMapper::DISABLED);
      const Image together = this->Shown.render();
      this->Shown.Mapper->SetVectorMode(vtkSmartVolumeMapper::COMPONENT);
      this->Shown.Mapper->SetVectorComponent(GetParam().Components - 1);
      const Difference difference = compare(together, this->Shown.render());
      EXPECT_LE(difference.Max, 1.0 / 255.0) << nameOf(values) << ": " << difference.text();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, LitStructuredComponents, testing::Values(Mixes[3], Mixes[4]),
  [](const auto& of) { return std::string(of.param.Name); });
} // namespace
