// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws of several components of an image or a rectilinear grid, pixel by pixel against
// the CPU reference.
#include "StructuredComponents.h"

#include "vtkDataArray.h"

namespace
{
using namespace tetmarch::testing;

class StructuredComponents : public ComponentsTest
{
};

TEST_P(StructuredComponents, ImagesAndGrids)
{
  const auto image = imageWith(wavy(), 9, VTK_DOUBLE);
  const auto grid = rectilinearOf(constantField(0.0), unevenCube(8));
  setComponents(grid, wavy(), VTK_FLOAT);
  for (vtkDataSet* data : { static_cast<vtkDataSet*>(image), static_cast<vtkDataSet*>(grid) })
  {
    StructuredScene scene(data);
    setFunctions(scene);
    expectParityOf(
      AllLatticeValues, scene, std::string(GetParam().Name) + ", " + data->GetClassName());
  }
}

TEST_P(StructuredComponents, ScatteredThinAndThick)
{
  const auto image = imageWith(scatteredFields(GetParam().Components), 8, VTK_DOUBLE);
  StructuredScene scene(image);
  setFunctions(scene);
  for (const double unit : { 0.02, 0.25, 5.0 })
  {
    scene.property()->SetScalarOpacityUnitDistance(unit);
    report("scattered, unit " + std::to_string(unit), expectParity(scene));
  }
  scene.Mapper->SetOpacityLawToUnstructured();
  report("the other law", expectParity(scene));
  scene.property()->SetScalarOpacityUnitDistance(1e-9); // beyond the range of float
  const Image opaque = scene.render();
  EXPECT_GT(compare(opaque, Image(opaque.Width, opaque.Height)).Max, 0.2);
}

TEST_P(StructuredComponents, BytesAndWords)
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_SHORT })
  {
    const auto image = imageWith(wavy(), 7, type);
    StructuredScene scene(image);
    setFunctions(scene);
    for (int k = 0; k < GetParam().Components; ++k)
    {
      vtkNew<vtkColorTransferFunction> colours;
      vtkNew<vtkPiecewiseFunction> opacities;
      colours->AddRGBPoint(0.0, 0.2 * k, 0.9, 0.1);
      colours->AddRGBPoint(255.0, 0.9, 0.1, 1.0 - 0.2 * k);
      opacities->AddPoint(0.0, 0.1);
      opacities->AddPoint(130.0 + 20.0 * k, 0.8);
      opacities->AddPoint(255.0, 0.2);
      scene.property()->SetColor(k, colours);
      scene.property()->SetScalarOpacity(k, opacities);
    }
    expectParityOf({ LatticeValues::PointsLinear, LatticeValues::CellsNearest }, scene,
      image->GetPointData()->GetScalars()->GetDataTypeAsString());
  }
}

// Most of the volume is transparent, and rays leap over it: of independent components only where
// none of them shows anything.
TEST_P(StructuredComponents, MuchEmptySpace)
{
  const auto image = imageWith(wavy(), 36, VTK_FLOAT);
  StructuredScene scene(image);
  setFunctions(scene);
  for (int k = 0; k < GetParam().Components; ++k)
  {
    vtkPiecewiseFunction* opacity = scene.property()->GetScalarOpacity(k);
    opacity->RemoveAllPoints();
    opacity->AddPoint(0.8 + 0.02 * k, 0.0);
    opacity->AddPoint(0.85 + 0.02 * k, 0.9);
  }
  report(std::string(GetParam().Name) + ", empty space", expectParity(scene));
}

INSTANTIATE_TEST_SUITE_P(Of, StructuredComponents, testing::ValuesIn(Mixes),
  [](const auto& of) { return std::string(of.param.Name); });

} // namespace
