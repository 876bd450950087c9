// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Images that are drawn: named volumes, read or computed
 */
#ifndef tetmarch_bench_StructuredVolumes_h
#define tetmarch_bench_StructuredVolumes_h

#include "Datasets.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace tetmarch::bench
{
struct StructuredVolume
{
  vtkSmartPointer<vtkImageData> Stored; // scalars as in the file
  vtkSmartPointer<vtkImageData> Floats; // the same values in float; the same object if they are
  FunctionRange Range;
  double Voxel = 1.0; // mean of the three spacings
};

/// "bonsai", "aneurism", "headsq", "carotid", "marschner-lobb:N" of N^3 points.
bool isStructuredVolume(const std::string& name);
/// Whether its file, if it has one, is there.
bool isStructuredPresent(const std::string& name, const DataFolders& folders);
/// Throws Failure if a file can't be read.
StructuredVolume makeStructuredVolume(const std::string& name, const DataFolders& folders);
} // namespace tetmarch::bench

#endif
