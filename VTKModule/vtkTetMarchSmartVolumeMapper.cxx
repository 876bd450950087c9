// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchSmartVolumeMapperInternals.h"

#include "Blocks/BlockList.h"
#include "Mapper/AlgorithmProgress.h"
#include "Mapper/GroundTruthPicture.h"
#include "Mapper/RecordStatistics.h"
#include "Mapper/TraceTable.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkTetMarchSmartVolumeMapper);

//------------------------------------------------------------------------------
vtkTetMarchSmartVolumeMapper::vtkTetMarchSmartVolumeMapper()
  : Internal(new Internals(this))
{
  this->VectorComponent = 0; // VTK 9.1 leaves it undefined
}

//------------------------------------------------------------------------------
vtkTetMarchSmartVolumeMapper::~vtkTetMarchSmartVolumeMapper() { this->Internal->Blocks.clear(); }

//------------------------------------------------------------------------------
double* vtkTetMarchSmartVolumeMapper::GetBounds()
{
  auto* blocks = vtkCompositeDataSet::SafeDownCast(this->GetDataObjectInput());
  if (!blocks)
  {
    return this->Superclass::GetBounds();
  }
  this->Update();
  tetmarch::boundBlocks(blocks, this->Bounds);
  return this->Bounds;
}

//------------------------------------------------------------------------------
int vtkTetMarchSmartVolumeMapper::FillInputPortInformation(int port, vtkInformation* info)
{
  this->Superclass::FillInputPortInformation(port, info);
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  return 1;
}

