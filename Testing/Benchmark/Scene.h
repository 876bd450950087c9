// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What is drawn: a grid with one array, transfer functions, a unit distance
 */
#ifndef tetmarch_bench_Scene_h
#define tetmarch_bench_Scene_h

#include "Datasets.h"

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <string>

namespace tetmarch::bench
{
/// A dataset with the functions it is seen through.
struct Subject
{
  std::string Dataset;
  std::string Functions;
};

struct Scene
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid; // tetrahedra, with no array but that
  std::string Array;                         // of the points
  vtkSmartPointer<vtkVolumeProperty> Property;
  FunctionRange Range;
  std::optional<ExactField> Exact;
  std::string Name;        // of the dataset
  std::string CacheFolder; // for what is made of the grid alone; empty: none
};

/// Throws Failure if a file can't be read, or if the dataset has no functions of its own.
Scene makeScene(const Subject& subject, const DataFolders& folders);
} // namespace tetmarch::bench

#endif
