// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The meshes that are drawn, made or read
 */
#ifndef tetmarch_bench_Datasets_h
#define tetmarch_bench_Datasets_h

#include "Functions.h"

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <functional>
#include <optional>
#include <string>

namespace tetmarch::bench
{
struct DataFolders
{
  std::string Own;    // golfball_small.vtu, golfball_wake.json
  std::string Others; // golfball/golfball_medium.vtu, unstructured/...; may be absent
};

/// The scalar at a point of the unit cube that the values of a mesh were taken from.
using ExactField = std::function<double(double x, double y, double z)>;

struct Dataset
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid; // tetrahedra, with no array but that
  std::string Array;                         // of the points
  FunctionRange Range;
  vtkSmartPointer<vtkVolumeProperty> Own; // nullptr: none
  /// Set if errors are to be those against the field itself, so that of the mesh is in them.
  std::optional<ExactField> Exact;
};

bool isDataset(const std::string& name);
/// Whether its file, if it has one among others' data, is there.
bool isPresent(const std::string& name, const DataFolders& folders);
/// Throws Failure if a file can't be read.
Dataset makeDataset(const std::string& name, const DataFolders& folders);
/// The grid with no array but that one of its points, as its scalars. Throws Failure without it.
vtkSmartPointer<vtkUnstructuredGrid> withOnly(vtkUnstructuredGrid* grid, const std::string& array);
} // namespace tetmarch::bench

#endif
