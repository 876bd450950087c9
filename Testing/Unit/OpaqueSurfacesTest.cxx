// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which actors of a scene are opaque geometry, and where their triangles are.
#include "Light/OpaqueSurfaces.h"

#include "OpaqueProps.h"
#include "Shot.h"

#include "vtkAssembly.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositePolyDataMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPropAssembly.h"
#include "vtkProperty.h"
#include "vtkVolume.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

vtkSmartPointer<vtkPolyData> unitPlate()
{
  return plate({ { 0.0, 0.0, 0.0 } }, { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } });
}

class OpaqueSurfacesOf : public ::testing::Test
{
protected:
  std::vector<OpaqueSurface> surfaces(BlockAttributes attributes = nullptr)
  {
    return opaqueSurfaces(this->Renderer, attributes);
  }

  // Where that point of its data is.
  static Vector3 placeOf(const OpaqueSurface& surface, double x, double y, double z)
  {
    const double p[4] = { x, y, z, 1.0 };
    double q[4] = {};
    vtkMatrix4x4::MultiplyPoint(surface.ToWorld.data(), p, q);
    return { { q[0] / q[3], q[1] / q[3], q[2] / q[3] } };
  }

  vtkNew<WindowlessRenderer> Renderer;
};

TEST_F(OpaqueSurfacesOf, NothingIsNothing)
{
  EXPECT_TRUE(this->surfaces().empty());
  this->Renderer->AddActor(vtkNew<vtkActor>()); // without a mapper
  vtkNew<vtkActor> idle;
  idle->SetMapper(vtkNew<vtkPolyDataMapper>());
  this->Renderer->AddActor(idle);
  this->Renderer->AddActor(actorOf(vtkNew<vtkPolyData>()));
  this->Renderer->AddVolume(vtkNew<vtkVolume>());
  EXPECT_TRUE(this->surfaces().empty());
}

TEST_F(OpaqueSurfacesOf, WhatIsSeenAsOpaqueSurface)
{
  const auto actor = actorOf(unitPlate());
  this->Renderer->AddActor(actor);
  EXPECT_EQ(this->surfaces().size(), 1u);
  actor->VisibilityOff();
  EXPECT_TRUE(this->surfaces().empty());
  actor->VisibilityOn();
  actor->GetProperty()->SetOpacity(0.99);
  EXPECT_TRUE(this->surfaces().empty());
  actor->ForceOpaqueOn();
  EXPECT_EQ(this->surfaces().size(), 1u);
  actor->ForceOpaqueOff();
  actor->GetProperty()->SetOpacity(1.0);
  actor->ForceTranslucentOn();
  EXPECT_TRUE(this->surfaces().empty());
  actor->ForceTranslucentOff();
  actor->GetProperty()->SetRepresentationToWireframe();
  EXPECT_TRUE(this->surfaces().empty());
  actor->GetProperty()->SetRepresentationToPoints();
  EXPECT_TRUE(this->surfaces().empty());
  actor->GetProperty()->SetRepresentationToSurface();
  EXPECT_EQ(this->surfaces().size(), 1u);
}

TEST_F(OpaqueSurfacesOf, ActorsArePlaced)
{
  const auto actor = actorOf(unitPlate());
  actor->SetPosition(1.0, 2.0, 3.0);
  actor->SetScale(2.0, 3.0, 4.0);
  actor->RotateZ(90.0);
  this->Renderer->AddActor(actor);
  const Vector3 place = placeOf(this->surfaces().at(0), 1.0, 1.0, 1.0);
  EXPECT_NEAR(place[0], 1.0 - 3.0, 1e-12);
  EXPECT_NEAR(place[1], 2.0 + 2.0, 1e-12);
  EXPECT_NEAR(place[2], 3.0 + 4.0, 1e-12);
}

// An assembly in another one, which shows one of its actors a second time in another place.
TEST_F(OpaqueSurfacesOf, AssembliesMoveTheirParts)
{
  const auto data = unitPlate();
  const auto actor = actorOf(data);
  actor->SetPosition(1.0, 0.0, 0.0);
  const auto hidden = actorOf(data);
  hidden->VisibilityOff();
  vtkNew<vtkAssembly> inner;
  inner->AddPart(actor);
  inner->AddPart(hidden);
  inner->RotateZ(90.0);
  vtkNew<vtkAssembly> outer;
  outer->AddPart(inner);
  outer->AddPart(actor);
  outer->SetScale(10.0, 10.0, 10.0);
  vtkNew<vtkPropAssembly> group;
  group->AddPart(outer);
  this->Renderer->AddViewProp(group);
  const auto found = this->surfaces();
  ASSERT_EQ(found.size(), 2u);
  const Vector3 turned = placeOf(found[0], 0.5, 0.0, 0.0);
  EXPECT_NEAR(turned[0], 0.0, 1e-12);
  EXPECT_NEAR(turned[1], 15.0, 1e-12);
  const Vector3 moved = placeOf(found[1], 0.5, 0.0, 0.0);
  EXPECT_NEAR(moved[0], 15.0, 1e-12);
  EXPECT_NEAR(moved[1], 0.0, 1e-12);
  EXPECT_EQ(found[0].Data, data.Get());
  group->VisibilityOff();
  EXPECT_TRUE(this->surfaces().empty());
}

