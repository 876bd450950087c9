// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Images and rectilinear grids that a mapper draws: one, or the blocks of a tree.
#ifndef TetMarchMapperStructuredBlocks_h
#define TetMarchMapperStructuredBlocks_h

#include "Blocks/CellOrigins.h"
#include "GL/LatticeTextures.h"
#include "GL/Pipeline.h"
#include "Mapper/MapperOptions.h"
#include "Volume/StructuredVolume.h"

#include <memory>
#include <string>
#include <vector>

class vtkDataObject;
class vtkRenderer;
class vtkVolume;

namespace tetmarch
{

struct Block;

/** One of them, with all that draws it. */
struct StructuredBlock
{
  vtkDataSet* Data = nullptr;
  FoundScalars Scalars;
  CellOrigins Origins; // of its cells in the input
  StructuredVolume Volume;
  LatticeTextures Textures{ Volume };
  tetmarch::Pipeline Pipeline{ Volume, Textures };
};

/** Each block keeps what it has made as long as it has the same place among the others. */
class StructuredBlocks
{
public:
  /** Find what there is to draw of the input: of a tree the images and rectilinear grids that have
   * the chosen array. Returns an empty string, or what is wrong and what to do. What the GPU held
   * for blocks that are no more is freed, in the context of its window. */
  std::string update(vtkDataObject* input, const ScalarSelection& selection);

  /** In the order of the input. */
  const std::vector<std::unique_ptr<StructuredBlock>>& all() const { return this->Blocks; }
  bool isTree() const { return this->OfTree; }
  /** Empty, or which blocks are left out, since they are others or lack the array. */
  const std::string& omissions() const { return this->Omissions; }

  /** In the order in which they are drawn (Blocks/BlockOrder.h). */
  std::vector<StructuredBlock*> backToFront(vtkRenderer* renderer, vtkVolume* volume) const;

  /** Free what is held on the GPU of that window. */
  void releaseIfHeldBy(vtkWindow* window);
  /** Forget all blocks, and free what is held on any GPU. */
  void clear() { this->keep(0); }

private:
  std::string find(
    vtkDataObject* input, const ScalarSelection& selection, std::vector<Block>& found);
  void keep(std::size_t count);

  std::vector<std::unique_ptr<StructuredBlock>> Blocks;
  bool OfTree = false;
  std::string Omissions;
};

} // namespace tetmarch

#endif
