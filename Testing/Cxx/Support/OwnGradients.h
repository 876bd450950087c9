// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Independent components in light: each by its own gradient
 */
#ifndef tetmarch_testing_OwnGradients_h
#define tetmarch_testing_OwnGradients_h

#include "Fields.h"
#include "GridBuilder.h"
#include "Images.h"
#include "Lights.h"

#include "vtkColorTransferFunction.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace tetmarch::testing
{
constexpr std::array<Vec3, 4> WaysOfComponents{ { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 },
  { 1.0, 1.0, 2.0 }, { -1.0, 2.0, 1.0 } } };

inline std::vector<Field> linearComponents(int count)
{
  std::vector<Field> fields;
  for (int k = 0; k < count; ++k)
  {
    const Vec3& way = WaysOfComponents[k];
    fields.push_back(linearFieldAlong(way[0], way[1], way[2]));
  }
  return fields;
}

/// Of a linear field each surface has the same normal: its colour in light is that without light,
/// times one factor. Two scenes of linearComponents(), without light.
template <typename AnyScene>
void expectLightOfOwnGradients(AnyScene& lit, AnyScene& dimmed, int count)
{
  const Vec3 light{ 2.5, 3.5, 1.0 };
  lit.Mapper->SetAccuracyLevelToAccurate();
  dimmed.Mapper->SetAccuracyLevelToAccurate();
  addLight(lit.Renderer, 0.5 + light[0], 0.5 + light[1], 0.5 + light[2]);
  const Image unlit = dimmed.render();
  for (int k = 0; k < count; ++k)
  {
    lit.property()->ShadeOn(k);
    lit.property()->SetAmbient(k, 0.2);
    lit.property()->SetDiffuse(k, 0.6);
    lit.property()->SetSpecular(k, 0.0);
    const Vec3& way = WaysOfComponents[k];
    const double turned = way[0] * light[0] + way[1] * light[1] + way[2] * light[2];
    const double factor =
      0.2 + 0.6 * std::abs(turned) /
              (std::hypot(way[0], way[1], way[2]) * std::hypot(light[0], light[1], light[2]));
    vtkColorTransferFunction* colors = dimmed.property()->GetRGBTransferFunction(k);
    for (int i = 0; i < colors->GetSize(); ++i)
    {
      double node[6];
      colors->GetNodeValue(i, node);
      colors->SetNodeValue(i, std::array<double, 6>{ node[0], factor * node[1], factor * node[2],
                                factor * node[3], node[4], node[5] }
                                .data());
    }
  }
  const Image expected = dimmed.render();
  EXPECT_GT(compare(unlit, expected).Max, 0.1);
  const Difference difference = compare(lit.render(), expected);
  EXPECT_LE(difference.Max, 0.5 / 255.0) << difference.text();
}
} // namespace tetmarch::testing

#endif
