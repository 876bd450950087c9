// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What of a file is drawn.
 */
#ifndef tetmarch_VolumeData_h
#define tetmarch_VolumeData_h

#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tetmarch
{

/// The array that the user asks for, and what it is between its values.
struct WantedArray
{
  std::string Name;        // empty: any
  int Association = -1;    // as vtkTetMarchFirstPicture::Associations
  bool Continuous = false; // of an adaptive mesh: linear between the centres of leaves
};

struct VolumeData
{
  /// An unstructured or curvilinear grid, an image, a rectilinear grid, a tree of the latter two,
  /// or AMR.
  vtkSmartPointer<vtkDataObject> Input;
  /// The blocks of the tree, or the only one.
  std::vector<vtkDataSet*> Blocks;
  /// Images and rectilinear grids.
  bool Structured = false;
  /// Whether the file has leaves of several levels.
  bool Adaptive = false;
  /// Of the file, and the one that was read. No times: the file has no time steps.
  std::vector<double> Times{};
  int TimeStep = 0;
  /// The vtkHyperTreeGrid whose leaves are the cells of the input; or null.
  vtkSmartPointer<vtkDataObject> HyperTree{};

  /// Of the mapper, which marches through the leaves of a tree.
  vtkDataObject* GetMapperInput() const
  {
    return this->HyperTree ? this->HyperTree : this->Input;
  }
};

/// Of an image or a rectilinear grid.
bool IsStructured(vtkDataObject* data);

/// Samples along each axis of an image or a rectilinear grid.
void GetDimensions(vtkDataSet* data, int dimensions[3]);

/// Of all blocks: xmin, xmax, ymin, ymax, zmin, zmax.
std::array<double, 6> GetBounds(const VolumeData& volume);

/// The mean distance of samples over the axes, and over the blocks of images or rectilinear grids.
double GetMeanSpacing(const VolumeData& volume);

} // namespace tetmarch

#endif
