// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Several components as VTK's mappers have them, where their laws agree with ours:
//  - red, green, blue and opacity by vtkProjectedTetrahedraMapper, whose fourth component is the
//    opacity itself, as by an opacity function that is a straight line here; it may be as far off
//    as of one scalar (RivalPictureTest), for it misorders cells and keeps colours in 8 bits;
//  - the same, and independent components, by VTK's ray caster for unstructured grids, with partial
//    pre-integration (Moreland and Angel 2004), which knows no weights, and kinks of opacity
//    functions only where colour functions have a node, too; its pictures are off by half a pixel;
//  - independent components by vtkGPUVolumeRayCastMapper of an image, where no two are seen in one
//    place. Where they are, it absorbs sum(a_i^2) / sum(a_i) of the opacities a_i and sends out
//    sum(a_i c_i): more than it absorbs, so that two mixed fogs get brighter than either.
#include "ComponentScene.h"
#include "RivalImage.h"

#include "vtkAutoInit.h"
#include "vtkDataArray.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkProjectedTetrahedraMapper.h"
#include "vtkUnstructuredGridPartialPreIntegration.h"
#include "vtkUnstructuredGridVolumeRayCastMapper.h"

#include <gtest/gtest.h>
#include <iostream>

VTK_MODULE_INIT(vtkRenderingVolumeOpenGL2);

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 96;

Image pictureBy(Scene& scene, vtkAbstractVolumeMapper* mapper)
{
  scene.Volume->SetMapper(mapper);
  scene.Window->Render();
  const Image frame = scene.frame();
  scene.Volume->SetMapper(scene.Mapper);
  return frame;
}

// Red for green, and green for blue.
Image recoloured(Image image)
{
  for (std::size_t i = 0; i < image.Rgba.size(); i += 4)
  {
    std::swap(image.Rgba[i], image.Rgba[i + 2]);
    std::swap(image.Rgba[i], image.Rgba[i + 1]);
  }
  return image;
}

// As if rays went through the lower left corners of pixels.
Image throughCorners(const Image& image)
{
  Image moved = image;
  for (int y = 1; y < image.Height; ++y)
  {
    for (int x = 1; x < image.Width; ++x)
    {
      for (int k = 0; k < 4; ++k)
      {
        moved.pixel(x, y)[k] = 0.25f * (image.pixel(x, y)[k] + image.pixel(x - 1, y)[k] +
                                         image.pixel(x, y - 1)[k] + image.pixel(x - 1, y - 1)[k]);
      }
    }
  }
  return moved;
}

enum class RaysThrough
{
  Centers,
  Corners
};

// mostRms, in 1/255: how far the rival may be off from us.
void expectSame(Scene& scene, vtkAbstractVolumeMapper* rivalMapper, double mostRms,
  RaysThrough rays = RaysThrough::Centers)
{
  const Image rival = pictureBy(scene, rivalMapper);
  scene.Window->Render();
  const Image frame = scene.frame();
  const Image ours = rays == RaysThrough::Corners ? throughCorners(frame) : frame;
  const float black[3] = { 0, 0, 0 };
  const Mask seen = differsFrom(ours, black, 0.02f);
  const auto apart = [&](const Image& image)
  { return 255.0 * compare(image, rival, seen, 0.0, Channels::Rgb).Rms; };
  std::cout << "[ MEASURED ] RMS " << apart(ours) << "/255, in other colours "
            << apart(recoloured(ours)) << "/255\n";
  EXPECT_LE(apart(ours), mostRms);
  EXPECT_GE(apart(recoloured(ours)), 3 * apart(ours));
  EXPECT_GT(apart(recoloured(ours)), mostRms);
}

std::vector<Field> fields(int count)
{
  const std::vector<Field> all{ linearField(), sineField(0.5),
    [](double x, double, double) { return 0.5 * x; }, sineField(0.6) };
  return { all.begin(), all.begin() + count };
}

class DirectColorRival : public ::testing::Test
{
protected:
  static Grid grid(int type)
  {
    return withComponents(jitteredLattice(10, 0.15, 1), fields(4), type);
  }
  void prepare(Scene& scene, double most)
  {
    scene.property()->IndependentComponentsOff();
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddSegment(0.0, 0.0, most, 1.0);
    scene.property()->SetScalarOpacity(opacity);
  }
};

