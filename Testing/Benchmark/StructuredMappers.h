// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The mappers of images that are compared, set up to draw the same picture
 */
#ifndef tetmarch_bench_StructuredMappers_h
#define tetmarch_bench_StructuredMappers_h

#include "StructuredVolumes.h"

#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <map>
#include <string>

namespace tetmarch::bench
{
/**
 * "tetmarch-fast", "tetmarch", "tetmarch-accurate"; "tetmarch-adaptive" and
 * "tetmarch-adaptive-fast", the levels Default and Fast with interpolated pixels; "gpu:K", VTK's
 * GPU mapper with K samples a voxel of the volume in float; "gpu-jitter:K", the same with jitter;
 * "gpu-stored:K", of the scalars as they are stored; "fixed-point", VTK's on the CPU with a sample
 * a voxel, as stored.
 */
bool isStructuredMapper(const std::string& name);

/// Whether a mapper would draw the same as another, since the scalars are stored in float.
bool isRedundant(const std::string& mapper, const StructuredVolume& volume);

/// One scene by all mappers. Settings of VTK's GPU mapper that differ in their samples alone share
/// one mapper, and its texture.
class StructuredScene
{
public:
  StructuredScene(StructuredVolume volume, vtkVolumeProperty* property);

  /// Set up as that name says, and the only one that is visible.
  vtkVolume* show(const std::string& mapper);

  const StructuredVolume Shown;

private:
  vtkSmartPointer<vtkVolumeMapper> makeMapper(const std::string& kind) const;

  vtkSmartPointer<vtkVolumeProperty> Property;
  std::map<std::string, vtkSmartPointer<vtkVolume>> VolumesByKind;
};
} // namespace tetmarch::bench

#endif
