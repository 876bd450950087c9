// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A shaded scene in any blend mode
 */
#ifndef tetmarch_testing_BlendScene_h
#define tetmarch_testing_BlendScene_h

#include "LitScene.h"

#include "vtkContourValues.h"

#include <vector>

namespace tetmarch::testing
{
using Mapper = vtkTetMarchVolumeMapper;
constexpr int BlendModes[] = { Mapper::COMPOSITE_BLEND, Mapper::MAXIMUM_INTENSITY_BLEND,
  Mapper::MINIMUM_INTENSITY_BLEND, Mapper::AVERAGE_INTENSITY_BLEND, Mapper::ADDITIVE_BLEND,
  Mapper::ISOSURFACE_BLEND };

inline void setSurfaces(vtkVolumeProperty* property, const std::vector<double>& values)
{
  vtkContourValues* contours = property->GetIsoSurfaceValues();
  contours->SetNumberOfContours(static_cast<int>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    contours->SetValue(static_cast<int>(i), values[i]);
  }
}

class BlendScene : public LitScene
{
public:
  explicit BlendScene(vtkUnstructuredGrid* grid, int width = SceneSize, int height = SceneSize)
    : LitScene(grid, width, height)
  {
    this->setSurfaces({ 0.35, 0.5, 0.72 });
  }

  void setSurfaces(const std::vector<double>& values)
  {
    tetmarch::testing::setSurfaces(this->property(), values);
  }
};
} // namespace tetmarch::testing

#endif
