// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mappers.h"

#include "vtkNew.h"
#include "vtkProjectedTetrahedraMapper.h"
#include "vtkTetMarchVolumeMapper.h"
#include "vtkUnstructuredGridVolumeRayCastMapper.h"

#include <map>

namespace tetmarch::bench
{
namespace
{
using MapperPointer = vtkSmartPointer<vtkUnstructuredGridVolumeMapper>;

/// Its default is to lower the resolution of the picture until a frame is quick enough.
MapperPointer makeBunyk()
{
  auto mapper = vtkSmartPointer<vtkUnstructuredGridVolumeRayCastMapper>::New();
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetImageSampleDistance(1.0);
  return mapper;
}

template <int Level>
MapperPointer makeOurs()
{
  auto mapper = vtk::TakeSmartPointer(vtkTetMarchVolumeMapper::New());
  mapper->SetAccuracyLevel(Level);
  return mapper;
}

const std::map<std::string, MapperPointer (*)()>& makersByName()
{
  static const std::map<std::string, MapperPointer (*)()> makers = {
    { "tetmarch", makeOurs<vtkTetMarchVolumeMapper::DEFAULT> },
    { "tetmarch-fast", makeOurs<vtkTetMarchVolumeMapper::FAST> },
    { "tetmarch-accurate", makeOurs<vtkTetMarchVolumeMapper::ACCURATE> },
    { "tetmarch-reference", makeOurs<vtkTetMarchVolumeMapper::REFERENCE> },
    { "projected",
      []() -> MapperPointer
      { return vtk::TakeSmartPointer(vtkProjectedTetrahedraMapper::New()); } },
    { "bunyk", makeBunyk },
  };
  return makers;
}
} // namespace

bool isMapper(const std::string& name) { return makersByName().count(name) > 0; }

MapperPointer makeMapper(const std::string& name) { return makersByName().at(name)(); }
} // namespace tetmarch::bench
