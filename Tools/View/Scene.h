// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What is drawn: one volume by the mapper of its kind, maybe an opaque surface, a light, a legend.
 */
#ifndef tetmarch_Scene_h
#define tetmarch_Scene_h

#include "AnyMapper.h"
#include "Prepared.h"
#include "ViewState.h"

#include "vtkActor.h"
#include "vtkColorTransferFunction.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkTetMarchLegend.h"
#include "vtkVolume.h"

namespace tetmarch
{

class Scene
{
public:
  Scene();

  vtkRenderer* GetRenderer() { return this->Renderer; }
  vtkVolume* GetVolume() { return this->Volume; }
  /// The drawn functions: call Capture() after changing them. They stay the same objects.
  vtkColorTransferFunction* GetColor() { return this->Color; }
  vtkPiecewiseFunction* GetOpacity() { return this->Opacity; }

  /// What follows needs data.
  bool HasData() const { return this->Mapper != nullptr; }
  const Prepared& GetData() const { return this->Data; }
  AnyMapper& GetMapper() { return *this->Mapper; }
  /// Of the volume: xmin, xmax, ymin, ymax, zmin, zmax.
  std::array<double, 6> GetBounds() const;

  /// Takes the data, and into the state its array, and, if they were chosen, functions and a
  /// camera. A mapper that isn't null takes the place of the one that has drawn.
  void SetData(const Prepared& data, const std::shared_ptr<AnyMapper>& mapper, bool functionsChosen,
    double aspect, ViewState& state);
  /// Null: none.
  void SetSurface(vtkPolyData* surface);

  /// Draw as the state says.
  void Apply(const ViewState& state);
  /// What the user changes in the picture itself: camera and functions.
  void Capture(ViewState& state);

  /// Look at all of the data; from where the first picture does, or along an axis (0 to 2).
  void PlaceCamera(double aspect);
  void LookAlong(int axis);
  void SwitchProjection();

  /// An opacity that is one where the scalar changes fast, and less by strength where it doesn't.
  std::vector<std::array<double, 4>> MakeGradientOpacity(double strength) const;
  /// Values for isosurfaces, evenly in the range that is shown.
  std::vector<double> MakeIsoValues(int count) const;

  double GetDiagonal() const;

private:
  void SetMapper(const std::shared_ptr<AnyMapper>& mapper);
  void ApplyProperty(const ViewState& state);
  void ApplySettings(const ViewState& state);
  void ApplyLight(const EffectState& effects);
  void ApplyCuts(const CutState& cuts);
  void ApplyCamera(const CameraState& camera);

  Prepared Data;
  std::shared_ptr<AnyMapper> Mapper;
  bool Structured = false;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkColorTransferFunction> Color;
  vtkNew<vtkPiecewiseFunction> Opacity;
  vtkNew<vtkPiecewiseFunction> GradientOpacity;
  vtkNew<vtkLight> Light;
  vtkNew<vtkPlane> Plane;
  vtkNew<vtkPolyDataMapper> SurfaceMapper;
  vtkNew<vtkActor> Surface;
  vtkNew<vtkTetMarchLegend> Legend;
};

} // namespace tetmarch

#endif
