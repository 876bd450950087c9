// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mapper/RecordStatistics.h"

#include "Blocks/JoinedBlocks.h"
#include "Budget/AccuracyController.h"
#include "GL/Pipeline.h"
#include "GL/TetTextures.h"
#include "Leaves/LeafGrid.h"
#include "Mapper/StructuredBlocks.h"
#include "Processes/SharedPicture.h"
#include "Volume/TetVolume.h"

#include "vtkTetMarchFrameStatistics.h"
#include "vtkTetMarchSettings.h"

namespace tetmarch
{
namespace
{

using Pipelines = std::vector<const Pipeline*>;

// The sum of a figure over all pipelines.
template <typename Figure>
auto sumOf(const Pipelines& pipelines, const Figure& figure)
{
  decltype(figure(*pipelines.front())) sum{};
  for (const Pipeline* pipeline : pipelines)
  {
    sum += figure(*pipeline);
  }
  return sum;
}

// Seconds and runs of a stage.
template <typename RecordOf>
StageRecord recordOf(const Pipelines& pipelines, const RecordOf& recordOfOne)
{
  StageRecord record;
  record.Seconds = sumOf(pipelines, [&](const Pipeline& p) { return recordOfOne(p).Seconds; });
  record.Runs = sumOf(pipelines, [&](const Pipeline& p) { return recordOfOne(p).Runs; });
  return record;
}

void recordStages(const Pipelines& pipelines, vtkTetMarchFrameStatistics* statistics)
{
  const StageRecord tables =
    recordOf(pipelines, [](const Pipeline& p) { return p.stages().tables().record(); });
  statistics->SetTablesSeconds(tables.Seconds);
  statistics->SetTablesBuilds(tables.Runs);
  const StageRecord gradients =
    recordOf(pipelines, [](const Pipeline& p) { return p.stages().effects().gradientsRecord(); });
  statistics->SetGradientsSeconds(gradients.Seconds);
  statistics->SetGradientsBuilds(gradients.Runs);
  const StageRecord shadows = recordOf(
    pipelines, [](const Pipeline& p) { return p.stages().effects().opaqueShadowsRecord(); });
  statistics->SetOpaqueShadowsSeconds(shadows.Seconds);
  statistics->SetOpaqueShadowsBuilds(shadows.Runs);
  const StageRecord light =
    recordOf(pipelines, [](const Pipeline& p) { return p.vertexLightRecord(); });
  statistics->SetVertexLightSeconds(light.Seconds);
  statistics->SetVertexLightBuilds(light.Runs);
  // All blocks have the same lights.
  static const LightUniforms none;
  const LightUniforms& lights =
    pipelines.empty() ? none : pipelines.front()->stages().effects().data().Lights;
  statistics->SetLightsWithoutShadows(lights.ShadowlessLights);
  statistics->SetLightsLeftOut(lights.LightsLeftOut);
  const StageRecord upload =
    recordOf(pipelines, [](const Pipeline& p) { return p.uploadRecord(); });
  statistics->SetUploadSeconds(upload.Seconds);
}

void recordCounters(const Pipelines& pipelines, vtkTetMarchFrameStatistics* statistics)
{
  const auto count = [&](std::int64_t MarchCounters::*counter)
  { return sumOf(pipelines, [=](const Pipeline& p) { return p.counted().counters().*counter; }); };
  statistics->SetNumberOfRays(count(&MarchCounters::Rays));
  statistics->SetNumberOfCrossedCells(count(&MarchCounters::Cells));
  statistics->SetNumberOfLookups(count(&MarchCounters::Lookups));
  statistics->SetNumberOfRefusedEntries(count(&MarchCounters::Refused));
  statistics->SetNumberOfLostRays(count(&MarchCounters::Lost));
  statistics->SetNumberOfGuardHits(count(&MarchCounters::Guarded));
  statistics->SetNumberOfTracedRays(
    sumOf(pipelines, [](const Pipeline& p) { return p.tracedRays(); }));
}

void recordPipelines(const Pipelines& pipelines, vtkTetMarchFrameStatistics* statistics)
{
  recordStages(pipelines, statistics);
  recordCounters(pipelines, statistics);
  statistics->SetGPUMemoryBytes(
    static_cast<vtkTypeInt64>(sumOf(pipelines, [](const Pipeline& p) { return p.gpuBytes(); })));
  statistics->SetUploadedBytes(
    sumOf(pipelines, [](const Pipeline& p) { return p.uploadedBytes(); }));
  statistics->SetNumberOfDraws(
    sumOf(pipelines, [](const Pipeline& p) { return p.numberOfDraws(); }));
  const bool byCompute =
    sumOf(pipelines, [](const Pipeline& p) { return p.isByCompute() ? 1 : 0; }) > 0;
  statistics->SetUsedShaderStage(
    byCompute ? vtkTetMarchSettings::COMPUTE_STAGE : vtkTetMarchSettings::FRAGMENT_STAGE);
  statistics->SetLightComplete(
    sumOf(pipelines, [](const Pipeline& p) { return p.isLightComplete() ? 0 : 1; }) == 0);
}

} // namespace

void recordPipeline(const Pipeline& pipeline, vtkTetMarchFrameStatistics* statistics)
{
  recordPipelines({ &pipeline }, statistics);
}

void recordStructured(
  const std::vector<const StructuredBlock*>& blocks, vtkTetMarchFrameStatistics* statistics)
{
  Pipelines pipelines;
  StageRecord lattices;
  StageRecord values;
  std::uint64_t cells = 0;
  for (const StructuredBlock* block : blocks)
  {
    pipelines.push_back(&block->Pipeline);
    const StructuredVolume& volume = block->Volume;
    lattices.Seconds += volume.latticeRecord().Seconds;
    lattices.Runs += volume.latticeRecord().Runs;
    values.Seconds += volume.valuesRecord().Seconds + volume.rangesRecord().Seconds;
    values.Runs += volume.valuesRecord().Runs;
    cells += volume.numberOfCells();
  }
  recordPipelines(pipelines, statistics);
  statistics->SetMeshSeconds(lattices.Seconds);
  statistics->SetMeshBuilds(lattices.Runs);
  statistics->SetScalarsSeconds(values.Seconds);
  statistics->SetScalarsBuilds(values.Runs);
  statistics->SetNumberOfLatticeCells(static_cast<vtkTypeInt64>(cells));
}

void recordShared(const SharedPicture& shared, vtkTetMarchFrameStatistics* statistics)
{
  statistics->SetNumberOfVisits(static_cast<vtkTypeInt64>(shared.Visits));
  statistics->SetSentBytes(static_cast<vtkTypeInt64>(shared.SentBytes));
  statistics->SetMarchSeconds(shared.MarchSeconds);
  statistics->SetExchangeSeconds(shared.Exchange.ExchangeSeconds);
  statistics->SetMergeSeconds(shared.Exchange.MergeSeconds);
  statistics->SetSpreadSeconds(shared.Exchange.SpreadSeconds);
  statistics->SetSharedErrorBound(shared.WorstError);
}

void recordTetrahedra(
  const TetVolume& volume, const TetTextures& textures, vtkTetMarchFrameStatistics* statistics)
{
  statistics->SetMeshSeconds(volume.meshRecord().Seconds);
  statistics->SetMeshBuilds(volume.meshRecord().Runs);
  statistics->SetScalarsSeconds(volume.scalarsRecord().Seconds);
  statistics->SetScalarsBuilds(volume.scalarsRecord().Runs);
  statistics->SetVisiblePartSeconds(volume.visibleRecord().Seconds);
  statistics->SetVisiblePartBuilds(volume.visibleRecord().Runs);
  statistics->SetEntriesSeconds(textures.entriesRecord().Seconds);
  statistics->SetEntriesBuilds(textures.entriesRecord().Runs);
  statistics->SetNumberOfLatticeCells(0);
  statistics->SetNumberOfTetrahedra(volume.mesh().numberOfTets());
  statistics->SetNumberOfBoundaryFaces(static_cast<vtkIdType>(volume.mesh().BoundaryFaces.size()));
}

void recordBlocks(
  const JoinedBlocks& blocks, const LeafGrid& leaves, vtkTetMarchFrameStatistics* statistics)
{
  const StageRecord& last = leaves.places() ? leaves.record() : blocks.record();
  statistics->SetBlocksSeconds(last.Seconds);
  statistics->SetBlocksBuilds(blocks.record().Runs + leaves.record().Runs);
}

void recordAccuracy(const AccuracyController& controller, vtkTetMarchFrameStatistics* statistics)
{
  statistics->SetUsedAccuracyLevel(static_cast<int>(controller.used().Level));
  statistics->SetUsedErrorTolerance(controller.used().Tolerance);
  statistics->SetUsedPixelTolerance(controller.used().PixelTolerance);
  statistics->SetBudgetKept(controller.isKept());
}

} // namespace tetmarch
