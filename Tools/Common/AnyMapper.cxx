// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AnyMapper.h"

#include "vtkNew.h"
#include "vtkTetMarchFirstPicture.h"
#include "vtkTetMarchSmartVolumeMapper.h"
#include "vtkTetMarchVolumeMapper.h"

#include <algorithm>
#include <type_traits>

namespace
{
template <typename Mapper>
class MapperOf : public tetmarch::AnyMapper
{
public:
  vtkAbstractVolumeMapper* GetMapper() override { return this->Object; }
  void SetSettings(vtkTetMarchSettings* settings) override { this->Object->SetSettings(settings); }
  vtkTetMarchSettings* GetSettings() override { return this->Object->GetSettings(); }
  vtkTetMarchFrameStatistics* GetStatistics() override
  {
    return this->Object->GetLastFrameStatistics();
  }

  void SetInput(vtkDataObject* data) override { this->Object->SetInputDataObject(data); }
  bool PrepareMesh() override
  {
    if constexpr (std::is_same_v<Mapper, vtkTetMarchVolumeMapper>)
    {
      return this->Object->PrepareMesh();
    }
    return true;
  }
  void SetComponent(int component) override
  {
    this->Object->SetVectorMode(component < 0 ? Mapper::MAGNITUDE : Mapper::COMPONENT);
    this->Object->SetVectorComponent(std::max(component, 0));
  }
  void SetBlendMode(int mode) override { this->Object->SetBlendMode(mode); }
  void SetCropping(const double planes[6], int flags) override
  {
    this->Object->CroppingOn();
    this->Object->SetCroppingRegionPlanes(
      planes[0], planes[1], planes[2], planes[3], planes[4], planes[5]);
    this->Object->SetCroppingRegionFlags(flags);
  }
  void SetCroppingOff() override { this->Object->CroppingOff(); }

  void SetSamples(double distance, bool jitter) override
  {
    if constexpr (std::is_same_v<Mapper, vtkTetMarchSmartVolumeMapper>)
    {
      this->Object->SetSampleDistance(static_cast<float>(distance));
      this->Object->SetUseJittering(jitter);
      // As far apart in each frame, whatever time it takes.
      this->Object->InteractiveAdjustSampleDistancesOff();
      this->Object->AutoAdjustSampleDistancesOff();
    }
  }
  void SetSamplesOff() override
  {
    if constexpr (std::is_same_v<Mapper, vtkTetMarchSmartVolumeMapper>)
    {
      this->Object->InteractiveAdjustSampleDistancesOn();
      this->Object->AutoAdjustSampleDistancesOn();
    }
  }

  bool CompareWithGroundTruth(vtkVolume* volume) override
  {
    return this->Object->CompareWithGroundTruth(volume);
  }
  bool TraceRay(
    vtkVolume* volume, int x, int y, tetmarch::TraceIn arithmetic, vtkTable* cells) override
  {
    return this->Object->TraceRay(volume, x, y, static_cast<int>(arithmetic), cells);
  }
  void GetDiagnosticPixels(vtkFloatArray* pixels) override
  {
    this->Object->GetDiagnosticPixels(pixels);
  }
  std::optional<tetmarch::PickedPoint> Pick(
    vtkRenderer* renderer, vtkVolume* volume, int x, int y) override
  {
    if (!this->Object->Pick(renderer, volume, x, y))
    {
      return std::nullopt;
    }
    const double* at = this->Object->GetPickedPosition();
    return tetmarch::PickedPoint{ { { at[0], at[1], at[2] } }, this->Object->GetPickedScalar(),
      this->Object->GetPickedCellId(), this->Object->GetPickedBlock() };
  }

private:
  vtkNew<Mapper> Object;
};
} // namespace

void tetmarch::AnyMapper::SelectArray(int association, const std::string& name)
{
  this->GetMapper()->SetScalarMode(association == vtkTetMarchFirstPicture::CELLS
                                     ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA
                                     : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  this->GetMapper()->SelectScalarArray(name.c_str());
}

std::unique_ptr<tetmarch::AnyMapper> tetmarch::MakeMapper(bool structured)
{
  if (structured)
  {
    return std::make_unique<MapperOf<vtkTetMarchSmartVolumeMapper>>();
  }
  return std::make_unique<MapperOf<vtkTetMarchVolumeMapper>>();
}
