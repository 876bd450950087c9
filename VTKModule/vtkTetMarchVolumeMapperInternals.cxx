// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchVolumeMapperInternals.h"

#include "Diagnostics/ViewColors.h"
#include "Mapper/FrameMeasures.h"
#include "Mapper/FrameOptions.h"
#include "Mapper/RecordStatistics.h"

//------------------------------------------------------------------------------
vtkTetMarchVolumeMapper::Internals::Internals(vtkTetMarchVolumeMapper* mapper)
  : Settings(mapper)
{
  tetmarch::setViewColors(this->ViewTable);
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::Internals::begin(bool selecting)
{
  vtkTetMarchSettings* settings = this->Settings.get();
  const auto mostBytes = static_cast<std::uint64_t>(settings->GetMaxMemoryInBytes());
  if (selecting)
  {
    this->Pipeline.beginPick(mostBytes);
    this->Level = this->Accuracy.used().level();
  }
  else
  {
    this->Pipeline.begin(mostBytes);
    this->Level = this->Accuracy.begin(tetmarch::accuracyOptionsOf(settings));
    this->Statistics->Clear();
  }
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::Internals::end(
  const tetmarch::FrameOptions& options, bool drawn, double seconds)
{
  vtkTetMarchFrameStatistics* statistics = this->Statistics;
  const tetmarch::Diagnostics& counted = this->Pipeline.counted();
  const double aside = options.Draw.View ? 0.0 : counted.seconds();
  const double ownSeconds = seconds - aside;
  if (drawn)
  {
    tetmarch::takeMeasures(counted, statistics);
    statistics->SetSeconds(ownSeconds);
  }
  statistics->SetUsedImageSampleDistance(options.Draw.SampleDistance);
  if (drawn && options.MarchesPicture && (this->Pipeline.onlyDrew() || !this->Distance.knowsTime()))
  {
    this->Distance.drawn(options.Draw.SampleDistance, ownSeconds);
  }
  this->Accuracy.end({ drawn, options.MarchesPicture && options.Draw.SampleDistance == 1,
    this->Pipeline.onlyDrew(), ownSeconds,
    statistics->GetMaximum(vtkTetMarchFrameStatistics::ERROR_BOUND), this->Pipeline.subject() });
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::Internals::recordStatistics()
{
  tetmarch::recordBlocks(this->Blocks, this->Statistics);
  tetmarch::recordPipeline(this->Pipeline, this->Statistics);
  tetmarch::recordTetrahedra(this->Tets, this->Statistics);
  tetmarch::recordAccuracy(this->Accuracy, this->Statistics);
}
