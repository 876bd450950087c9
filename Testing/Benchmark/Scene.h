// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What is drawn: a grid with one array, transfer functions, a unit distance
 */
#ifndef tetmarch_bench_Scene_h
#define tetmarch_bench_Scene_h

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <string>

namespace tetmarch::bench
{
struct Scene
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid; // tetrahedra
  std::string Array;                         // of the points
  vtkSmartPointer<vtkVolumeProperty> Property;
};

bool isDataset(const std::string& name);

/// Throws Failure if the golf ball's files can't be read.
Scene makeScene(const std::string& dataset, const std::string& dataFolder);
} // namespace tetmarch::bench

#endif
