// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scene of several components
 */
#ifndef tetmarch_testing_ComponentScene_h
#define tetmarch_testing_ComponentScene_h

#include "ComponentFields.h"
#include "Scene.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

namespace tetmarch::testing
{
/// A number of components, independent or dependent.
struct Mix
{
  const char* Name;
  int Components;
  bool Independent;
};
constexpr Mix Mixes[] = { { "TwoIndependent", 2, true }, { "ThreeIndependent", 3, true },
  { "FourIndependent", 4, true }, { "ColorAndOpacity", 2, false }, { "DirectColor", 4, false } };

/// Fields of which no two components are alike, and none linear.
inline std::vector<Field> wavyFields(int count)
{
  const std::vector<Field> fields{ sineField(), noiseField(3, 4), radialField(), sineField(1.7) };
  return { fields.begin(), fields.begin() + count };
}

/// Draws the components of an array that withComponents() has made.
inline void drawComponents(Scene& scene, const Mix& mix)
{
  setComponentFunctions(scene.property(), mix.Components);
  scene.property()->SetIndependentComponents(mix.Independent);
  if (mix.Independent)
  {
    scene.Mapper->SetVectorModeToAllComponents();
  }
}

class ComponentScene : public Scene
{
public:
  ComponentScene(const Grid& grid, const Mix& mix, int width = SceneSize, int height = SceneSize,
    int type = VTK_DOUBLE)
    : Scene(withComponents(grid, wavyFields(mix.Components), type), width, height)
  {
    drawComponents(*this, mix);
  }

  void drawCells() { this->Mapper->SetScalarModeToUseCellData(); }
};
} // namespace tetmarch::testing

#endif
