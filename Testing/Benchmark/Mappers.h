// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The mappers that are compared, set up to draw the same picture
 */
#ifndef tetmarch_bench_Mappers_h
#define tetmarch_bench_Mappers_h

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGridVolumeMapper.h"

#include <string>

namespace tetmarch::bench
{
bool isMapper(const std::string& name);

vtkSmartPointer<vtkUnstructuredGridVolumeMapper> makeMapper(const std::string& name);
} // namespace tetmarch::bench

#endif
