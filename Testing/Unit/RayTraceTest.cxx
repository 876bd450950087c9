// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The trace of a ray is the march of the picture: its last colour is that of the pixel to the last
// bit, in every kind of scene.
#include "Reference/RayTrace.h"

#include "Mesh/Gradients.h"
#include "Mesh/HiddenCells.h"

#include "ComponentFields.h"
#include "Shot.h"

#include "vtkContourValues.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"

#include <gtest/gtest.h>
#include <map>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr int Step = 5; // between the pixels that are looked at

std::array<float, 4> inPicture(const std::array<double, 4>& color)
{
  return { { float(color[0]), float(color[1]), float(color[2]), float(color[3]) } };
}

/// How many cells had which outcome, over the rays of a scene.
using Outcomes = std::map<CellOutcome, int>;

void expectOrder(const RayTrace& trace)
{
  double done = trace.Begin;
  for (const TracedCell& cell : trace.Cells)
  {
    if (cell.Outcome == CellOutcome::Gathered)
    {
      EXPECT_GE(cell.Begin, done);
      EXPECT_GT(cell.End, cell.Begin);
      EXPECT_LE(cell.End, trace.End);
      EXPECT_GE(cell.Begin, cell.Enter);
      EXPECT_LE(cell.End, cell.Leave);
      done = cell.End;
    }
  }
}

void expectPixel(const RayTrace& trace, const ReferenceImage& image, std::size_t pixel)
{
  const float* drawn = &image.Pixels[4 * pixel];
  EXPECT_EQ(inPicture(trace.Color), (std::array{ drawn[0], drawn[1], drawn[2], drawn[3] }));
  EXPECT_EQ(float(trace.ErrorBound), image.ErrorBounds[pixel]);
  std::int64_t lookups = 0;
  for (const TracedCell& cell : trace.Cells)
  {
    lookups += cell.Lookups;
  }
  EXPECT_EQ(lookups, trace.Counters.Lookups);
  EXPECT_EQ(std::int64_t(trace.Cells.size()), trace.Counters.Cells);
  if (!trace.Cells.empty())
  {
    EXPECT_EQ(trace.Cells.back().Color, trace.Color);
    EXPECT_EQ(trace.Cells.back().ErrorBound, trace.ErrorBound);
    EXPECT_TRUE(trace.Cells.front().EntersMesh);
  }
  expectOrder(trace);
}

template <typename Real>
Outcomes expectPicture(const ReferenceScene& scene, const AccuracyLevel& level)
{
  const ReferenceImage image = renderReference<Real>(scene, level);
  Outcomes outcomes;
  for (int y = 2; y < scene.Height; y += Step)
  {
    for (int x = 2; x < scene.Width; x += Step)
    {
      const RayTrace trace = traceRay<Real>(scene, level, x, y);
      expectPixel(trace, image, std::size_t(y) * scene.Width + x);
      for (const TracedCell& cell : trace.Cells)
      {
        ++outcomes[cell.Outcome];
      }
      if (::testing::Test::HasFailure())
      {
        ADD_FAILURE() << "pixel " << x << ", " << y;
        return outcomes;
      }
    }
  }
  EXPECT_GT(outcomes[CellOutcome::Gathered], 50);
  return outcomes;
}

/// In float and in double; the outcomes are those in double.
Outcomes expectPictures(const ReferenceScene& scene, const AccuracyLevel& level = DefaultAccuracy)
{
  expectPicture<float>(scene, level);
  return expectPicture<double>(scene, level);
}

TEST(RayTrace, EndsWithThePixelOfPlainScenes)
{
  Shot hole;
  hole.Data = latticeWithHole(6, 0.15, 1, sineField());
  for (const AccuracyLevel& level : { FastAccuracy, DefaultAccuracy, ReferenceAccuracy })
  {
    const MarchedShot marched(hole, level);
    expectPictures(marched.Scene, level);
  }
  Shot cells;
  cells.Scalars = ScalarsOf::Cells;
  expectPictures(MarchedShot(cells, DefaultAccuracy).Scene);
  Shot inside;
  inside.Camera->SetPosition(0.31, 0.42, 0.57);
  inside.Camera->SetFocalPoint(1.0, 0.6, 0.4);
  inside.Camera->SetClippingRange(0.01, 5.0);
  const Outcomes outcomes = expectPictures(MarchedShot(inside, DefaultAccuracy).Scene);
  EXPECT_GT(outcomes.at(CellOutcome::OutOfRange), 100); // behind the camera
}

