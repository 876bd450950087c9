// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From a file to data that is ready to be drawn. It needs no window, and may run in any thread.
 */
#ifndef tetmarch_LoadJob_h
#define tetmarch_LoadJob_h

#include "AnyMapper.h"
#include "Prepared.h"
#include "ProgressBar.h"
#include "ViewState.h"

#include <memory>
#include <optional>

namespace tetmarch
{

struct LoadJob
{
  DataState Wanted;
  /// Data of that file and time step, if it was read already.
  std::optional<VolumeData> Read;
  /// Whether transfer functions are chosen. If not, the array alone is.
  bool ChooseFunctions = true;
  /// The mapper's setting, with which the mesh is prepared.
  double GeometryTolerance = 0.0;
  /// Data whose mesh is prepared: another one with the same mesh needs no preparation. Null: none.
  vtkSmartPointer<vtkDataObject> Shown;
};

struct LoadResult
{
  Prepared Volume;
  vtkSmartPointer<vtkPolyData> Surface; // null: none was asked for
  /// Has prepared the mesh. Null: what was drawn has the same one, or there is none to prepare.
  std::shared_ptr<AnyMapper> Mapper;
};

/// Throws Failure that says what is wrong, and Cancelled if the report asks to stop.
LoadResult RunJob(const LoadJob& job, const ProgressReport& report);

} // namespace tetmarch

#endif
