// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ResampledScalars.h"

#include "Failure.h"

#include "vtkCharArray.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkResampleToImage.h"
#include "vtkTimerLog.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <fstream>

namespace tetmarch::bench
{
namespace
{
using Arrays = std::array<vtkDataArray*, 2>;

void setArrays(ResampledScalars& result, const Arrays& arrays)
{
  result.Image->GetPointData()->SetScalars(arrays[0]);
  result.Mask->GetPointData()->SetScalars(arrays[1]);
}

void setStructure(ResampledScalars& result, vtkUnstructuredGrid* grid, int size)
{
  double bounds[6];
  grid->GetBounds(bounds);
  for (vtkImageData* image : { result.Image.Get(), result.Mask.Get() })
  {
    image->SetDimensions(size, size, size);
    image->SetOrigin(bounds[0], bounds[2], bounds[4]);
    image->SetSpacing((bounds[1] - bounds[0]) / (size - 1), (bounds[3] - bounds[2]) / (size - 1),
      (bounds[5] - bounds[4]) / (size - 1));
  }
}

void resample(const Scene& scene, int size, ResampledScalars& result)
{
  vtkNew<vtkResampleToImage> resampler;
  resampler->SetInputDataObject(scene.Grid);
  resampler->SetSamplingDimensions(size, size, size);
  resampler->Update();
  vtkPointData* data = resampler->GetOutput()->GetPointData();
  vtkDataArray* scalars = data->GetArray(scene.Array.c_str());
  auto* valid = vtkCharArray::SafeDownCast(data->GetArray(resampler->GetMaskArrayName()));
  if (!scalars || !valid)
  {
    throw Failure("nothing was resampled");
  }
  vtkNew<vtkFloatArray> values;
  values->DeepCopy(scalars);
  vtkNew<vtkUnsignedCharArray> mask;
  mask->SetNumberOfValues(valid->GetNumberOfTuples());
  for (vtkIdType i = 0; i < mask->GetNumberOfValues(); ++i)
  {
    const bool inside = valid->GetValue(i) != 0;
    mask->SetValue(i, inside ? 255 : 0);
    result.HasOutside = result.HasOutside || !inside;
  }
  setArrays(result, { values, mask });
}

// Seconds, whether anything is outside, scalars, mask: all as they are in memory.
template <typename Step>
void eachPart(ResampledScalars& result, double& seconds, const Step& step)
{
  step(&seconds, sizeof(seconds));
  step(&result.HasOutside, sizeof(result.HasOutside));
  for (vtkImageData* image : { result.Image.Get(), result.Mask.Get() })
  {
    vtkDataArray* array = image->GetPointData()->GetScalars();
    step(array->GetVoidPointer(0), array->GetNumberOfValues() * array->GetDataTypeSize());
  }
}

bool fetch(const std::string& file, int size, ResampledScalars& result, double& seconds)
{
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
  {
    return false;
  }
  vtkNew<vtkFloatArray> values;
  vtkNew<vtkUnsignedCharArray> mask;
  for (const auto& array : Arrays{ values, mask })
  {
    array->SetNumberOfTuples(vtkIdType(size) * size * size);
  }
  setArrays(result, { values, mask });
  eachPart(result, seconds,
    [&](void* part, vtkIdType bytes) { stream.read(static_cast<char*>(part), bytes); });
  return static_cast<bool>(stream);
}

void keep(const std::string& file, ResampledScalars& result, double seconds)
{
  std::ofstream stream(file, std::ios::binary);
  eachPart(result, seconds,
    [&](const void* part, vtkIdType bytes)
    { stream.write(static_cast<const char*>(part), bytes); });
  if (!stream)
  {
    throw Failure("resampled scalars can't be kept in " + file);
  }
}
} // namespace

double fetchOrResample(const Scene& scene, int size, ResampledScalars& result)
{
  const double begin = vtkTimerLog::GetUniversalTime();
  const auto passed = [begin] { return vtkTimerLog::GetUniversalTime() - begin; };
  const std::string file = scene.CacheFolder.empty()
                             ? ""
                             : scene.CacheFolder + "/" + scene.Name + "-" + std::to_string(size);
  setStructure(result, scene.Grid, size);
  double seconds = 0.0;
  if (file.empty() || !fetch(file, size, result, seconds))
  {
    resample(scene, size, result);
    seconds = passed();
    if (!file.empty())
    {
      keep(file, result, seconds);
    }
  }
  return seconds - passed();
}
} // namespace tetmarch::bench
