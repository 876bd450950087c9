// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mapper/RecordStatistics.h"

#include "Blocks/JoinedBlocks.h"
#include "Budget/AccuracyController.h"
#include "GL/Pipeline.h"
#include "GL/TetSource.h"

#include "vtkTetMarchFrameStatistics.h"

namespace tetmarch
{
namespace
{

void recordStages(const Pipeline& pipeline, vtkTetMarchFrameStatistics* statistics)
{
  const EffectStage& effects = pipeline.effects();
  statistics->SetTablesSeconds(pipeline.tablesRecord().Seconds);
  statistics->SetTablesBuilds(pipeline.tablesRecord().Runs);
  statistics->SetGradientsSeconds(effects.gradientsRecord().Seconds);
  statistics->SetGradientsBuilds(effects.gradientsRecord().Runs);
  statistics->SetOpaqueShadowsSeconds(effects.opaqueShadowsRecord().Seconds);
  statistics->SetOpaqueShadowsBuilds(effects.opaqueShadowsRecord().Runs);
  statistics->SetVertexLightSeconds(pipeline.vertexLightRecord().Seconds);
  statistics->SetVertexLightBuilds(pipeline.vertexLightRecord().Runs);
  statistics->SetUploadSeconds(pipeline.uploadRecord().Seconds);
}

void recordCounters(const MarchCounters& counters, vtkTetMarchFrameStatistics* statistics)
{
  statistics->SetNumberOfRays(counters.Rays);
  statistics->SetNumberOfCrossedCells(counters.Cells);
  statistics->SetNumberOfLookups(counters.Lookups);
  statistics->SetNumberOfRefusedEntries(counters.Refused);
  statistics->SetNumberOfLostRays(counters.Lost);
  statistics->SetNumberOfGuardHits(counters.Guarded);
}

} // namespace

void recordPipeline(const Pipeline& pipeline, vtkTetMarchFrameStatistics* statistics)
{
  recordStages(pipeline, statistics);
  recordCounters(pipeline.counted().counters(), statistics);
  statistics->SetGPUMemoryBytes(static_cast<vtkTypeInt64>(pipeline.gpuBytes()));
  statistics->SetUploadedBytes(pipeline.uploadedBytes());
  statistics->SetNumberOfDraws(pipeline.numberOfDraws());
  statistics->SetLightComplete(pipeline.isLightComplete());
}

void recordTetrahedra(const TetSource& source, vtkTetMarchFrameStatistics* statistics)
{
  statistics->SetMeshSeconds(source.meshRecord().Seconds);
  statistics->SetMeshBuilds(source.meshRecord().Runs);
  statistics->SetScalarsSeconds(source.scalarsRecord().Seconds);
  statistics->SetScalarsBuilds(source.scalarsRecord().Runs);
  statistics->SetNumberOfTetrahedra(source.mesh().numberOfTets());
  statistics->SetNumberOfBoundaryFaces(static_cast<vtkIdType>(source.mesh().BoundaryFaces.size()));
}

void recordBlocks(const JoinedBlocks& blocks, vtkTetMarchFrameStatistics* statistics)
{
  statistics->SetBlocksSeconds(blocks.record().Seconds);
  statistics->SetBlocksBuilds(blocks.record().Runs);
}

void recordAccuracy(const AccuracyController& controller, vtkTetMarchFrameStatistics* statistics)
{
  statistics->SetUsedAccuracyLevel(static_cast<int>(controller.used().Level));
  statistics->SetUsedErrorTolerance(controller.used().Tolerance);
  statistics->SetBudgetKept(controller.isKept());
}

} // namespace tetmarch
