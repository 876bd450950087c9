// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Data sets of all kinds with one fault each
 */
#ifndef tetmarch_testing_UnsoundData_h
#define tetmarch_testing_UnsoundData_h

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace tetmarch::testing
{
struct UnsoundData
{
  std::string Name;
  vtkSmartPointer<vtkDataSet> Data;
  std::vector<std::string> Words; // of the error
};

/// What is wrong is the geometry: points, cells, or which of them are hidden.
std::vector<UnsoundData> unsoundGeometries();

/// What is wrong is the length of the only array, "f".
std::vector<UnsoundData> unsoundArrays();

/// The same kinds without a fault, with an array "f" of points, active.
std::vector<vtkSmartPointer<vtkDataSet>> soundData();
} // namespace tetmarch::testing

#endif
