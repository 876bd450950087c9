// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whole pictures of the CPU twin, pixel by pixel against the oracle in world coordinates.
#include "Reference/ReferenceImage.h"

#include "Images.h"
#include "Oracle.h"
#include "UnitMeshes.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <type_traits>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr int Size = 48;

// Cameras and their matrices need no window.
class WindowlessRenderer : public vtkRenderer
{
public:
  static WindowlessRenderer* New();
  void DeviceRender() override {}
};
vtkStandardNewMacro(WindowlessRenderer);

// What a picture is taken of, and how.
struct Shot
{
  Grid Data = jitteredLattice(6, 0.15, 1, sineField());
  ScalarsOf Scalars = ScalarsOf::Points;
  vtkNew<vtkTransform> Transform;
  vtkNew<vtkCamera> Camera;
  std::vector<float> Depths; // empty: none
  double UnitDistance = 0.25;

  Shot()
  {
    this->Camera->SetPosition(2.1, 1.4, 2.9);
    this->Camera->SetFocalPoint(0.5, 0.45, 0.5);
    this->Camera->SetViewUp(0.1, 1.0, 0.0);
    this->Camera->SetClippingRange(0.1, 20.0);
  }
};

OpticalModel modelOf(const Shot& shot)
{
  OpticalModel model;
  model.Colour = vtkSmartPointer<vtkColorTransferFunction>::New();
  model.Colour->AddRGBPoint(0.0, 0.1, 0.2, 1.0);
  model.Colour->AddRGBPoint(0.45, 0.1, 1.0, 0.3);
  model.Colour->AddRGBPoint(0.55, 1.0, 0.9, 0.0);
  model.Colour->AddRGBPoint(1.0, 1.0, 0.1, 0.1);
  model.Opacity = vtkSmartPointer<vtkPiecewiseFunction>::New();
  model.Opacity->AddPoint(0.0, 0.6);
  model.Opacity->AddPoint(0.4, 0.1);
  model.Opacity->AddPoint(0.5, 0.9);
  model.Opacity->AddPoint(0.6, 0.0);
  model.Opacity->AddPoint(1.0, 0.8);
  model.UnitDistance = shot.UnitDistance;
  return model;
}

// The same grid with its points in world coordinates.
Grid inWorld(const Shot& shot)
{
  const Grid world = withOffsetAndScale(shot.Data, { 0.0, 0.0, 0.0 }, 1.0);
  for (vtkIdType i = 0; i < world->GetNumberOfPoints(); ++i)
  {
    double p[3];
    world->GetPoint(i, p);
    shot.Transform->TransformPoint(p, p);
    world->GetPoints()->SetPoint(i, p);
  }
  return world;
}

Image byOracle(const Shot& shot)
{
  const OracleScene oracle(inWorld(shot), modelOf(shot), shot.Scalars);
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(shot.Camera->GetCompositeProjectionTransformMatrix(1.0, -1.0, 1.0), inverse);
  const auto unproject = [&](double x, double y, double z)
  {
    const double in[4] = { x, y, z, 1.0 };
    double out[4];
    inverse->MultiplyPoint(in, out);
    return Vec3{ out[0] / out[3], out[1] / out[3], out[2] / out[3] };
  };
  Image image(Size, Size);
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const double depth = shot.Depths.empty() ? 1.0 : double(shot.Depths[y * Size + x]);
      const double sx = (x + 0.5) / Size * 2.0 - 1.0, sy = (y + 0.5) / Size * 2.0 - 1.0;
      const Vec3 from = unproject(sx, sy, -1.0);
      const Vec3 to = unproject(sx, sy, 2.0 * depth - 1.0);
      const Vec3 d{ to[0] - from[0], to[1] - from[1], to[2] - from[2] };
      const double far = std::hypot(d[0], d[1], d[2]);
      const auto rgba = far > 0.0 ? oracle.integrate(from, d, 0.0, far) : std::array<double, 4>{};
      for (int k = 0; k < 4; ++k)
      {
        image.pixel(x, y)[k] = static_cast<float>(rgba[k]);
      }
    }
  }
  return image;
}

template <typename Real>
Image byTwin(const Shot& shot, const AccuracyLevel& level, MarchCounters& counters)
{
  TetMesh mesh = builtWithHierarchy(shot.Data);
  std::vector<float> cellScalars;
  ReferenceScene scene;
  if (shot.Scalars == ScalarsOf::Points)
  {
    scene.Range = setPointScalars(shot.Data, shot.Data->GetPointData()->GetScalars(), mesh);
  }
  else
  {
    scene.Range = makeCellScalars(shot.Data->GetCellData()->GetScalars(), mesh, cellScalars);
    scene.CellScalars = &cellScalars;
  }
  const OpticalModel model = modelOf(shot);
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(model.Colour);
  property->SetScalarOpacity(model.Opacity);
  const IntegralTable table =
    makeIntegralTable(sampleFunctions(property, tetmarch::OpacityLaw::Unstructured, scene.Range.Low,
      scene.Range.High, samplesOfTable(level.TableEntries)));

  vtkNew<WindowlessRenderer> renderer;
  renderer->SetActiveCamera(shot.Camera);
  vtkNew<vtkVolume> volume;
  volume->SetUserTransform(shot.Transform);
  EXPECT_TRUE(makeView(renderer, volume, mesh, shot.UnitDistance, scene.Camera));
  scene.Mesh = &mesh;
  scene.Table = &table;
  scene.Width = Size;
  scene.Height = Size;
  scene.WindowDepths = shot.Depths.empty() ? nullptr : shot.Depths.data();
  const ReferenceImage image = renderReference<Real>(scene, level);
  counters = image.Counters;
  return Image::fromFloats(Size, Size, image.Pixels.data());
}

