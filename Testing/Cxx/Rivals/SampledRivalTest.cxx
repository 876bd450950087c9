// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The accuracy level Sampled against vtkGPUVolumeRayCastMapper, pixel by pixel: the same image of
// floats, functions, camera and distance, both drawn into a framebuffer of floats.
#include "../../Benchmark/FloatPicture.h"
#include "../../Benchmark/StructuredFunctions.h"
#include "RivalImage.h"
#include "SmartScene.h"

#include "vtkAutoInit.h"
#include "vtkGPUVolumeRayCastMapper.h"

#include <gtest/gtest.h>
#include <iostream>

VTK_MODULE_INIT(vtkRenderingVolumeOpenGL2);

namespace
{
using namespace tetmarch::testing;

constexpr int Cells = 40;
constexpr double Voxel = 1.0 / Cells;
constexpr double UnitDistance = 0.25;

class Rivals : public ::testing::Test
{
protected:
  Rivals()
    : Scene(makeImage(Cells + 1, waves), 120, 120)
  {
    this->Scene.Mapper->InteractiveAdjustSampleDistancesOff();
    this->Scene.Mapper->AutoAdjustSampleDistancesOff();
    this->Vtk->SetInputDataObject(this->Scene.Data);
    this->Vtk->AutoAdjustSampleDistancesOff();
    this->Vtk->LockSampleDistanceToInputSpacingOff();
  }

  // All of 0..1, in waves that a voxel resolves.
  static double waves(double x, double y, double z)
  {
    return 0.5 + 0.5 * std::sin(9.0 * x + 1.0) * std::sin(7.0 * y + 2.0) * std::cos(8.0 * z);
  }

  void useFunctions(const std::string& name, const tetmarch::bench::FunctionRange& range)
  {
    this->Scene.Volume->SetProperty(tetmarch::bench::makeStructuredFunctions(name, range));
  }

  Image drawnBy(vtkVolumeMapper* mapper)
  {
    this->Scene.Volume->SetMapper(mapper);
    return tetmarch::bench::drawInFloat(this->Scene.Window, this->Scene.Renderer).OnBlack;
  }
  Image vtks(double distance)
  {
    this->Vtk->SetSampleDistance(static_cast<float>(distance));
    return this->drawnBy(this->Vtk);
  }
  Image sampled(double distance)
  {
    this->Scene.Mapper->SetAccuracyLevelToSampled();
    this->Scene.Mapper->SetSampleDistance(static_cast<float>(distance));
    return this->drawnBy(this->Scene.Mapper);
  }
  Image exact()
  {
    this->Scene.Mapper->SetAccuracyLevelToAccurate();
    return this->drawnBy(this->Scene.Mapper);
  }

  // Pixels whose rays take several samples. VTK takes the only one of a ray along the edge of the
  // box behind the volume, where the texture goes on; ours is the last one in it.
  Mask inside(double distance)
  {
    vtkNew<vtkVolumeProperty> plain;
    setPlainFunctions(plain, { 1.0, 1.0, 1.0 }, 0.5);
    plain->SetScalarOpacityUnitDistance(0.5);
    this->Scene.Volume->SetProperty(plain);
    const Image image = this->sampled(distance);
    const double ofOne = 1.0 - std::pow(0.5, distance / 0.5);
    Mask mask;
    for (std::size_t i = 0; i < image.Rgba.size(); i += 4)
    {
      mask.push_back(double(image.Rgba[i]) > 1.5 * ofOne);
    }
    return mask;
  }