TEST(RayTrace, EndsWithThePixelOfCutScenes)
{
  Shot shot;
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.5, 0.5, 0.7);
  plane->SetNormal(0.1, 0.2, -1.0);
  vtkNew<vtkPlaneCollection> planes;
  planes->AddItem(plane);
  shot.Cut.Planes = planes;
  EXPECT_GT(
    expectPictures(MarchedShot(shot, DefaultAccuracy).Scene).at(CellOutcome::OutOfRange), 50);

  Shot cropped;
  cropped.Cut.Cropping = true;
  cropped.Cut.CroppingPlanes = { { 0.1, 0.8, 0.2, 0.9, 0.1, 0.9 } };
  cropped.Cut.CroppingFlags = 0x7ffffff & ~(1 << 13); // all but the middle
  EXPECT_GT(
    expectPictures(MarchedShot(cropped, DefaultAccuracy).Scene).at(CellOutcome::Cropped), 50);
}

TEST(RayTrace, TellsWhyNothingIsGathered)
{
  Shot shot;
  MarchedShot marched(shot, DefaultAccuracy);
  HiddenCells hidden(marched.Mesh.Tets.size() / 32 + 1, 0x11111111u);
  marched.Scene.Hidden = &hidden;
  EXPECT_GT(expectPictures(marched.Scene).at(CellOutcome::Hidden), 100);
  marched.Scene.Hidden = nullptr;

  TetMesh mesh = marched.Mesh;
  for (std::size_t v = 0; v < mesh.Vertices.size(); v += 16)
  {
    mesh.Vertices[v].Scalar = UndrawnScalar;
  }
  marched.Scene.Mesh = &mesh;
  EXPECT_GT(expectPictures(marched.Scene).at(CellOutcome::NotFinite), 100);
  IntegralTable table = *marched.Scene.Table;
  table.NanColor = { { 1.0f, 0.0f, 0.0f, 0.5f } };
  marched.Scene.Table = &table;
  marched.Scene.NanShown = true;
  expectPictures(marched.Scene);

  Shot clear;
  clear.Optics.Opacity = vtkSmartPointer<vtkPiecewiseFunction>::New();
  clear.Optics.Opacity->AddPoint(0.0, 0.0);
  clear.Optics.Opacity->AddPoint(0.5, 0.0);
  clear.Optics.Opacity->AddPoint(1.0, 1.0);
  EXPECT_GT(
    expectPictures(MarchedShot(clear, DefaultAccuracy).Scene).at(CellOutcome::Transparent), 100);
}

TEST(RayTrace, EndsWithThePixelOfOtherBlendModes)
{
  Shot shot;
  shot.Adjust = [](vtkVolumeProperty* property)
  {
    vtkContourValues* surfaces = property->GetIsoSurfaceValues();
    surfaces->SetNumberOfContours(2);
    surfaces->SetValue(0, 0.45);
    surfaces->SetValue(1, 0.7);
  };
  for (int mode = int(BlendMode::Maximum); mode <= int(BlendMode::IsoSurface); ++mode)
  {
    shot.Blend = { mode, { { 0.2, 0.8 } } };
    const MarchedShot marched(shot, DefaultAccuracy);
    const Outcomes outcomes = expectPictures(marched.Scene);
    EXPECT_EQ(
      outcomes.count(CellOutcome::Transparent), marched.Scene.Blend->isIsoSurface() ? 1u : 0u);
  }
}

TEST(RayTrace, EndsWithThePixelOfLitScenes)
{
  for (const ScalarsOf scalars : { ScalarsOf::Points, ScalarsOf::Cells })
  {
    Shot shot;
    shot.Scalars = scalars;
    MarchedShot marched(shot, DefaultAccuracy);
    EffectData effects;
    effects.Gradients = scalars == ScalarsOf::Points
                          ? vertexGradients(marched.Mesh)
                          : vertexGradients(marched.Mesh, marched.Scalars.OfCells);
    LightUniforms::Light sun;
    sun.Diffuse = { { 0.8, 0.6, 0.4 } };
    sun.Place = { { 0.6, 0.0, 0.8, 0.0 } };
    effects.Lights.Sources = { sun };
    marched.Scene.Effects = &effects;
    expectPictures(marched.Scene);
  }
}

TEST(RayTrace, EndsWithThePixelOfSeveralComponents)
{
  for (const bool independent : { true, false })
  {
    for (const bool cells : { false, true })
    {
      Shot shot;
      shot.Data = withComponents(shot.Data, componentFields(4), VTK_DOUBLE);
      shot.Scalars = cells ? ScalarsOf::Cells : ScalarsOf::Points;
      shot.Vector = { VectorMode::AllComponents, 0 };
      shot.Adjust = [independent](vtkVolumeProperty* property)
      {
        property->SetIndependentComponents(independent);
        setComponentFunctions(property, 4);
      };
      const MarchedShot marched(shot, DefaultAccuracy);
      expectPictures(marched.Scene);
      EXPECT_EQ(traceRay<double>(marched.Scene, DefaultAccuracy, 24, 24).Components, 4);
    }
  }
}
} // namespace