template <typename Real>
void expectImage(const Image& oracle, const Shot& shot, const AccuracyLevel& level, double bound)
{
  MarchCounters counters;
  const Difference difference = compare(byTwin<Real>(shot, level, counters), oracle);
  EXPECT_LE(difference.Max, bound) << difference.text();
  EXPECT_GT(counters.Rays, Size * Size / 20);
  EXPECT_GE(counters.Evaluations, 0);
  EXPECT_EQ(counters.Refused + counters.Lost + counters.Guarded, 0);
  const std::string name = std::is_same<Real, float>::value ? "float" : "double";
  ::testing::Test::RecordProperty(
    name + std::to_string(level.TableEntries), std::to_string(difference.Max * 255.0));
}

// What the levels promise: 1/255, and 1e-4 for comparisons.
void expectDefault(const Shot& shot)
{
  const Image oracle = byOracle(shot);
  expectImage<float>(oracle, shot, DefaultAccuracy, 1.0 / 255.0);
  expectImage<double>(oracle, shot, DefaultAccuracy, 1.0 / 255.0);
}

void expectReference(const Shot& shot)
{
  expectImage<double>(byOracle(shot), shot, ReferenceAccuracy, 1e-4);
}

void expectShot(const Shot& shot)
{
  expectDefault(shot);
  expectReference(shot);
}

TEST(ReferenceImage, Perspective) { expectShot(Shot()); }

TEST(ReferenceImage, Parallel)
{
  Shot shot;
  shot.Camera->ParallelProjectionOn();
  shot.Camera->SetParallelScale(0.9);
  expectShot(shot);
}

TEST(ReferenceImage, Thick)
{
  Shot shot;
  shot.UnitDistance = 0.03;
  expectDefault(shot);
}

// Off until MOST_TRIALS belongs to the level: see SegmentTest.cxx.
TEST(ReferenceImage, DISABLED_ThickReference)
{
  Shot shot;
  shot.UnitDistance = 0.03;
  expectReference(shot);
}

TEST(ReferenceImage, HoleAndTwoComponents)
{
  Shot hole;
  hole.Data = latticeWithHole(6, 0.15, 1, sineField());
  expectShot(hole);
  Shot two;
  two.Data = twoComponents(4, 0.15, 1, sineField());
  two.Camera->SetPosition(4.0, 1.0, 2.0);
  expectShot(two);
}

TEST(ReferenceImage, CellScalars)
{
  Shot shot;
  shot.Scalars = ScalarsOf::Cells;
  expectShot(shot);
}

TEST(ReferenceImage, MirroredAndNonUniform)
{
  Shot mirrored;
  mirrored.Transform->Scale(-1.0, 1.0, 1.0);
  mirrored.Transform->Translate(-1.0, 0.0, 0.0);
  expectShot(mirrored);
  Shot stretched;
  stretched.Transform->Translate(0.2, 0.3, -0.1);
  stretched.Transform->RotateWXYZ(35.0, 1.0, 2.0, 3.0);
  stretched.Transform->Scale(0.5, 1.7, -0.8);
  expectShot(stretched);
}

TEST(ReferenceImage, CameraInside)
{
  Shot shot;
  shot.Camera->SetPosition(0.31, 0.42, 0.57);
  shot.Camera->SetFocalPoint(1.0, 0.6, 0.4);
  shot.Camera->SetClippingRange(0.01, 5.0);
  expectShot(shot);
}

TEST(ReferenceImage, NearAndFarPlaneCut)
{
  Shot shot;
  shot.Camera->SetClippingRange(2.7, 3.4);
  expectShot(shot);
}

TEST(ReferenceImage, OpaqueDepthsCutInsideCells)
{
  for (const bool parallel : { false, true })
  {
    Shot shot;
    shot.Camera->SetParallelProjection(parallel);
    shot.Camera->SetParallelScale(0.9);
    shot.Camera->SetClippingRange(1.5, 5.0);
    for (int i = 0; i < Size * Size; ++i)
    {
      // From before the mesh to behind it.
      const double wave = 0.5 + 0.5 * std::sin(0.37 * (i % Size)) * std::cos(0.23 * (i / Size));
      const double z = 1.6 + 3.3 * wave;
      shot.Depths.push_back(static_cast<float>(
        parallel ? (z - 1.5) / 3.5 : (1.0 / 1.5 - 1.0 / z) / (1.0 / 1.5 - 1.0 / 5.0)));
    }
    expectShot(shot);
  }
}

TEST(ReferenceImage, FarAwayMesh)
{
  Shot shot;
  shot.Data = withOffsetAndScale(shot.Data, { 1e6, -2e6, 3e6 }, 1.0);
  shot.Transform->Translate(-1e6, 2e6, -3e6);
  expectShot(shot);
}

TEST(View, SingularMatricesShowNothing)
{
  const TetMesh mesh = built(singleTet());
  vtkNew<WindowlessRenderer> renderer;
  vtkNew<vtkCamera> camera;
  renderer->SetActiveCamera(camera);
  vtkNew<vtkVolume> volume;
  vtkNew<vtkTransform> flat;
  flat->Scale(1.0, 0.0, 1.0);
  volume->SetUserTransform(flat);
  View view;
  EXPECT_FALSE(makeView(renderer, volume, mesh, 1.0, view));
}
} // namespace
