// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One volume, or one surface, from whatever a file holds.
 */
#ifndef tetmarch_DatasetReader_h
#define tetmarch_DatasetReader_h

#include "ProgressBar.h"
#include "RawImage.h"
#include "VolumeData.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <optional>
#include <string>
#include <vector>

namespace tetmarch
{

/**
 * An image, a rectilinear grid, several of these or AMR as they are, of trees the leaves; else all
 * blocks with 3D cells as ReadUnstructuredGrid() has them. Blocks that are surfaces, or have no 3D
 * cells, are left out. Options of raw files must be complete. Throws Failure that says what is
 * wrong with the file, and Cancelled if the report asks to stop.
 */
VolumeData ReadVolume(const std::string& path, std::optional<int> timeStep,
  const RawOptions& rawOptions = {}, const WantedArray& wanted = {},
  const ProgressReport& report = {});

/**
 * All blocks with 3D cells, merged where their points coincide, without ghost cells; images and
 * structured grids as hexahedra. An array that some of the blocks lack is left out with a warning;
 * if it is the wanted one, or if no array is in all blocks, these blocks are. Throws Failure that
 * says what is wrong with the file.
 */
vtkSmartPointer<vtkUnstructuredGrid> ReadUnstructuredGrid(
  const std::string& path, std::optional<int> timeStep, const WantedArray& wanted = {});

/// All that is wrong with what a file holds, one fault of a block or of an array each. Throws
/// Failure if it can't be read, or holds no volume.
std::vector<std::string> ListFaults(
  const std::string& path, std::optional<int> timeStep, const RawOptions& rawOptions = {});

/// Polygons and triangle strips of polydata. Throws Failure that says what is wrong with the file,
/// and Cancelled if the report asks to stop.
vtkSmartPointer<vtkPolyData> ReadSurface(
  const std::string& path, const ProgressReport& report = {});

/// Whether any cell is three-dimensional.
bool HasSolidCells(vtkDataSet* data);

} // namespace tetmarch

#endif
