// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// After VTK's TestGPURayCastDepthPeeling, its variants Opaque, TransVol, TransparentPolyData,
// BlendModes, BoxWidget, Clip and MultiViewport, and TestGPURayCastCellData: the same scene with
// VTK's mapper of the image, which is peeled by the same pass.
#include "VtkScene.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPlanes.h"
#include "vtkPointData.h"
#include "vtkPointDataToCellData.h"
#include "vtkProperty.h"
#include "vtkVersionMacros.h"

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 120;

void peel(vtkRenderer* renderer)
{
  renderer->UseDepthPeelingOn();
  renderer->UseDepthPeelingForVolumesOn();
  renderer->SetMaximumNumberOfPeels(17);
  renderer->SetOcclusionRatio(0.0);
}

vtkSmartPointer<vtkActor> makeGlass(
  const Vec3& centre, double radius, const std::array<double, 3>& colour, double opacity)
{
  const auto ball = makeBall(centre, radius, colour);
  ball->GetProperty()->SetOpacity(opacity);
  return ball;
}

class PeeledScene : public testing::Test
{
protected:
  PeeledScene()
  {
    this->Shown.Window->AlphaBitPlanesOn();
    this->Shown.Mapper->SetOpacityLawToStructured();
    setFunctions(this->Shown.property(), 50.0, 255.0, 0.9);
    this->Shown.property()->SetScalarOpacityUnitDistance(1.0);
    peel(this->Shown.Renderer);
    this->Shown.camera()->SetPosition(10.0, 10.0, 60.0);
    this->Shown.camera()->SetFocalPoint(10.0, 10.0, 10.0);
    this->Shown.camera()->SetViewUp(0.0, 1.0, 0.0);
    this->Shown.Renderer->ResetCamera();
    this->Shown.camera()->Azimuth(-55.0);
    this->Shown.camera()->Elevation(35.0);
    this->Shown.camera()->OrthogonalizeViewUp();
    this->Shown.Renderer->ResetCameraClippingRange();
  }

  // Two balls, each partly in the shell.
  void addBalls(double first, double second)
  {
    this->Shown.Renderer->AddActor(makeGlass({ 10.0, 10.0, 10.0 }, 7.0, { 0.5, 0.9, 0.7 }, first));
    this->Shown.Renderer->AddActor(makeGlass({ 14.5, 14.5, 14.5 }, 7.0, { 0.9, 0.4, 0.1 }, second));
  }

  vtkSmartPointer<vtkImageData> Shell = makeShell();
  Scene Shown{ tetrahedraOf(this->Shell), Side, Side };
  vtkSmartPointer<vtkGPUVolumeRayCastMapper> Rival = makeImageMapper(this->Shell, 0.05);
};

TEST_F(PeeledScene, TwoGlasses)
{
  this->addBalls(0.3, 0.3);
  expectLike(this->Shown, this->Rival, 4.0);
}

TEST_F(PeeledScene, TwoGlassesInLight)
{
  this->addBalls(0.3, 0.3);
  this->Shown.property()->ShadeOn();
  this->Shown.property()->SetSpecular(0.0); // before VTK 9.2 not as ours
  expectLike(this->Shown, this->Rival, 3.0);
}

TEST_F(PeeledScene, AGlassAndAnOpaqueBall)
{
  this->addBalls(0.3, 1.0);
  expectLike(this->Shown, this->Rival, 4.0);
}

TEST_F(PeeledScene, AThinVolume)
{
  this->Shown.Renderer->SetBackground(1.0, 1.0, 1.0);
  setFunctions(this->Shown.property(), 50.0, 255.0, 0.06);
  this->addBalls(0.3, 0.3);
  expectLike(this->Shown, this->Rival, 2.0);
}

// Surfaces that are peeled and seen nowhere change nothing but roundings of bytes.
TEST_F(PeeledScene, InvisibleSurfaces)
{
  setFunctions(this->Shown.property(), 50.0, 255.0, 0.1);
  this->Shown.Window->Render();
  const Image alone = this->Shown.frame();
  this->addBalls(0.0, 0.0);
  this->Shown.Window->Render();
  expectSame(this->Shown.frame(), alone, 5.0 / 255.0);
}

// The image mapper cuts where clipping planes are; see forImageMapper().
constexpr bool PlanesAreCut = VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0);