TEST_F(DirectColorRival, ProjectedTetrahedra)
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_FLOAT })
  {
    for (const double unitDistance : { 0.25, 2.0 })
    {
      Scene scene(grid(type), Side, Side);
      this->prepare(scene, type == VTK_FLOAT ? 1.0 : 255.0);
      scene.property()->SetScalarOpacityUnitDistance(unitDistance);
      vtkNew<vtkProjectedTetrahedraMapper> rival;
      rival->SetInputData(scene.Data);
      expectSame(scene, rival, unitDistance < 1.0 ? 12.0 : 6.0);
    }
  }
}

class RayCastRival : public vtkUnstructuredGridVolumeRayCastMapper
{
public:
  static RayCastRival* New();
  vtkTypeMacro(RayCastRival, vtkUnstructuredGridVolumeRayCastMapper);
  RayCastRival()
  {
    vtkNew<vtkUnstructuredGridPartialPreIntegration> integrator;
    this->SetRayIntegrator(integrator);
    this->SetAutoAdjustSampleDistances(0);
    this->SetImageSampleDistance(1.0f);
  }
};
vtkStandardNewMacro(RayCastRival);

TEST_F(DirectColorRival, RayCaster)
{
  Scene scene(grid(VTK_FLOAT), Side, Side);
  this->prepare(scene, 1.0);
  vtkNew<RayCastRival> rival;
  rival->SetInputData(scene.Data);
  expectSame(scene, rival, 3.0, RaysThrough::Corners);
}

TEST(IndependentRival, RayCaster)
{
  Scene scene(withComponents(jitteredLattice(8, 0.15, 1), fields(2), VTK_DOUBLE), Side, Side);
  scene.Mapper->SetVectorModeToAllComponents();
  setComponentFunctions(scene.property(), 2);
  for (int k = 0; k < 2; ++k)
  {
    vtkNew<vtkColorTransferFunction> color;
    vtkNew<vtkPiecewiseFunction> opacity;
    for (int i = 0; i < 3; ++i)
    {
      color->AddRGBPoint(0.5 * i, k, i == 1 ? 0.8 : 0.2, 1 - k);
      opacity->AddPoint(0.5 * i, i == 1 ? 0.1 + 0.5 * k : 0.6 - 0.4 * k);
    }
    scene.property()->SetColor(k, color);
    scene.property()->SetScalarOpacity(k, opacity);
    scene.property()->SetComponentWeight(k, 1.0);
  }
  vtkNew<RayCastRival> rival;
  rival->SetInputData(scene.Data);
  expectSame(scene, rival, 3.0, RaysThrough::Corners);
}

TEST(IndependentRival, ImageCasterWhereComponentsAreApart)
{
  // Each is seen in its half of the cube alone; both grids have points where they change.
  const std::vector<Field> halves{ [](double x, double, double)
    { return std::max(0.0, 1.0 - 2.0 * x); },
    [](double x, double, double) { return std::max(0.0, 2.0 * x - 1.0); } };
  constexpr int Points = 65;
  Scene scene(withComponents(jitteredLattice(16, 0.0), halves, VTK_FLOAT), Side, Side);
  scene.Mapper->SetVectorModeToAllComponents();
  scene.Mapper->SetOpacityLawToStructured();
  const double colors[2][3] = { { 0.9, 0.3, 0.1 }, { 0.1, 0.6, 1.0 } };
  for (int k = 0; k < 2; ++k)
  {
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(0.0, colors[k][0], colors[k][1], colors[k][2]);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddSegment(0.0, 0.0, 1.0, 0.5 + 0.3 * k);
    scene.property()->SetColor(k, color);
    scene.property()->SetScalarOpacity(k, opacity);
    scene.property()->SetScalarOpacityUnitDistance(k, 0.25);
  }
  scene.property()->SetInterpolationTypeToLinear();
  auto image = makeImage(Points, halves[0]);
  auto second = makeImage(Points, halves[1]);
  vtkNew<vtkFloatArray> both;
  both->SetNumberOfComponents(2);
  both->SetNumberOfTuples(image->GetNumberOfPoints());
  both->CopyComponent(0, image->GetPointData()->GetScalars(), 0);
  both->CopyComponent(1, second->GetPointData()->GetScalars(), 0);
  image->GetPointData()->SetScalars(both);
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> rival;
  rival->SetInputData(image);
  rival->SetAutoAdjustSampleDistances(0);
  rival->SetSampleDistance(0.002f);
  expectSame(scene, rival, 1.0);
}
} // namespace
