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
#include "Curved/StraightGrid.h"
#include "Input/MadeGrids.h"

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
   * changed, only these are joined again. Curved cells are cut within a tolerance of more than 0
   * (Curved/StraightGrid.h); the progress is that of cutting, after a stop the grid is null.
   * Returns an empty string, or an error with its remedy; the grid is then null. */
  std::string update(vtkDataObject* input, const ScalarSelection& selection,
    const CurvedOptions& curved = {}, const Progress& progress = {});
  void clear();
  /** The box of the points of these blocks, and of their cut cells of the last update();
   * not initialised if there are none. */
  void findBounds(vtkDataObject* input, double bounds[6]);

  /** Shared points (sharePoints) are merged, unless their scalars have ever differed between
   * blocks: then each block has its own. Null if no block has 3D cells. */
  vtkUnstructuredGrid* grid() const { return this->isCut() ? this->Cut.Grid : this->Grid; }
  vtkDataArray* scalars() const { return this->isCut() ? this->Cut.Scalars : this->Scalars; }
  bool hasCellScalars() const { return this->CellScalars; }
  /** How far the grid is from curved cells that were cut for it, if that was measured. */
  CurvedDeparture departure() const { return this->Cut.Departure; }
  /** The original blocks of the grid's cells. */
  const CellOrigins& origins() const { return this->isCut() ? this->CutOrigins : this->Origins; }
  /** Empty, or a list of the blocks that lack the array and are left out. */
  const std::string& omissions() const { return this->Omissions; }
  /** The number of joins. */
  const StageRecord& record() const { return this->Record; }

private:
  void restart(); // but for the leaves of trees
  bool isCut() const { return this->Cut.Grid != nullptr; }
  void joinChanged(vtkDataObject* input, const ScalarSelection& selection,
    const CurvedOptions& curved, const Progress& progress);
  std::string choose(const std::vector<Block>& blocks, const ScalarSelection& selection);
  std::string join(const std::vector<Block>& drawn);
  std::string joinScalars(const std::vector<Block>& drawn);
  std::string cutCurvedCells(const CurvedOptions& options, const Progress& progress);
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
  StraightGrid Cut;
  CellOrigins CutOrigins;
  std::string Omissions;
  MadeGrids Made;
  StageRecord Record;
};

} // namespace tetmarch

#endif
