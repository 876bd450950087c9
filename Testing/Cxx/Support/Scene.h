// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A window with one volume in it, and its pictures
 */
#ifndef tetmarch_testing_Scene_h
#define tetmarch_testing_Scene_h

#include "vtkTetMarchVolumeMapper.h"

#include "Grids.h"
#include "Images.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <vector>

class vtkActor;

namespace tetmarch::testing
{
constexpr int SceneSize = 160;
/// Of ground truths: a fraction of every limit that pictures are held to.
constexpr double TruthTolerance = 5e-5;

/// A window through the backend that TETMARCH_GL names, without multisampling; throws if there is
/// none.
vtkSmartPointer<vtkRenderWindow> makeWindow(int width = SceneSize, int height = SceneSize);

/// Colours and opacities with a kink in each function somewhere in [0, 1], visible all over.
void setBumpyFunctions(vtkVolumeProperty* property);
/// The same with opaque spikes a few thousandths wide, and nothing between them.
void setSpikyFunctions(vtkVolumeProperty* property);
/// Those of Data/golfball_wake.json, for the vorticity of the golf ball; with their unit distance.
void setWakeFunctions(vtkVolumeProperty* property);
/// Opacities with two peaks, of scalars between 0.2 and 0.8, and nothing beside them.
void setTwoPeaks(vtkVolumeProperty* property);
/// Gradient opacity: thinner where the scalar changes little.
void setGradientOpacity(vtkVolumeProperty* property);
/// Shading with numbers of which none is the default.
void setShading(vtkVolumeProperty* property);
/// One colour and one opacity whatever the scalar.
void setPlainFunctions(
  vtkVolumeProperty* property, const std::array<double, 3>& colour, double opacity);

/// From a corner onto the unit cube; nothing in it is parallel to anything.
void lookAtUnitCube(vtkCamera* camera);
/// In parallel projection down z onto the middle of the unit cube, so that each chord is 1; the
/// picture shows twice the scale of it.
void lookDownZ(vtkCamera* camera, double scale);
/// From a point in the unit cube, towards a side of it.
void lookFromInside(vtkCamera* camera);

/// The diagnostic picture of the mapper's last frame, for a viewport of that size.
Image floatPictureOf(vtkTetMarchVolumeMapper* mapper, int width, int height);
/// The window's framebuffer, RGB with its alpha.
Image framePictureOf(vtkRenderWindow* window);
/// Depths, 0 to 1, of what is opaque in the last frame.
std::vector<float> windowDepthsOf(vtkRenderWindow* window);
/// The same within a rectangle of the picture.
Image cropped(const Image& image, int x, int y, int width, int height);

/// A flat actor of one colour without lighting, of the plane z = height over [0, 1]^2 enlarged by a
/// margin on each side.
vtkSmartPointer<vtkActor> makePlane(
  double height, double margin, const std::array<double, 3>& colour);
/// A ball about a centre, without lighting.
vtkSmartPointer<vtkActor> makeBall(
  const Vec3& centre, double radius, const std::array<double, 3>& colour);

class Scene
{
public:
  /// Diagnostics on, the bumpy functions, unit distance 0.25, seen by lookAtUnitCube().
  explicit Scene(vtkUnstructuredGrid* grid, int width = SceneSize, int height = SceneSize);
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  vtkVolumeProperty* property() { return this->Volume->GetProperty(); }
  vtkCamera* camera() { return this->Renderer->GetActiveCamera(); }
  void drawCellScalars(const char* name = "c");

  /// One frame; returns the diagnostic picture.
  Image render();
  Image frame() const { return framePictureOf(this->Window); }
  /// Of the last frame, 0..1, row by row from the bottom.
  std::vector<float> windowDepths() const { return windowDepthsOf(this->Window); }

  Grid Data;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkTetMarchVolumeMapper> Mapper;
};

/// A light of the scene, from there to the middle of the unit cube.
vtkSmartPointer<vtkLight> addLight(Scene& scene, double x, double y, double z);
} // namespace tetmarch::testing

#endif
