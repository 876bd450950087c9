// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the stages of a mapper have done, for its vtkTetMarchFrameStatistics.
#ifndef TetMarchMapperRecordStatistics_h
#define TetMarchMapperRecordStatistics_h

class vtkTetMarchFrameStatistics;

namespace tetmarch
{

class AccuracyController;
class JoinedBlocks;
class Pipeline;

/** Runs and seconds of the stages, memory, size of the mesh, counts of the last frame. */
void recordPipeline(const Pipeline& pipeline, vtkTetMarchFrameStatistics* statistics);

void recordBlocks(const JoinedBlocks& blocks, vtkTetMarchFrameStatistics* statistics);

void recordAccuracy(const AccuracyController& controller, vtkTetMarchFrameStatistics* statistics);

} // namespace tetmarch

#endif
