// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scene with either kind of volume, and the stages of its frames that need no GL
 */
#ifndef tetmarch_testing_StagedFrame_h
#define tetmarch_testing_StagedFrame_h

#include "Frame/FrameStages.h"
#include "Volume/StructuredVolume.h"
#include "Volume/TetVolume.h"

#include "LatticeImages.h"
#include "OpaqueProps.h"
#include "Shot.h"

#include "vtkCellData.h"
#include "vtkLight.h"
#include "vtkPointData.h"
#include "vtkVolume.h"

namespace tetmarch::testing
{
/// A volume in the unit cube whose opacity and colour change along its scalars, from 0 to 1.
class StagedScene
{
public:
  explicit StagedScene(const vtkSmartPointer<vtkDataSet>& data)
  {
    this->Renderer->SetActiveCamera(Shot().Camera);
    this->property()->SetScalarOpacity(vtkNew<vtkPiecewiseFunction>());
    this->show({ { 0.0, 0.1 }, { 1.0, 0.6 } });
    vtkNew<vtkColorTransferFunction> colour;
    colour->AddRGBPoint(0.0, 0.2, 0.4, 1.0);
    colour->AddRGBPoint(1.0, 1.0, 0.3, 0.1);
    this->property()->SetColor(colour);
    this->Input.Drawn.Volume.Between = Interpolation::Linear;
    this->Input.Renderer = this->Renderer;
    this->Input.Volume = this->Volume;
    this->draw(data);
  }

  vtkVolumeProperty* property() { return this->Volume->GetProperty(); }
  /// The scalars of the data's points or cells.
  void draw(const vtkSmartPointer<vtkDataSet>& data, bool ofCells = false)
  {
    this->Data = data;
    this->Input.Drawn.Volume.Data = data;
    this->Input.Drawn.Scalars = {
      ofCells ? data->GetCellData()->GetScalars() : data->GetPointData()->GetScalars(), ofCells
    };
  }
  /// The points of the opacity function.
  void show(const std::vector<std::array<double, 2>>& opacities)
  {
    this->property()->GetScalarOpacity()->RemoveAllPoints();
    for (const auto& [scalar, opacity] : opacities)
    {
      this->property()->GetScalarOpacity()->AddPoint(scalar, opacity);
    }
  }
  void blend(BlendMode mode)
  {
    this->Input.Drawn.Blend.Mode = static_cast<int>(mode);
    this->Input.Effects.Blend = mode;
  }

  /// A box remains, or all but it.
  void crop(bool inside)
  {
    this->Input.Drawn.Cuts = { nullptr, true, { { 0.2, 0.6, 0.2, 0.6, 0.2, 0.6 } },
      inside ? 0x2000 : Clipping::AllRegions - 0x2000 };
  }
  void hideCell(vtkIdType which)
  {
    markCells(
      this->Data, vtkDataSetAttributes::HIDDENCELL, [=](vtkIdType id) { return id == which; });
  }
  /// The scalar of a point is not a number, and has a colour.
  void spoilPoint()
  {
    spoilScalars(
      this->Data, [](vtkIdType id) { return id == 3; }, [](vtkIdType) { return false; });
    this->property()->GetRGBTransferFunction()->SetNanOpacity(1);
  }
  void addGradientOpacity()
  {
    vtkNew<vtkPiecewiseFunction> function;
    function->AddPoint(0.0, 0.1);
    function->AddPoint(0.5, 0.9);
    this->property()->SetGradientOpacity(function);
  }

  /// Shade, by the Light alone.
  void shine(double x, double y, double z)
  {
    this->property()->ShadeOn();
    this->Light->SetPosition(x, y, z);
    this->Renderer->AddLight(this->Light);
  }
  void shineFromEye()
  {
    this->shine(0, 0, 1);
    this->Light->SetLightTypeToHeadlight();
  }
  void castShadow(ShadowMethod method = ShadowMethod::AtVertices)
  {
    this->shine(3, 4, 1);
    this->Input.Effects.Shadows = method;
  }
  /// Between the volume and the light of castShadow().
  void addPlate()
  {
    this->Renderer->AddActor(this->Plate);
    this->Input.Effects.OpaqueShadows = true;
  }

  vtkNew<vtkLight> Light;
  vtkSmartPointer<vtkActor> Plate =
    actorOf(plate({ { 0.83, 1.16, 0.07 } }, { { 1.71, 0.67, 0.07 } }, { { 0.83, 1.16, 1.09 } }));
  vtkSmartPointer<vtkDataSet> Data;
  vtkNew<WindowlessRenderer> Renderer;
  vtkNew<vtkVolume> Volume;
  FrameInput Input;
};

inline vtkSmartPointer<vtkDataSet> dataFor(const TetVolume&, const Field& field)
{
  return jitteredLattice(8, 0.0, 1, field);
}
inline vtkSmartPointer<vtkDataSet> dataFor(const StructuredVolume&, const Field& field)
{
  return imageOf(field, unitCube(16));
}

/// Its scalars are x.
template <typename VolumeOf>
class StagedFrame : public StagedScene
{
public:
  StagedFrame()
    : StagedScene(dataFor(VolumeOf(), [](double x, double, double) { return x; }))
  {
  }

  StageResult update() { return this->Stages.update(this->Input, {}); }

  VolumeOf Marched;
  FrameStages Stages{ Marched };
};
} // namespace tetmarch::testing

#endif
