// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A window that shows the states of the monkey test, one after the other
 */
#ifndef tetmarch_testing_MonkeyScene_h
#define tetmarch_testing_MonkeyScene_h

#include "ErrorWatch.h"
#include "MonkeyState.h"
#include "WatchedMapper.h"

#include "vtkActor.h"
#include "vtkDataObject.h"
#include "vtkLight.h"
#include "vtkPlane.h"

#include <array>
#include <memory>

namespace tetmarch::testing
{
/// All but the window is new: in a window that has drawn before, shaders need not be built again.
class MonkeyScene
{
public:
  explicit MonkeyScene(vtkRenderWindow* window);
  ~MonkeyScene();
  MonkeyScene(const MonkeyScene&) = delete;
  MonkeyScene& operator=(const MonkeyScene&) = delete;

  /// Sets what differs from what is shown; draws nothing. Objects are changed, not replaced; with
  /// `inPlace` so are arrays of scalars of the same length.
  void show(const MonkeyState& state, bool inPlace = false);
  /// One frame.
  Image render();
  /// Moves the renderers and all that they draw to another window.
  void moveTo(vtkRenderWindow* window);

  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<WatchedMapper> Mapper;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkRenderer> Renderer;
  ErrorWatch Watch{ this->Mapper };

private:
  /// A box in the world, by its lowest corner and the extent of its longest side.
  struct Box
  {
    Vec3 Low{ { 0.0, 0.0, 0.0 } };
    double Extent = 1.0;
    Vec3 at(const Vec3& p) const;
  };
  Box boxOf(const double* bounds) const;

  void showData(const MonkeyState& state, bool inPlace);
  void showPlacement(const MonkeyState& state);
  void showProperty(const MonkeyState& state);
  void showMapper(const MonkeyState& state);
  void showCuts(const MonkeyState& state);
  void showActors(const MonkeyState& state);
  void showLights(const MonkeyState& state);
  void showCamera(const MonkeyState& state, vtkCamera* camera, int view);
  void showWindow(const MonkeyState& state);

  std::unique_ptr<MonkeyState> Shown; // what is set now; none yet
  vtkNew<vtkRenderer> Beside;         // with the same volume
  vtkSmartPointer<vtkDataObject> Data;
  vtkSmartPointer<vtkActor> Ball;
  std::array<vtkSmartPointer<vtkActor>, 2> Layers;
  vtkNew<vtkLight> Headlight, Sun, LightSource;
  std::vector<vtkSmartPointer<vtkPlane>> Planes;
};
} // namespace tetmarch::testing

#endif