//------------------------------------------------------------------------------
void vtkTetMarchSmartVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Blocks.releaseIfHeldBy(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkTetMarchSmartVolumeMapper::SetSettings(vtkTetMarchSettings* settings)
{
  this->Internal->State.Settings.set(settings);
}
vtkTetMarchSettings* vtkTetMarchSmartVolumeMapper::GetSettings() const
{
  return this->Internal->State.Settings.get();
}

//------------------------------------------------------------------------------
void vtkTetMarchSmartVolumeMapper::SetAutoAdjustSampleDistances(vtkTypeBool adjusts)
{
  this->GetSettings()->SetAutoAdjustSampleDistances(adjusts != 0);
}
vtkTypeBool vtkTetMarchSmartVolumeMapper::GetAutoAdjustSampleDistances() VTK_TETMARCH_FUTURE_CONST
{
  return this->GetSettings()->GetAutoAdjustSampleDistances() ? 1 : 0;
}
void vtkTetMarchSmartVolumeMapper::AutoAdjustSampleDistancesOn()
{
  this->SetAutoAdjustSampleDistances(1);
}
void vtkTetMarchSmartVolumeMapper::AutoAdjustSampleDistancesOff()
{
  this->SetAutoAdjustSampleDistances(0);
}

//------------------------------------------------------------------------------
void vtkTetMarchSmartVolumeMapper::SetMaxMemoryInBytes(vtkIdType bytes)
{
  this->GetSettings()->SetMaxMemoryInBytes(bytes);
}
vtkIdType vtkTetMarchSmartVolumeMapper::GetMaxMemoryInBytes() VTK_TETMARCH_FUTURE_CONST
{
  return this->GetSettings()->GetMaxMemoryInBytes();
}
vtkIdType vtkTetMarchSmartVolumeMapper::GetMaxMemoryInBytesMinValue()
{
  return this->GetSettings()->GetMaxMemoryInBytesMinValue();
}
vtkIdType vtkTetMarchSmartVolumeMapper::GetMaxMemoryInBytesMaxValue()
{
  return this->GetSettings()->GetMaxMemoryInBytesMaxValue();
}

//------------------------------------------------------------------------------
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
void vtkTetMarchSmartVolumeMapper::SetVolumetricScatteringBlending(float blending)
{
  this->GetSettings()->SetVolumetricScatteringBlending(blending);
}
float vtkTetMarchSmartVolumeMapper::GetVolumetricScatteringBlending() VTK_TETMARCH_FUTURE_CONST
{
  return this->GetSettings()->GetVolumetricScatteringBlending();
}
void vtkTetMarchSmartVolumeMapper::SetGlobalIlluminationReach(float reach)
{
  this->GetSettings()->SetGlobalIlluminationReach(reach);
}
float vtkTetMarchSmartVolumeMapper::GetGlobalIlluminationReach() VTK_TETMARCH_FUTURE_CONST
{
  return this->GetSettings()->GetGlobalIlluminationReach();
}
#endif

//------------------------------------------------------------------------------
vtkTetMarchFrameStatistics* vtkTetMarchSmartVolumeMapper::GetLastFrameStatistics() const
{
  this->Internal->recordStatistics();
  return this->Internal->State.Statistics;
}

//------------------------------------------------------------------------------
void vtkTetMarchSmartVolumeMapper::Internals::recordStatistics()
{
  std::vector<const tetmarch::StructuredBlock*> blocks;
  for (const auto& block : this->Blocks.all())
  {
    blocks.push_back(block.get());
  }
  tetmarch::recordStructured(blocks, this->State.Statistics);
  tetmarch::recordAccuracy(this->State.Accuracy, this->State.Statistics);
}

//------------------------------------------------------------------------------
vtkLookupTable* vtkTetMarchSmartVolumeMapper::GetViewLookupTable()
{
  return this->Internal->State.ViewTable;
}

//------------------------------------------------------------------------------
bool vtkTetMarchSmartVolumeMapper::Pick(vtkRenderer* renderer, vtkVolume* volume, int x, int y)
{
  std::string error;
  const tetmarch::Pick pick =
    this->Internal->State.Picking.pick(this, renderer, volume, x, y, error);
  this->Report(error);
  std::copy_n(pick.Position.begin(), 3, this->PickedPosition);
  this->PickedScalar = pick.Scalar;
  this->PickedCellId = pick.Cell;
  this->PickedBlock = this->Internal->Blocks.isTree() ? pick.Block : 0;
  return pick.Hit;
}

//------------------------------------------------------------------------------
tetmarch::StructuredBlock* vtkTetMarchSmartVolumeMapper::Internals::onlyBlock(
  std::string& error) const
{
  if (this->Blocks.all().size() == 1)
  {
    return this->Blocks.all().front().get();
  }
  error =
    this->Blocks.all().empty()
      ? "There is no frame that was marched: render the window first."
      : "Several blocks are drawn one over the other, which the CPU does not repeat. Draw one "
        "of them alone.";
  return nullptr;
}

//------------------------------------------------------------------------------
bool vtkTetMarchSmartVolumeMapper::RenderGroundTruth(
  vtkVolume* volume, vtkFloatArray* pixels, double tolerance)
{
  std::string error;
  tetmarch::StructuredBlock* block = this->Internal->onlyBlock(error);
  const bool done =
    block &&
    tetmarch::renderGroundTruth(
      { block->Pipeline, volume, tetmarch::beginProgressOf(this), tolerance }, pixels, error);
  return this->Report(error) && done;
}

//------------------------------------------------------------------------------
bool vtkTetMarchSmartVolumeMapper::CompareWithGroundTruth(vtkVolume* volume)
{
  std::string error;
  tetmarch::StructuredBlock* block = this->Internal->onlyBlock(error);
  const bool done = block && tetmarch::compareWithGroundTruth(
                               { block->Pipeline, volume, tetmarch::beginProgressOf(this) },
                               this->Internal->State.Statistics, error);
  return this->Report(error) && done;
}

//------------------------------------------------------------------------------
void vtkTetMarchSmartVolumeMapper::GetDiagnosticPixels(vtkFloatArray* pixels) const
{
  std::string error;
  if (tetmarch::StructuredBlock* block = this->Internal->onlyBlock(error))
  {
    tetmarch::copyDiagnosticPixels(block->Pipeline, pixels);
  }
}

//------------------------------------------------------------------------------
bool vtkTetMarchSmartVolumeMapper::TraceRay(
  vtkVolume* volume, int x, int y, int arithmetic, vtkTable* cells)
{
  std::string error;
  if (tetmarch::StructuredBlock* block = this->Internal->onlyBlock(error))
  {
    error = tetmarch::traceRay(block->Pipeline, this->Internal->State, { volume, x, y, arithmetic },
      block->Origins, this->Internal->Blocks.isTree(), cells);
  }
  return this->Report(error);
}

//------------------------------------------------------------------------------
bool vtkTetMarchSmartVolumeMapper::Report(const std::string& error)
{
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
  }
  return error.empty();
}

//------------------------------------------------------------------------------
void vtkTetMarchSmartVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LockSampleDistanceToInputSpacing: " << this->LockSampleDistanceToInputSpacing
     << "\n";
  os << indent << "UseJittering: " << this->UseJittering << "\n";
  os << indent << "PickedPosition: " << this->PickedPosition[0] << ", " << this->PickedPosition[1]
     << ", " << this->PickedPosition[2] << "\n";
  os << indent << "PickedScalar: " << this->PickedScalar << "\n";
  os << indent << "PickedCellId: " << this->PickedCellId << "\n";
  os << indent << "PickedBlock: " << this->PickedBlock << "\n";
  os << indent << "Settings: " << this->GetSettings() << "\n";
  this->GetSettings()->PrintSelf(os, indent.GetNextIndent());
  os << indent << "LastFrameStatistics: " << this->GetLastFrameStatistics() << "\n";
  this->GetLastFrameStatistics()->PrintSelf(os, indent.GetNextIndent());
}