  SmartScene Scene;
  vtkNew<vtkGPUVolumeRayCastMapper> Vtk;
};

Difference colorsDiffer(const Image& a, const Image& b)
{
  return compare(a, b, silhouette(a, b), 2.0 / 255.0, Channels::Rgb);
}

struct Distances
{
  Difference FromVtk;   // of samples
  Difference OfSamples; // from the exact picture
  Difference OfVtk;
};

void report(const std::string& what, const Distances& found)
{
  std::cout << "[ MEASURED ] " << what << ", samples to VTK: " << found.FromVtk.text()
            << "\n[ MEASURED ]   samples to exact: " << found.OfSamples.text()
            << "\n[ MEASURED ]   VTK to exact: " << found.OfVtk.text() << '\n';
}

// One colour and opacity whatever the scalar: what differs is how many samples a ray has. A pixel
// on the edge of the box may be one more of either.
TEST_F(Rivals, TakeAsManySamples)
{
  setPlainFunctions(this->Scene.property(), { 0.9, 0.9, 0.9 }, 0.5);
  this->Scene.property()->SetScalarOpacityUnitDistance(0.5);
  for (const double distance : { 3 * Voxel, Voxel, 0.5 * Voxel })
  {
    const Difference difference =
      compare(this->sampled(distance), this->vtks(distance), {}, 1e-3, Channels::Rgb);
    std::cout << "[ MEASURED ] plain functions: " << difference.text() << '\n';
    EXPECT_LE(difference.Over, 3u);
    EXPECT_LE(difference.Percentile999, 1e-5);
  }
}

TEST_F(Rivals, AgreeFarBetterThanWithTheExactPicture)
{
  for (const std::string& name : tetmarch::bench::structuredFunctions())
  {
    this->useFunctions(name, { 0.0, 1.0, UnitDistance });
    const Image exact = this->exact();
    const bool narrow = name == "peaks";
    for (const double distance : { Voxel, 0.5 * Voxel })
    {
      SCOPED_TRACE(name + " at " + std::to_string(distance / Voxel));
      const Image ours = this->sampled(distance);
      const Image vtks = this->vtks(distance);
      const Distances found{ colorsDiffer(ours, vtks), colorsDiffer(ours, exact),
        colorsDiffer(vtks, exact) };
      report(name + " at " + std::to_string(distance / Voxel) + " voxel", found);
      const double times = narrow ? 4 : 12;
      EXPECT_LE(times * found.FromVtk.Rms, found.OfSamples.Rms);
      EXPECT_LE(times * found.FromVtk.Rms, found.OfVtk.Rms);
      EXPECT_LE(found.FromVtk.Rms, (narrow ? 10.0 : 0.25) / 255);
    }
  }
}

// The functions as VTK's tables have them: 1024 entries over the range of the data, of which entry
// i is met at (i + 0.5) / 1024 of that, and straight lines between.
vtkSmartPointer<vtkVolumeProperty> asInTables(vtkVolumeProperty* property, const double range[2])
{
  constexpr int entries = 1024;
  std::vector<double> opacities(entries);
  std::vector<double> colors(3 * entries);
  property->GetScalarOpacity()->GetTable(range[0], range[1], entries, opacities.data());
  property->GetRGBTransferFunction()->GetTable(range[0], range[1], entries, colors.data());
  vtkNew<vtkPiecewiseFunction> opacity;
  vtkNew<vtkColorTransferFunction> color;
  for (int i = 0; i < entries; ++i)
  {
    const double value = range[0] + (range[1] - range[0]) * (i + 0.5) / entries;
    opacity->AddPoint(value, opacities[i]);
    color->AddRGBPoint(value, colors[3 * i], colors[3 * i + 1], colors[3 * i + 2]);
  }
  const auto made = vtkSmartPointer<vtkVolumeProperty>::New();
  made->SetColor(color);
  made->SetScalarOpacity(opacity);
  made->SetScalarOpacityUnitDistance(property->GetScalarOpacityUnitDistance());
  made->SetInterpolationTypeToLinear();
  return made;
}

// Where rays take several samples, most of what narrow peaks differ by are VTK's tables.
TEST_F(Rivals, DifferByTheTablesOfVtk)
{
  double range[2];
  vtkDataSet::SafeDownCast(this->Scene.Data)->GetScalarRange(range);
  for (const double distance : { Voxel, 0.5 * Voxel })
  {
    const Mask inside = this->inside(distance);
    const auto differ = [&](const Image& a, const Image& b)
    { return compare(a, b, inside, 2.0 / 255.0, Channels::Rgb); };
    this->useFunctions("peaks", { 0.0, 1.0, UnitDistance });
    const Image vtks = this->vtks(distance);
    const Difference before = differ(this->sampled(distance), vtks);
    this->Scene.Volume->SetProperty(asInTables(this->Scene.property(), range));
    const Difference after = differ(this->sampled(distance), vtks);
    std::cout << "[ MEASURED ] peaks: " << before.text()
              << "\n[ MEASURED ]   by the functions of VTK's tables: " << after.text() << '\n';
    EXPECT_LE(3 * after.Rms, before.Rms);
  }
}

TEST_F(Rivals, AgreeFarBetterInLight)
{
  this->useFunctions("ramp", { 0.0, 1.0, UnitDistance });
  this->Scene.property()->ShadeOn();
  // Before VTK 9.2 its highlights are those of Blinn.
  this->Scene.property()->SetSpecular(0.0);
  this->Scene.property()->SetDiffuse(0.9);
  const Image exact = this->exact();
  const Image ours = this->sampled(Voxel);
  const Image vtks = this->vtks(Voxel);
  const Distances found{ colorsDiffer(ours, vtks), colorsDiffer(ours, exact),
    colorsDiffer(vtks, exact) };
  report("ramp in light at 1 voxel", found);
  EXPECT_LE(2 * found.FromVtk.Rms, found.OfSamples.Rms);
  EXPECT_LE(2 * found.FromVtk.Rms, found.OfVtk.Rms);
}
} // namespace
