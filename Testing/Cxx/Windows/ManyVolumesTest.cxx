// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Several volumes in one renderer. VTK draws each over what is there, in the order of their
// addition or, if the renderer's culler is told to sort, by the distance of the centres of their
// bounds, the farthest first.
#include "BlendedFrame.h"

#include "vtkCullerCollection.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkRenderStepsPass.h"

#include <algorithm>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 120;
constexpr double Background[] = { 0.2, 0.4, 0.6 };

class ManyVolumes : public testing::Test
{
protected:
  struct Member
  {
    vtkNew<vtkVolume> Volume;
    vtkNew<vtkTetMarchVolumeMapper> Mapper;
    Image picture() const { return floatPictureOf(this->Mapper, Side, Side); }
  };

  // One unit cube behind the other along z, with meshes, scalars and colours of their own, the
  // middle one first.
  ManyVolumes()
  {
    this->Renderer->SetBackground(Background[0], Background[1], Background[2]);
    this->Window->AddRenderer(this->Renderer);
    const Grid grids[] = { jitteredLattice(5, 0.15, 1, sineField()),
      mixedCells(4, 1, 0.1, radialField()), latticeWithHole(6, 0.15, 2, linearField()) };
    const double heights[] = { 0.0, -1.3, 1.3 };
    for (int i = 0; i < 3; ++i)
    {
      Member& member = this->Members[i];
      member.Mapper->SetInputData(grids[i]);
      member.Mapper->CollectDiagnosticsOn();
      member.Volume->SetMapper(member.Mapper);
      vtkVolumeProperty* property = member.Volume->GetProperty();
      i == 1 ? setPlainFunctions(property, { 1.0, 0.3, 0.9 }, 0.5) : setBumpyFunctions(property);
      property->SetScalarOpacityUnitDistance(0.4 + 0.2 * i);
      member.Volume->SetPosition(0.0, 0.0, heights[i]);
    }
    // Scalars of cells beside those of points.
    this->Members[2].Mapper->SetScalarModeToUseCellFieldData();
    this->Members[2].Mapper->SelectScalarArray("c");
  }

  void show(int count)
  {
    for (int i = 0; i < count; ++i)
    {
      this->Renderer->AddVolume(this->Members[i].Volume);
    }
  }

  void sort()
  {
    auto* culler =
      vtkFrustumCoverageCuller::SafeDownCast(this->Renderer->GetCullers()->GetLastItem());
    ASSERT_NE(culler, nullptr);
    culler->SetSortingStyleToBackToFront();
  }

  // From the side where z is great, or from the other.
  void lookFrom(int side)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(1.5, 1.9, 0.5 + side * 5.5);
    camera->SetFocalPoint(0.5, 0.5, 0.5);
    camera->SetViewUp(0.1, 1.0, 0.0);
    camera->SetClippingRange(1.0, 12.0);
  }

  Image alone(int which)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Members[i].Volume->SetVisibility(i == which);
    }
    this->Window->Render();
    for (Member& member : this->Members)
    {
      member.Volume->VisibilityOn();
    }
    return this->Members[which].picture();
  }

  // The first is the farthest.
  static Image composed(const std::vector<Image>& pictures)
  {
    Image frame(Side, Side);
    for (std::size_t i = 0; i < frame.Rgba.size(); ++i)
    {
      frame.Rgba[i] = static_cast<float>(i % 4 < 3 ? Background[i % 4] : 0.0);
    }
    for (const Image& picture : pictures)
    {
      frame = over(picture, frame);
    }
    return frame;
  }

  // Each volume is drawn alone, and the frame must be these pictures blended in that order.
  void expectInOrder(const std::vector<int>& order)
  {
    std::vector<Image> pictures;
    for (const int which : order)
    {
      pictures.push_back(this->alone(which));
      EXPECT_GT(pictures.back().pixel(Side / 2, Side / 2)[3], 0.1f) << which;
    }
    this->Window->Render();
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      EXPECT_EQ(this->Members[order[i]].picture().Rgba, pictures[i].Rgba) << order[i];
    }
    const Image expected = composed(pictures);
    const double bound = double(order.size()) * OneBlend;
    expectSame(framePictureOf(this->Window), expected, bound, "in order");
    // Any other order gives another picture.
    std::reverse(pictures.begin(), pictures.end());
    EXPECT_GT(compare(composed(pictures), expected, {}, 0.0, Channels::Rgb).Max, 10.0 * bound);
  }

  vtkSmartPointer<vtkRenderWindow> Window = makeWindow(Side, Side);
  vtkNew<vtkRenderer> Renderer;
  Member Members[3];
};

TEST_F(ManyVolumes, TwoFromBothSides)
{
  this->show(2);
  this->sort();
  this->lookFrom(1);
  this->expectInOrder({ 1, 0 });
  this->lookFrom(-1);
  this->expectInOrder({ 0, 1 });
}

TEST_F(ManyVolumes, ThreeFromBothSides)
{
  this->show(3);
  this->sort();
  this->lookFrom(1);
  this->expectInOrder({ 1, 0, 2 });
  this->lookFrom(-1);
  this->expectInOrder({ 2, 0, 1 });
}

TEST_F(ManyVolumes, InOrderOfAdditionIfNotTold)
{
  this->show(3);
  for (const int side : { 1, -1 })
  {
    this->lookFrom(side);
    this->expectInOrder({ 0, 1, 2 });
  }
}

TEST_F(ManyVolumes, InARenderPass)
{
  this->show(3);
  this->sort();
  vtkNew<vtkRenderStepsPass> pass;
  this->Renderer->SetPass(pass);
  this->lookFrom(1);
  this->expectInOrder({ 1, 0, 2 });
  this->lookFrom(-1);
  this->expectInOrder({ 2, 0, 1 });
}
} // namespace
