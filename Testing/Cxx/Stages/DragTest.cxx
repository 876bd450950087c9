// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// While somebody drags a point of the opacity function to and fro, no shader is compiled, and the
// picture is the same as by the shader that would be compiled.
#include "GLPointers.h"
#include "SmartScene.h"

#include "vtkPointData.h"

#include <gtest/gtest.h>
#include <random>

namespace
{
using namespace tetmarch::testing;

constexpr int Size = 48;

// Counts the programs that are linked, as long as it lives.
class LinkCount
{
public:
  LinkCount()
  {
    Links = 0;
    Link = TETMARCH_GL_POINTER(LinkProgram);
    TETMARCH_GL_POINTER(LinkProgram) = &link;
  }
  ~LinkCount() { TETMARCH_GL_POINTER(LinkProgram) = Link; }
  LinkCount(const LinkCount&) = delete;
  LinkCount& operator=(const LinkCount&) = delete;

  int count() const { return Links; }

private:
  static void GLAPIENTRY link(GLuint program)
  {
    ++Links;
    Link(program);
  }
  static PFNGLLINKPROGRAMPROC Link;
  static int Links;
};
PFNGLLINKPROGRAMPROC LinkCount::Link;
int LinkCount::Links;

// Nothing is seen up to a scalar.
void hideBelow(vtkVolumeProperty* property, double scalar)
{
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(scalar, 0.0);
  opacity->AddPoint(1.0, 0.9);
}

// The first place is where a way to pass what is hidden begins to be worth its cost; at the second
// one it would not be begun, but is no loss either.
template <typename AnyScene, typename Data>
void expectNoCompilation(Data* data, const std::array<double, 2>& places)
{
  const auto drawn = [](AnyScene& scene, double place)
  {
    hideBelow(scene.property(), place);
    scene.Window->Render();
    return framePictureOf(scene.Window);
  };
  AnyScene shown(data, Size, Size);
  shown.Mapper->CollectDiagnosticsOff();
  drawn(shown, places[0]);
  const LinkCount links;
  for (int i = 0; i < 8; ++i)
  {
    for (const double share : { 0.5, 1.0, 0.5, 0.0 })
    {
      drawn(shown, places[0] + share * (places[1] - places[0]));
    }
  }
  EXPECT_EQ(links.count(), 0);
  // Of new data what is not worth its cost is not kept: another shader draws the same picture.
  const Image dragged = drawn(shown, places[1]);
  vtkDataArray* scalars = data->GetPointData()->GetScalars();
  scalars->Modified();
  data->Modified();
  EXPECT_EQ(dragged.Rgba, drawn(shown, places[1]).Rgba);
  EXPECT_GT(links.count(), 0);
}

TEST(Drag, OverWhereRaysEnterWhatIsVisible)
{
  expectNoCompilation<Scene>(
    jitteredLattice(12, 0.1, 1, [](double x, double, double) { return x; }).Get(), { 0.3, 0.2 });
}

TEST(Drag, OverWhereHiddenCellsArePassed)
{
  const Grid grid = jitteredLattice(8, 0.15, 1, sineField());
  vtkDataArray* scalars = grid->GetPointData()->GetScalars();
  std::mt19937 random(1);
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    scalars->SetTuple1(i, static_cast<double>(random() % 1001) / 1000.0);
  }
  expectNoCompilation<Scene>(grid.Get(), { 0.55, 0.4 });
}

TEST(Drag, OverWhereRaysLeap)
{
  ImagePlace place = unitCube(1);
  place.Extent = { 0, 64, 0, 8, 0, 8 };
  place.Spacing = { 1.0 / 64, 1.0 / 8, 1.0 / 8 };
  const auto image = imageOf([](double x, double, double) { return x; }, place);
  expectNoCompilation<SmartScene>(image.Get(), { 0.14, 0.08 });
}
} // namespace
