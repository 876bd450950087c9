// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Images with several components, and a test that has one for each way to draw them
 */
#ifndef tetmarch_testing_StructuredComponents_h
#define tetmarch_testing_StructuredComponents_h

#include "ComponentScene.h"
#include "StructuredScene.h"

#include <gtest/gtest.h>

namespace tetmarch::testing
{
/// For each component another number at each point, uniform in 0..1.
inline std::vector<Field> scatteredFields(int count)
{
  std::vector<Field> fields;
  for (int k = 0; k < count; ++k)
  {
    fields.push_back(scatteredField(3 + 7 * k));
  }
  return fields;
}

/// Of the unit cube, one field a component, at points and cells.
inline vtkSmartPointer<vtkImageData> imageWith(
  const std::vector<Field>& fields, int cells, int type = VTK_DOUBLE)
{
  const auto image = imageOf(fields[0], unitCube(cells));
  setComponents(image, fields, type);
  return image;
}

class ComponentsTest : public ::testing::TestWithParam<Mix>
{
protected:
  static std::vector<Field> wavy() { return wavyFields(GetParam().Components); }

  static void setFunctions(StructuredScene& scene)
  {
    setComponentFunctions(scene.property(), GetParam().Components);
    scene.property()->SetIndependentComponents(GetParam().Independent);
  }
};
} // namespace tetmarch::testing

#endif