TEST_F(PeeledScene, ByAPlaneAndInABox)
{
  this->addBalls(0.3, 0.3);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(10.0, 10.0, 10.0);
  plane->SetNormal(0.6, -0.2, 0.4);
  this->Shown.Mapper->AddClippingPlane(plane);
  this->Rival->AddClippingPlane(plane);
  expectLike(this->Shown, this->Rival, 4.0, "plane");
  vtkNew<vtkPlanes> box;
  box->SetBounds(3.0, 16.0, 5.0, 18.0, 2.0, 15.0);
  vtkNew<vtkPlaneCollection> ours, rivals;
  for (int i = 0; i < 6; ++i)
  {
    // Those of a box look outwards.
    vtkNew<vtkPlane> side, moved;
    box->GetPlane(i, side);
    const double* n = side->GetNormal();
    side->SetNormal(-n[0], -n[1], -n[2]);
    moved->SetNormal(side->GetNormal());
    const double* o = side->GetOrigin();
    const Vec3 at{ o[0], o[1], o[2] };
    moved->SetOrigin((PlanesAreCut ? at : forImageMapper(this->Shell, at)).data());
    ours->AddItem(side);
    rivals->AddItem(moved);
  }
  this->Shown.Mapper->SetClippingPlanes(ours);
  this->Rival->SetClippingPlanes(rivals);
  expectLike(this->Shown, this->Rival, 5.0, "box");
}

// Each part between surfaces is blended by itself: VTK calls that locally correct.
TEST_F(PeeledScene, BlendModes)
{
  this->Shown.Renderer->SetBackground(0.3, 0.3, 0.3);
  setFunctions(this->Shown.property(), 0.0, 255.0, 0.8);
  this->Shown.Renderer->AddActor(makeGlass({ 16.0, 16.0, 4.0 }, 6.0, { 1.0, 0.9, 1.0 }, 0.4));
  for (const auto& [mode, mostRms] : { std::pair(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, 4.0),
         std::pair(vtkVolumeMapper::MINIMUM_INTENSITY_BLEND, 2.0) })
  {
    this->Shown.Mapper->SetBlendMode(mode);
    this->Rival->SetBlendMode(mode);
    expectLike(this->Shown, this->Rival, mostRms, this->Shown.Mapper->GetBlendModeAsString());
  }
}

// Beside it a viewport without peels, of the same volume.
TEST_F(PeeledScene, CellScalarsInTwoViewports)
{
  vtkNew<vtkPointDataToCellData> toCells;
  toCells->SetInputData(this->Shell);
  toCells->Update();
  auto* image = vtkImageData::SafeDownCast(toCells->GetOutput());
  image->GetCellData()->SetActiveScalars("shell");
  image->GetPointData()->Initialize();
  const Grid grid = tetrahedraOf(image);
  grid->GetCellData()->SetActiveScalars("shell");
  Scene& scene = this->Shown;
  scene.Mapper->SetInputData(grid);
  scene.Mapper->SetScalarModeToUseCellData();
  scene.property()->SetInterpolationTypeToNearest();
  this->Rival->SetInputData(image);
  this->Rival->SetScalarModeToUseCellData();
  this->addBalls(0.4, 0.4);
  scene.Window->SetSize(2 * Side, Side);
  vtkNew<vtkRenderer> plain;
  plain->SetViewport(0.0, 0.0, 0.5, 1.0);
  plain->SetActiveCamera(scene.camera());
  plain->AddVolume(scene.Volume);
  scene.Window->AddRenderer(plain);
  scene.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  expectLike(scene, this->Rival, 3.0);
  EXPECT_EQ(scene.Mapper->GetMeshBuilds(), 1);
}

// Four viewports share a volume, but for one with a large opaque ball at the window's origin: that
// must not cut what the others show (in VTK's mapper it once did).
TEST_F(PeeledScene, FourViewports)
{
  const double radii[] = { 7.0, 4.0, 5.0, 6.0 };
  const auto addRenderer = [&](vtkRenderWindow* window, int i)
  {
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(0.1 * i, 0.1, 0.2);
    if (i != 0)
    {
      renderer->AddVolume(this->Shown.Volume);
    }
    renderer->AddActor(makeGlass({ 10.0 + 2.0 * i, 10.0 - i, 10.0 }, radii[i],
      { i == 1 ? 1.0 : 0.2, i == 2 ? 1.0 : 0.1, 0.9 }, i < 2 ? 1.0 : 0.3));
    peel(renderer);
    renderer->SetActiveCamera(this->Shown.camera());
    window->AddRenderer(renderer);
    return vtkSmartPointer<vtkRenderer>(renderer);
  };
  const auto four = makeWindow(2 * Side, 2 * Side);
  four->AlphaBitPlanesOn();
  for (int i = 0; i < 4; ++i)
  {
    const double x = 0.5 * (i % 2), y = 0.5 * (i / 2);
    addRenderer(four, i)->SetViewport(x, y, x + 0.5, y + 0.5);
  }
  four->Render();
  const Image together = framePictureOf(four);
  for (int i = 0; i < 4; ++i)
  {
    const auto single = makeWindow(Side, Side);
    single->AlphaBitPlanesOn();
    addRenderer(single, i);
    single->Render();
    expectSame(cropped(together, Side * (i % 2), Side * (i / 2), Side, Side),
      framePictureOf(single), 1.001 / 255.0, "viewport " + std::to_string(i));
  }
}
} // namespace
