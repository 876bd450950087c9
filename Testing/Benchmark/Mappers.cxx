// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mappers.h"

#include "Numbers.h"
#include "ResampledVolume.h"

#include "vtkNew.h"
#include "vtkProjectedTetrahedraMapper.h"
#include "vtkTetMarchVolumeMapper.h"
#include "vtkUnstructuredGridHomogeneousRayIntegrator.h"
#include "vtkUnstructuredGridLinearRayIntegrator.h"
#include "vtkUnstructuredGridPartialPreIntegration.h"
#include "vtkUnstructuredGridPreIntegration.h"
#include "vtkUnstructuredGridVolumeRayCastMapper.h"
#include "vtkUnstructuredGridVolumeZSweepMapper.h"

#include <functional>
#include <map>
#include <optional>

namespace tetmarch::bench
{
namespace
{
using Maker = std::function<PreparedVolume(const Scene&)>;

PreparedVolume volumeOf(vtkUnstructuredGridVolumeMapper* mapper, const Scene& scene)
{
  mapper->SetInputData(scene.Grid);
  mapper->SetScalarMode(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  mapper->SelectScalarArray(scene.Array.c_str());
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->SetProperty(scene.Property);
  return { volume, 0.0 };
}

PreparedVolume makeProjected(const Scene& scene)
{
  const auto mapper = vtk::TakeSmartPointer(vtkProjectedTetrahedraMapper::New());
  return volumeOf(mapper, scene);
}

/// Their default is to lower the resolution of the picture until a frame is quick enough.
template <typename RayCaster>
vtkSmartPointer<RayCaster> atFullResolution()
{
  auto mapper = vtkSmartPointer<RayCaster>::New();
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetImageSampleDistance(1.0);
  return mapper;
}

PreparedVolume makeBunyk(const Scene& scene)
{
  return volumeOf(atFullResolution<vtkUnstructuredGridVolumeRayCastMapper>(), scene);
}

template <typename Integrator>
PreparedVolume makeBunykWith(const Scene& scene)
{
  const auto mapper = atFullResolution<vtkUnstructuredGridVolumeRayCastMapper>();
  vtkNew<Integrator> integrator;
  mapper->SetRayIntegrator(integrator);
  return volumeOf(mapper, scene);
}

PreparedVolume makeZSweep(const Scene& scene)
{
  return volumeOf(atFullResolution<vtkUnstructuredGridVolumeZSweepMapper>(), scene);
}

Maker ours(int level, double pixelTolerance = 0.0)
{
  return [level, pixelTolerance](const Scene& scene)
  {
    const auto mapper = vtk::TakeSmartPointer(vtkTetMarchVolumeMapper::New());
    mapper->SetAccuracyLevel(level);
    mapper->SetPixelTolerance(pixelTolerance);
    return volumeOf(mapper, scene);
  };
}

Maker oursByStage(int stage)
{
  return [stage](const Scene& scene)
  {
    const auto mapper = vtk::TakeSmartPointer(vtkTetMarchVolumeMapper::New());
    mapper->SetShaderStage(stage);
    return volumeOf(mapper, scene);
  };
}

Maker oursWithTolerance(int denominator)
{
  return [denominator](const Scene& scene)
  {
    const auto mapper = vtk::TakeSmartPointer(vtkTetMarchVolumeMapper::New());
    mapper->SetErrorTolerance(1.0 / denominator);
    return volumeOf(mapper, scene);
  };
}

/// The number behind a prefix, if it is one above 0.
std::optional<int> numberBehind(const std::string& prefix, const std::string& name)
{
  if (name.compare(0, prefix.size(), prefix) != 0)
  {
    return std::nullopt;
  }
  const auto number = ParseInteger(name.substr(prefix.size()));
  return number && *number > 0 ? number : std::nullopt;
}

/// "resample:SIZE/SAMPLES".
Maker resampled(const std::string& name)
{
  const auto slash = name.find('/');
  const auto size = numberBehind("resample:", name.substr(0, slash));
  const auto samples =
    slash == std::string::npos ? std::optional<int>() : numberBehind("/", name.substr(slash));
  if (!size || *size < 2 || !samples)
  {
    return {};
  }
  return [size = *size, samples = *samples](const Scene& scene)
  { return makeResampledVolume(scene, size, 1.0 / samples); };
}

/// Empty if there is no such mapper.
Maker makerOf(const std::string& name)
{
  static const std::map<std::string, Maker> makers = {
    { "tetmarch", ours(vtkTetMarchVolumeMapper::DEFAULT) },
    { "tetmarch-fast", ours(vtkTetMarchVolumeMapper::FAST) },
    { "tetmarch-accurate", ours(vtkTetMarchVolumeMapper::ACCURATE) },
    { "tetmarch-reference", ours(vtkTetMarchVolumeMapper::REFERENCE) },
    { "tetmarch-compute", oursByStage(vtkTetMarchVolumeMapper::COMPUTE_STAGE) },
    { "tetmarch-fragment", oursByStage(vtkTetMarchVolumeMapper::FRAGMENT_STAGE) },
    { "tetmarch-adaptive", ours(vtkTetMarchVolumeMapper::DEFAULT, AdaptiveTolerance) },
    { "tetmarch-adaptive-fast", ours(vtkTetMarchVolumeMapper::FAST, AdaptiveTolerance) },
    { "projected", makeProjected },
    { "bunyk", makeBunyk },
    { "bunyk-homogeneous", makeBunykWith<vtkUnstructuredGridHomogeneousRayIntegrator> },
    { "bunyk-preintegration", makeBunykWith<vtkUnstructuredGridPreIntegration> },
    { "bunyk-partial", makeBunykWith<vtkUnstructuredGridPartialPreIntegration> },
    { "bunyk-linear", makeBunykWith<vtkUnstructuredGridLinearRayIntegrator> },
    { "zsweep", makeZSweep },
  };
  const auto found = makers.find(name);
  if (found != makers.end())
  {
    return found->second;
  }
  const auto denominator = numberBehind("tetmarch:1/", name);
  return denominator ? oursWithTolerance(*denominator) : resampled(name);
}
} // namespace

bool isMapper(const std::string& name) { return static_cast<bool>(makerOf(name)); }

PreparedVolume makeVolume(const std::string& name, const Scene& scene)
{
  return makerOf(name)(scene);
}
} // namespace tetmarch::bench
