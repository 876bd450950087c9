// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VtkScene.h"

#include "vtkAutoInit.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkFloatArray.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkPointData.h"
#include "vtkRTAnalyticSource.h"

#include <algorithm>
#include <cmath>

VTK_MODULE_INIT(vtkRenderingVolumeOpenGL2);

namespace tetmarch::testing
{
vtkSmartPointer<vtkImageData> makeWavelet(int half)
{
  vtkNew<vtkRTAnalyticSource> source;
  source->SetWholeExtent(-half, half, -half, half, -half, half);
  source->SetXFreq(12.0);
  source->SetYFreq(6.0);
  source->SetZFreq(8.0);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkImageData> makeShell(int points)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(points, points, points);
  vtkNew<vtkFloatArray> values;
  values->SetName("shell");
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  const double half = 0.5 * (points - 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    const double away =
      (std::hypot(p[0] - half, p[1] - half, p[2] - half) - half / 1.5) / (0.25 * half);
    values->SetValue(i, static_cast<float>(255.0 * std::exp(-away * away)));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

Grid tetrahedraOf(vtkDataSet* data)
{
  vtkNew<vtkDataSetTriangleFilter> filter;
  filter->SetInputData(data);
  filter->Update();
  return filter->GetOutput();
}

void setFunctions(vtkVolumeProperty* property, double low, double high, double greatest)
{
  const auto at = [=](double share) { return low + share * (high - low); };
  vtkNew<vtkColorTransferFunction> colours;
  colours->AddRGBPoint(at(0.0), 0.1, 0.1, 0.4);
  colours->AddRGBPoint(at(0.3), 0.2, 0.3, 1.0);
  colours->AddRGBPoint(at(0.6), 1.0, 0.2, 0.1);
  colours->AddRGBPoint(at(0.8), 0.2, 1.0, 0.2);
  colours->AddRGBPoint(at(1.0), 1.0, 1.0, 1.0);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(at(0.0), 0.0);
  opacities->AddPoint(at(1.0), greatest);
  property->SetColor(colours);
  property->SetScalarOpacity(opacities);
  property->SetInterpolationTypeToLinear();
}

vtkSmartPointer<vtkGPUVolumeRayCastMapper> makeImageMapper(vtkImageData* image, double step)
{
  auto mapper = vtkSmartPointer<vtkGPUVolumeRayCastMapper>::New();
  mapper->SetInputData(image);
  mapper->SetAutoAdjustSampleDistances(0);
  mapper->SetSampleDistance(static_cast<float>(step));
  return mapper;
}

Vec3 forImageMapper(vtkImageData* image, const Vec3& point)
{
  const double* bounds = image->GetBounds();
  const int* points = image->GetDimensions();
  Vec3 moved;
  for (int k = 0; k < 3; ++k)
  {
    const double middle = 0.5 * (bounds[2 * k] + bounds[2 * k + 1]);
    moved[k] = middle + (point[k] - middle) * (points[k] - 1.0) / points[k];
  }
  return moved;
}

Image byMapper(Scene& scene, vtkAbstractVolumeMapper* mapper)
{
  scene.Volume->SetMapper(mapper);
  // In their first frame some of VTK 9.1's draw a part of the cells.
  scene.Window->Render();
  scene.Window->Render();
  const Image frame = scene.frame();
  scene.Volume->SetMapper(scene.Mapper);
  return frame;
}

void expectLike(
  Scene& scene, vtkAbstractVolumeMapper* rival, double mostRms, const std::string& what)
{
  const Image back = frameWithoutVolumes(scene);
  const Image rivals = byMapper(scene, rival);
  scene.Window->Render();
  expectLike(scene.frame(), rivals, back, mostRms, what);
}

void expectLike(const Image& ours, const Image& rivals, const Image& back, double mostRms,
  const std::string& what)
{
  Mask seen;
  for (std::size_t i = 0; i < ours.Rgba.size(); i += 4)
  {
    float most = 0.0f;
    for (std::size_t k = i; k < i + 3; ++k)
    {
      most = std::max(
        { most, std::abs(ours.Rgba[k] - back.Rgba[k]), std::abs(rivals.Rgba[k] - back.Rgba[k]) });
    }
    seen.push_back(most > 2.0f / 255.0f);
  }
  const Difference apart = compare(ours, rivals, seen, 0.0, Channels::Rgb);
  const double shown = compare(rivals, back, seen, 0.0, Channels::Rgb).Rms;
  std::cout << "[ MEASURED ] " << what << " apart from the rival: " << apart.text() << ", of "
            << 255.0 * shown << "/255\n";
  EXPECT_LE(255.0 * apart.Rms, mostRms) << what << ' ' << apart.text();
  EXPECT_GE(255.0 * shown, 5.0 * mostRms) << what << " is hardly seen";
}

void expectReference(vtkTetMarchVolumeMapper* mapper, vtkVolume* volume, int width, int height)
{
  const Image drawn = floatPictureOf(mapper, width, height);
  vtkNew<vtkFloatArray> pixels;
  ASSERT_TRUE(mapper->RenderGroundTruth(volume, pixels, TruthTolerance));
  const Image reference = Image::fromFloats(width, height, pixels->GetPointer(0));
  const Difference difference = compare(drawn, reference);
  std::cout << "[ MEASURED ] apart from the reference: " << difference.text() << '\n';
  EXPECT_LE(difference.Rms, 0.3 / 255.0) << difference.text();
  EXPECT_LE(100 * difference.Over, difference.Pixels) << difference.text();
  EXPECT_GT(compare(reference, Image(width, height)).Max, 0.3) << "nothing to be seen";
}
} // namespace tetmarch::testing
