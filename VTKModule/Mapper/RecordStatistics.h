// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the stages of a mapper have done, for its vtkTetMarchFrameStatistics.
#ifndef TetMarchMapperRecordStatistics_h
#define TetMarchMapperRecordStatistics_h

#include <vector>

class vtkTetMarchFrameStatistics;

namespace tetmarch
{

class AccuracyController;
class JoinedBlocks;
class LeafGrid;
class Pipeline;
struct StructuredBlock;
class TetTextures;
class TetVolume;
struct SharedPicture;

/** Runs and seconds of the stages that every volume has, memory, counts of the last frame. */
void recordPipeline(const Pipeline& pipeline, vtkTetMarchFrameStatistics* statistics);

/** Runs and seconds of the stages of tetrahedra, and the size of the mesh. */
void recordTetrahedra(
  const TetVolume& volume, const TetTextures& textures, vtkTetMarchFrameStatistics* statistics);

/** The sums of both over the blocks. The lattice of cells counts as a mesh. */
void recordStructured(
  const std::vector<const StructuredBlock*>& blocks, vtkTetMarchFrameStatistics* statistics);

/** What drawing together with other processes took in the last frame. */
void recordShared(const SharedPicture& shared, vtkTetMarchFrameStatistics* statistics);

/** Of an adaptive mesh its leaves are made, else blocks are joined. */
void recordBlocks(
  const JoinedBlocks& blocks, const LeafGrid& leaves, vtkTetMarchFrameStatistics* statistics);

void recordAccuracy(const AccuracyController& controller, vtkTetMarchFrameStatistics* statistics);

} // namespace tetmarch

#endif