vtkNew<vtkCompositeDataDisplayAttributes>& attributes()
{
  static vtkNew<vtkCompositeDataDisplayAttributes> one;
  return one;
}

TEST_F(OpaqueSurfacesOf, BlocksOfCompositeData)
{
  const auto a = unitPlate();
  const auto b = unitPlate();
  const auto c = unitPlate();
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, a);
  inner->SetBlock(1, b);
  vtkNew<vtkMultiBlockDataSet> outer;
  outer->SetBlock(0, inner);
  outer->SetBlock(2, c);
  vtkNew<vtkCompositePolyDataMapper> mapper;
  mapper->SetInputDataObject(outer);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->Renderer->AddActor(actor);
  const auto found = [this]
  {
    std::vector<vtkPolyData*> data;
    for (const OpaqueSurface& surface :
      this->surfaces([](vtkMapper*) { return attributes().Get(); }))
    {
      data.push_back(surface.Data);
    }
    return data;
  };
  using Blocks = std::vector<vtkPolyData*>;
  EXPECT_EQ(this->surfaces().size(), 3u);
  EXPECT_EQ(found(), (Blocks{ a, b, c }));
  attributes()->SetBlockVisibility(inner, false);
  EXPECT_EQ(found(), (Blocks{ c }));
  attributes()->SetBlockVisibility(b, true);
  EXPECT_EQ(found(), (Blocks{ b, c }));
  attributes()->SetBlockOpacity(c, 0.5);
  EXPECT_EQ(found(), (Blocks{ b }));
}

// z is where a line along it from (x, y, 9) down hits.
bool isOver(const TriangleHierarchy& triangles, double x, double y)
{
  return triangles.isHit({ { x, y, 9.0 } }, { { 0.0, 0.0, -1.0 } }, 99.0);
}

TEST(TrianglesOf, PolygonsAndStripsAndNothingElse)
{
  vtkNew<vtkPoints> points;
  for (int x = 0; x < 12; ++x)
  {
    points->InsertNextPoint(x, 0.0, 0.0);
    points->InsertNextPoint(x, 1.0, 0.0);
  }
  vtkNew<vtkCellArray> polygons, strips, lines, vertices;
  polygons->InsertNextCell({ 0, 2, 1 });
  polygons->InsertNextCell({ 2, 4, 6, 7, 5, 3 }); // of six corners
  polygons->InsertNextCell({ 0, 1 });             // of no area
  strips->InsertNextCell({ 8, 9, 10, 11, 12, 13 });
  lines->InsertNextCell({ 14, 17 });
  vertices->InsertNextCell({ 20 });
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(polygons);
  data->SetStrips(strips);
  data->SetLines(lines);
  data->SetVerts(vertices);
  const TriangleHierarchy triangles = trianglesOf({ data });
  EXPECT_TRUE(isOver(triangles, 0.3, 0.3));
  EXPECT_FALSE(isOver(triangles, 0.7, 0.7));
  for (const double x : { 1.1, 1.9, 2.3, 2.8, 4.1, 4.9, 5.5, 5.9 })
  {
    for (const double y : { 0.1, 0.5, 0.9 })
    {
      EXPECT_TRUE(isOver(triangles, x, y)) << x << ' ' << y;
    }
  }
  for (const double x : { -0.1, 3.5, 6.1, 7.5, 10.0 })
  {
    EXPECT_FALSE(isOver(triangles, x, 0.5)) << x;
  }
}

TEST(TrianglesOf, PointsThatAreNotFiniteTakeNothingElseAlong)
{
  const auto data = unitPlate();
  data->GetPoints()->SetPoint(2, std::numeric_limits<double>::quiet_NaN(), 1.0, 0.0);
  const TriangleHierarchy triangles = trianglesOf({ data });
  EXPECT_TRUE(isOver(triangles, 0.7, 0.3));
  EXPECT_FALSE(isOver(triangles, 0.3, 0.7));
}
} // namespace
