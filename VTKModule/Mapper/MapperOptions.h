// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What users ask of any of our mappers, by the names that VTK's mappers have for it.
#ifndef TetMarchMapperMapperOptions_h
#define TetMarchMapperMapperOptions_h

#include "Blocks/MissingScalars.h"
#include "Frame/FrameInput.h"

#include "vtkAbstractVolumeMapper.h"

class vtkDataSet;

namespace tetmarch
{

inline ScalarSelection selectionOf(vtkAbstractVolumeMapper* mapper)
{
  return { mapper->GetScalarMode(), mapper->GetArrayAccessMode(), mapper->GetArrayId(),
    mapper->GetArrayName() };
}

template <typename Mapper>
VectorOptions vectorOptionsOf(Mapper* mapper)
{
  return { static_cast<VectorMode>(mapper->GetVectorMode()), mapper->GetVectorComponent() };
}

template <typename Mapper>
BlendOptions blendOptionsOf(Mapper* mapper)
{
  const double* range = mapper->GetAverageIPScalarRange();
  return { mapper->GetBlendMode(), { { range[0], range[1] } } };
}

template <typename Mapper>
ClippingOptions clippingOptionsOf(Mapper* mapper)
{
  ClippingOptions options;
  options.Planes = mapper->GetClippingPlanes();
  options.Cropping = mapper->GetCropping();
  mapper->GetCroppingRegionPlanes(options.CroppingPlanes.data());
  options.CroppingFlags = mapper->GetCroppingRegionFlags();
  return options;
}

/** The array that the mapper selects; none if it isn't there or has no components. */
FoundScalars findScalars(vtkDataSet* data, const ScalarSelection& selection);

} // namespace tetmarch

#endif
