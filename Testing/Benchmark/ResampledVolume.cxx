// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ResampledVolume.h"

#include "ResampledScalars.h"

#include "vtkNew.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tetmarch::bench
{
namespace
{
/// Opacity a means an extinction of a by the unit distance u here; to the mapper of images it means
/// -ln(1 - a) by u.
vtkSmartPointer<vtkPiecewiseFunction> toStructured(vtkPiecewiseFunction* opacity)
{
  constexpr int samples = 4096;
  double range[2];
  opacity->GetRange(range);
  std::vector<double> scalars;
  for (int i = 0; i <= samples; ++i)
  {
    scalars.push_back(range[0] + (range[1] - range[0]) * i / samples);
  }
  for (int i = 0; i < opacity->GetSize(); ++i)
  {
    double node[4];
    opacity->GetNodeValue(i, node);
    scalars.push_back(node[0]);
  }
  std::sort(scalars.begin(), scalars.end());
  std::vector<double> points;
  for (const double s : scalars)
  {
    points.push_back(s);
    points.push_back(-std::expm1(-opacity->GetValue(s)));
  }
  auto result = vtkSmartPointer<vtkPiecewiseFunction>::New();
  result->FillFromDataPointer(static_cast<int>(scalars.size()), points.data());
  return result;
}
} // namespace

PreparedVolume makeResampledVolume(const Scene& scene, int size, double sampleDistance)
{
  ResampledScalars resampled;
  const double owed = fetchOrResample(scene, size, resampled);
  const double* spacing = resampled.Image->GetSpacing();

  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(resampled.Image);
  if (resampled.HasOutside)
  {
    mapper->SetMaskInput(resampled.Mask);
    mapper->SetMaskTypeToBinary();
  }
  mapper->SetAutoAdjustSampleDistances(0);
  mapper->SetImageSampleDistance(1.0F);
  mapper->SetSampleDistance(
    static_cast<float>(sampleDistance * *std::min_element(spacing, spacing + 3)));

  vtkNew<vtkVolumeProperty> property;
  property->DeepCopy(scene.Property);
  property->SetScalarOpacity(toStructured(scene.Property->GetScalarOpacity()));
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  return { volume, owed };
}
} // namespace tetmarch::bench
