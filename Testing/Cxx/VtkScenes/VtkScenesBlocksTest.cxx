// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// After VTK's TestMultiBlockUnstructuredGridVolumeMapper: a dented can above a plate, coloured by
// the velocity.
#include "VtkScene.h"

#include "ErrorWatch.h"
#include "GridBlocks.h"

#include "vtkDoubleArray.h"
#include "vtkMultiBlockUnstructuredGridVolumeMapper.h"
#include "vtkPointData.h"

#include <cmath>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 150;

// A block of tetrahedra with velocities at its points, which fall with the height.
Grid withVelocities(const Grid& grid, double speed)
{
  vtkNew<vtkDoubleArray> velocities;
  velocities->SetName("VEL");
  velocities->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double p[3];
    grid->GetPoint(i, p);
    velocities->InsertNextTuple3(
      speed * (1.0 - p[1]), 0.3 * speed * std::sin(3.0 * p[0]), speed * p[2] * p[2]);
  }
  grid->GetPointData()->AddArray(velocities);
  return grid;
}

TEST(MultiBlock, ACanAbovePlate)
{
  const Grid can = withVelocities(latticeWithTunnel(12, 0.15, 1, linearField()), 4000.0);
  const Grid plate = withVelocities(
    withOffsetAndScale(jitteredLattice(10, 0.15, 2, linearField()), { -0.1, -1.3, -0.1 }, 1.2),
    900.0);
  // VTK's mapper draws blocks in their order: what is farther comes first.
  const auto both = blocks({ plate, can });
  Scene scene(can, Side, Side);
  scene.Mapper->SetInputDataObject(both);
  scene.Mapper->SelectScalarArray("VEL");
  scene.Mapper->SetScalarModeToUsePointFieldData();
  scene.Renderer->SetBackground(1.0, 1.0, 1.0);
  const ErrorWatch watch(scene.Mapper);
  vtkNew<vtkColorTransferFunction> colours;
  colours->AddRGBPoint(40.0, 0.231, 0.298, 0.753);
  colours->AddRGBPoint(1000.0, 0.865, 0.865, 0.865);
  colours->AddRGBPoint(4000.0, 0.706, 0.016, 0.149);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(40.0, 0.3);
  opacities->AddPoint(5600.0, 0.9);
  scene.property()->SetColor(colours);
  scene.property()->SetScalarOpacity(opacities);
  scene.property()->SetScalarOpacityUnitDistance(0.4);
  vtkCamera* camera = scene.camera();
  camera->SetPosition(-4.1, 1.8, -3.4);
  camera->SetFocalPoint(0.5, -0.1, 0.5);
  camera->SetViewUp(0.248, 0.966, 0.066);
  camera->Azimuth(20.0);
  camera->Elevation(10.0);
  scene.Renderer->ResetCameraClippingRange();

  vtkNew<vtkMultiBlockUnstructuredGridVolumeMapper> rival;
  rival->SetInputDataObject(both);
  rival->SelectScalarArray("VEL");
  rival->SetScalarModeToUsePointFieldData();
  for (const int component : { 0, 2 })
  {
    colours->SetVectorModeToComponent();
    colours->SetVectorComponent(component);
    scene.render();
    expectReference(scene.Mapper, scene.Volume, Side, Side);
    expectLike(scene, rival, 4.0, "component " + std::to_string(component));
  }
  EXPECT_EQ(watch.Errors, std::vector<std::string>());
  EXPECT_EQ(watch.Warnings, std::vector<std::string>());
  EXPECT_EQ(
    scene.Mapper->GetNumberOfTetrahedra(), can->GetNumberOfCells() + plate->GetNumberOfCells());
}
} // namespace
