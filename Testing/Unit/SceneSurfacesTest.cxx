// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The surfaces of a page: triangles with the normals and materials of VTK.
#include "SurfacesOfRenderer.h"

#include "vtkCellData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositePolyDataMapper.h"
#include "vtkDataSetMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkProperty.h"

#include <limits>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

using Numbers = std::vector<std::uint32_t>;
using SceneSurfaces = SurfacesOfRenderer;

TEST_F(SceneSurfaces, ArePolygonsAndStripsWhereTheActorIs)
{
  this->add(patch())->SetPosition(1e6, 0.0, 5.0);
  const Surface surface = this->only();
  EXPECT_EQ(surface.Triangles, (Numbers{ 0, 1, 2, 0, 2, 3, 4, 5, 6, 5, 7, 6 }));
  ASSERT_EQ(surface.Positions.size(), 24u);
  EXPECT_TRUE(surface.Normals.empty());
  EXPECT_TRUE(surface.Colors.empty());
  // All triangles turn the same way.
  for (std::size_t t = 0; t < surface.Triangles.size(); t += 3)
  {
    const Vector3 a = placeOf(surface, surface.Triangles[t]);
    const Vector3 normal = cross(placeOf(surface, surface.Triangles[t + 1]) - a,
      placeOf(surface, surface.Triangles[t + 2]) - a);
    EXPECT_EQ(normal, (Vector3{ { 0.0, 0.0, 1.0 } })) << t;
  }
  EXPECT_EQ(placeOf(surface, 0), (Vector3{ { 1e6 + 10.0, 0.0, 5.0 } }));
  EXPECT_EQ(placeOf(surface, 7), (Vector3{ { 1e6 + 11.0, 2.0, 5.0 } }));
}

TEST_F(SceneSurfaces, KeepDetailsFarFromTheOrigin)
{
  this->add(plate({ { 1e8, 0.0, 0.0 } }, { { 1e8 + 1.0, 0.0, 0.0 } }, { { 1e8, 1.0, 0.0 } }));
  EXPECT_EQ(placeOf(this->only(), 1), (Vector3{ { 1e8 + 1.0, 0.0, 0.0 } }));
}

TEST_F(SceneSurfaces, HaveTheMaterialOfTheirActor)
{
  vtkProperty* property = this->add(patch())->GetProperty();
  property->SetDiffuseColor(0.1, 0.2, 0.3);
  property->SetAmbientColor(0.4, 0.5, 0.6);
  property->SetSpecularColor(0.7, 0.8, 0.9);
  property->SetAmbient(0.25);
  property->SetDiffuse(0.5);
  property->SetSpecular(0.75);
  property->SetSpecularPower(20.0);
  property->LightingOff();
  property->SetInterpolationToFlat();
  property->BackfaceCullingOn();
  const Surface surface = this->only();
  using Color = std::array<double, 3>;
  EXPECT_EQ(surface.Color, (Color{ { 0.1, 0.2, 0.3 } }));
  EXPECT_EQ(surface.AmbientColor, (Color{ { 0.4, 0.5, 0.6 } }));
  EXPECT_EQ(surface.SpecularColor, (Color{ { 0.7, 0.8, 0.9 } }));
  EXPECT_EQ(surface.Ambient, 0.25);
  EXPECT_EQ(surface.Diffuse, 0.5);
  EXPECT_EQ(surface.Specular, 0.75);
  EXPECT_EQ(surface.SpecularPower, 20.0);
  EXPECT_FALSE(surface.Lighting);
  EXPECT_TRUE(surface.Flat);
  EXPECT_TRUE(surface.FrontFaces);
  EXPECT_FALSE(surface.BackFaces);
}

TEST_F(SceneSurfaces, HaveNormalsOfPointsOrElseOfCellsUnlessFlat)
{
  const auto normals = [](int count, float z)
  {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetNumberOfComponents(3);
    for (int i = 0; i < count; ++i)
    {
      array->InsertNextTuple3(0.0, 0.0, z);
    }
    return array;
  };
  const auto data = patch();
  vtkActor* actor = this->add(data);
  data->GetCellData()->SetNormals(normals(3, -1.0f));
  EXPECT_EQ(this->only().Normals.at(2), -1.0f);
  data->GetPointData()->SetNormals(normals(8, 1.0f));
  EXPECT_EQ(this->only().Normals.size(), 24u);
  EXPECT_EQ(this->only().Normals.at(2), 1.0f);
  actor->GetProperty()->SetInterpolationToFlat();
  EXPECT_TRUE(this->only().Normals.empty());
}

TEST_F(SceneSurfaces, LeaveOutTrianglesOfPointsThatAreNotFinite)
{
  const auto data = patch();
  data->GetPoints()->SetPoint(2, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  this->add(data);
  EXPECT_EQ(this->only().Triangles.size(), 9u);
}

// One that has drawn a patch, or not yet.
class DataSetMapper : public vtkDataSetMapper
{
public:
  static DataSetMapper* New() { VTK_STANDARD_NEW_BODY(DataSetMapper); }
  void draw()
  {
    this->PolyDataMapper = vtkPolyDataMapper::New();
    this->PolyDataMapper->SetInputData(patch());
  }

private:
  DataSetMapper() { this->SetInputData(patch()); }
};

TEST_F(SceneSurfaces, AreThoseThatADataSetMapperHasDrawn)
{
  vtkNew<DataSetMapper> mapper;
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->Renderer->AddActor(actor);
  EXPECT_TRUE(this->surfaces().empty());
  mapper->draw();
  EXPECT_EQ(this->only().Triangles.size(), 12u);
}

vtkNew<vtkCompositeDataDisplayAttributes>& attributes()
{
  static vtkNew<vtkCompositeDataDisplayAttributes> one;
  return one;
}

TEST_F(SceneSurfaces, AreLeavesOfCompositeDataInTheColorsOfTheirBlocks)
{
  const auto inner = patch();
  inner->GetPointData()->SetScalars(arrayOf("s", { 0, 1, 0, 1, 0, 0, 0, 1 }));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, inner);
  blocks->SetBlock(1, patch());
  vtkNew<vtkCompositePolyDataMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->Renderer->AddActor(actor);
  EXPECT_EQ(this->surfaces().size(), 2u);
  EXPECT_EQ(this->surfaces()[0].Colors.size(), 32u);
  const double green[] = { 0.0, 1.0, 0.0 };
  attributes()->SetBlockColor(blocks, green);
  for (const Surface& surface : this->surfaces([](vtkMapper*) { return attributes().Get(); }))
  {
    EXPECT_EQ(surface.Color[1], 1.0);
    EXPECT_EQ(surface.AmbientColor[0], 0.0);
    EXPECT_TRUE(surface.Colors.empty());
  }
}
} // namespace
