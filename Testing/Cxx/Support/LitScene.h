// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scene that a light from beside shines on
 */
#ifndef tetmarch_testing_LitScene_h
#define tetmarch_testing_LitScene_h

#include "Scene.h"

#include "vtkColorTransferFunction.h"
#include "vtkLight.h"

namespace tetmarch::testing
{
/// Shaded by all of the property's numbers; the effects beyond that are off.
class LitScene : public Scene
{
public:
  explicit LitScene(vtkUnstructuredGrid* grid, int width = SceneSize, int height = SceneSize)
    : Scene(grid, width, height)
  {
    this->Sun->SetLightTypeToSceneLight();
    this->Sun->SetPosition(3.0, 4.0, 1.5);
    this->Sun->SetFocalPoint(0.5, 0.5, 0.5);
    this->Renderer->AddLight(this->Sun);
    setShading(this->property());
  }

  void addGradientOpacity() { setGradientOpacity(this->property()); }

  /// The picture of a white volume, which is what the view of the illumination shows.
  Image renderWhite()
  {
    this->Mapper->SetViewModeToPicture();
    vtkColorTransferFunction* colors = this->property()->GetRGBTransferFunction();
    colors->RemoveAllPoints();
    colors->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
    colors->SetNanColor(1.0, 1.0, 1.0);
    return this->render();
  }

  /// Of one frame, the sum over all pixels and channels.
  double brightness()
  {
    double sum = 0.0;
    for (const float value : this->render().Rgba)
    {
      sum += double(value);
    }
    return sum;
  }

  vtkNew<vtkLight> Sun;
};
} // namespace tetmarch::testing

#endif
