// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Joins the blocks of a composite data set into one grid, so that rays continue from block to
// block; or makes a grid of a data set of another type.
#ifndef TetMarchBlocksJoinedBlocks_h
#define TetMarchBlocksJoinedBlocks_h

#include "Blocks/BlockArrays.h"
#include "Blocks/BlockList.h"
#include "Blocks/CellOrigins.h"
#include "Caching/StageRecord.h"
#include "Input/LeafGrids.h"

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <string>
#include <vector>

namespace tetmarch
{

class JoinedBlocks
{
public:
  /** Join the blocks that have the chosen array, of trees their leaves. If only the scalars
   * changed, only these are joined again. Returns an empty string, or an error with its remedy; the
   * grid is then null. */
  std::string update(vtkDataObject* input, const ScalarSelection& selection);
  void clear();
  /** The box of the points of these blocks; not initialised if there are none. */
  void findBounds(vtkDataObject* input, double bounds[6]);

  /** Shared points (sharePoints) are merged, unless their scalars have ever differed between
   * blocks: then each block has its own. Null if no block has 3D cells. */
  vtkUnstructuredGrid* grid() const { return this->Grid; }
  vtkDataArray* scalars() const { return this->Scalars; }
  bool hasCellScalars() const { return this->CellScalars; }
  /** The original blocks of the grid's cells. */
  const CellOrigins& origins() const { return this->Origins; }
  /** Empty, or a list of the blocks that lack the array and are left out. */
  const std::string& omissions() const { return this->Omissions; }
  /** The number of joins. */
  const StageRecord& record() const { return this->Record; }

private:
  void joinChanged(vtkDataObject* input, const ScalarSelection& selection);
  std::string choose(const std::vector<Block>& blocks, const ScalarSelection& selection);
  std::string join(const std::vector<Block>& drawn);
  std::string joinScalars(const std::vector<Block>& drawn);
  void joinGrid();
  void joinAttributes();
  std::vector<Block> drawnOf(const std::vector<Block>& blocks);

  Fingerprint Shape;
  Fingerprint ScalarsInput;
  std::string Error;
  std::vector<std::size_t> Drawn; // of the blocks
  SharedBlocks Shared;
  CellOrigins Origins;
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  vtkSmartPointer<vtkDataArray> Scalars;
  bool CellScalars = false;
  std::string Omissions;
  LeafGrids Leaves;
  StageRecord Record;
};

} // namespace tetmarch

#endif
