// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Isosurfaces against the polygons that VTK makes of the same grid, and in a light whose answer is
// known.
#include "BlendScene.h"

#include "vtkActor.h"
#include "vtkContourFilter.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;

constexpr std::array<double, 3> Orange{ { 1.0, 0.6, 0.2 } };

vtkSmartPointer<vtkActor> contourOf(vtkUnstructuredGrid* grid, double value)
{
  vtkNew<vtkContourFilter> contour;
  contour->SetInputData(grid);
  contour->SetValue(0, value);
  contour->Update();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(contour->GetOutput());
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(Orange[0], Orange[1], Orange[2]);
  actor->GetProperty()->LightingOff();
  return actor;
}

// Without light the pixels are those of the polygons, but for pixels on an edge of a polygon.
TEST(BlendSurface, AsPolygons)
{
  for (const double value : { 0.4, 0.55 })
  {
    BlendScene scene(jitteredLattice(12, 0.15, 1, sineField()));
    setPlainFunctions(scene.property(), Orange, 1.0);
    scene.property()->ShadeOff();
    scene.setSurfaces({ value });
    scene.Mapper->SetBlendModeToIsoSurface();
    scene.render();
    const Image ours = scene.frame();
    scene.Volume->VisibilityOff();
    scene.Renderer->AddActor(contourOf(scene.Data, value));
    scene.Window->Render();
    const Image polygons = scene.frame();
    const Difference difference = compare(ours, polygons, {}, 2.0 / 255.0, Channels::Rgb);
    const float black[3] = { 0, 0, 0 };
    const Mask seen = differsFrom(polygons, black, 0.1f);
    const auto covered = static_cast<std::size_t>(std::count(seen.begin(), seen.end(), true));
    std::cout << "[ MEASURED ] " << difference.Over << " pixels differ, of " << covered
              << " that the surface covers\n";
    EXPECT_GT(covered, 3000u);
    EXPECT_LT(difference.Over * 100, covered);
  }
}

// In parallel projection all of a plane x = const is seen at the same angle.
TEST(BlendSurface, APlaneInAHeadlight)
{
  for (const bool ofCells : { false, true })
  {
    Scene scene(jitteredLattice(
      ofCells ? 16 : 7, ofCells ? 0.0 : 0.15, 1, [](double x, double, double) { return x; }));
    if (ofCells)
    {
      scene.drawCellScalars();
    }
    setPlainFunctions(scene.property(), Orange, 0.75);
    vtkVolumeProperty* property = scene.property();
    property->ShadeOn();
    property->SetAmbient(0.2);
    property->SetDiffuse(0.7);
    property->SetSpecular(0.0);
    property->GetIsoSurfaceValues()->SetValue(0, 0.5);
    scene.Mapper->SetBlendModeToIsoSurface();
    scene.camera()->ParallelProjectionOn();
    scene.camera()->SetParallelScale(0.2);
    const Image drawn = scene.render();
    const double* towards = scene.camera()->GetDirectionOfProjection();
    const double lit = 0.2 + 0.7 * std::abs(towards[0]);
    // Gradients of cells' scalars are fitted, which the border of the mesh disturbs.
    const double bound = ofCells ? 0.02 : 1e-4;
    for (int y = 0; y < SceneSize; y += 7)
    {
      for (int x = 0; x < SceneSize; x += 7)
      {
        const float* pixel = drawn.pixel(x, y);
        ASSERT_NEAR(double(pixel[3]), 0.75, 1e-5);
        for (int k = 0; k < 3; ++k)
        {
          ASSERT_NEAR(double(pixel[k]), 0.75 * Orange[k] * lit, bound);
        }
      }
    }
  }
}
} // namespace
