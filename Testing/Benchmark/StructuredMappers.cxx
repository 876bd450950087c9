// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StructuredMappers.h"

#include "Mappers.h"
#include "Numbers.h"

#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkTetMarchSettings.h"
#include "vtkTetMarchSmartVolumeMapper.h"

#include <optional>

namespace tetmarch::bench
{
namespace
{
const std::map<std::string, int>& levelsByName()
{
  static const std::map<std::string, int> levels = {
    { "tetmarch-fast", vtkTetMarchSettings::FAST },
    { "tetmarch", vtkTetMarchSettings::DEFAULT },
    { "tetmarch-accurate", vtkTetMarchSettings::ACCURATE },
    { "tetmarch-adaptive", vtkTetMarchSettings::DEFAULT },
    { "tetmarch-adaptive-fast", vtkTetMarchSettings::FAST },
  };
  return levels;
}

const std::string OfGpu = "gpu";
const std::string OfGpuWithJitter = "gpu-jitter";
const std::string OfGpuAsStored = "gpu-stored";
const std::string FixedPoint = "fixed-point";

/// "gpu" of "gpu:4".
std::string kindOf(const std::string& mapper) { return mapper.substr(0, mapper.find(':')); }

bool isAdaptive(const std::string& kind) { return kind.rfind("tetmarch-adaptive", 0) == 0; }

std::optional<int> samplesOf(const std::string& mapper)
{
  const std::size_t colon = mapper.find(':');
  return colon == std::string::npos ? std::nullopt : ParseInteger(mapper.substr(colon + 1));
}

vtkSmartPointer<vtkVolumeMapper> makeOurs(int level, double pixelTolerance)
{
  const auto mapper = vtk::TakeSmartPointer(vtkTetMarchSmartVolumeMapper::New());
  mapper->SetAccuracyLevel(level);
  mapper->SetPixelTolerance(pixelTolerance);
  mapper->AutoAdjustSampleDistancesOff();
  mapper->InteractiveAdjustSampleDistancesOff();
  return mapper;
}

vtkSmartPointer<vtkVolumeMapper> makeGpu(bool jitter)
{
  const auto mapper = vtk::TakeSmartPointer(vtkGPUVolumeRayCastMapper::New());
  mapper->AutoAdjustSampleDistancesOff();
  mapper->LockSampleDistanceToInputSpacingOff();
  mapper->SetImageSampleDistance(1.0F);
  mapper->SetUseJittering(jitter);
  return mapper;
}

vtkSmartPointer<vtkVolumeMapper> makeFixedPoint(double sampleDistance)
{
  auto mapper = vtkSmartPointer<vtkFixedPointVolumeRayCastMapper>::New();
  mapper->AutoAdjustSampleDistancesOff();
  mapper->LockSampleDistanceToInputSpacingOff();
  mapper->SetImageSampleDistance(1.0F);
  mapper->SetSampleDistance(static_cast<float>(sampleDistance));
  mapper->SetInteractiveSampleDistance(static_cast<float>(sampleDistance));
  return mapper;
}
} // namespace

bool isStructuredMapper(const std::string& name)
{
  const std::string kind = kindOf(name);
  if (kind == OfGpu || kind == OfGpuWithJitter || kind == OfGpuAsStored)
  {
    return samplesOf(name).value_or(0) > 0;
  }
  return levelsByName().count(name) || name == FixedPoint;
}

bool isRedundant(const std::string& mapper, const StructuredVolume& volume)
{
  return kindOf(mapper) == OfGpuAsStored && volume.Stored == volume.Floats;
}

StructuredScene::StructuredScene(StructuredVolume volume, vtkVolumeProperty* property)
  : Shown(std::move(volume))
  , Property(property)
{
}

vtkSmartPointer<vtkVolumeMapper> StructuredScene::makeMapper(const std::string& kind) const
{
  const auto level = levelsByName().find(kind);
  const auto mapper = level != levelsByName().end()
                        ? makeOurs(level->second, isAdaptive(kind) ? AdaptiveTolerance : 0.0)
                      : kind == FixedPoint ? makeFixedPoint(this->Shown.Voxel)
                                           : makeGpu(kind == OfGpuWithJitter);
  const bool inFloat = kind == OfGpu || kind == OfGpuWithJitter;
  mapper->SetInputDataObject(inFloat ? this->Shown.Floats : this->Shown.Stored);
  return mapper;
}

vtkVolume* StructuredScene::show(const std::string& mapper)
{
  for (const auto& other : this->VolumesByKind)
  {
    other.second->VisibilityOff();
  }
  vtkSmartPointer<vtkVolume>& volume = this->VolumesByKind[kindOf(mapper)];
  if (!volume)
  {
    volume = vtkSmartPointer<vtkVolume>::New();
    volume->SetMapper(this->makeMapper(kindOf(mapper)));
    volume->SetProperty(this->Property);
  }
  volume->VisibilityOn();
  if (auto* gpu = vtkGPUVolumeRayCastMapper::SafeDownCast(volume->GetMapper()))
  {
    gpu->SetSampleDistance(static_cast<float>(this->Shown.Voxel / samplesOf(mapper).value_or(1)));
  }
  return volume;
}
} // namespace tetmarch::bench
