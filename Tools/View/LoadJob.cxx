// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LoadJob.h"

#include "DatasetReader.h"
#include "ErrorText.h"
#include "Failure.h"
#include "RawImage.h"
#include "SameMesh.h"

#include "vtkAbstractArray.h"
#include "vtkAbstractVolumeMapper.h"
#include "vtkNew.h"
#include "vtkTable.h"
#include "vtkTetMarchSettings.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

#include <algorithm>

namespace
{
using namespace tetmarch;

VolumeData ReadData(const DataState& wanted, const ProgressReport& report)
{
  const std::optional<int> step =
    wanted.TimeStep >= 0 ? std::optional<int>(wanted.TimeStep) : std::nullopt;
  const RawOptions raw =
    IsRawFile(wanted.File) ? CompleteRawOptions({}, wanted.File) : RawOptions();
  return ReadVolume(wanted.File, step, raw, { wanted.Array, wanted.Association }, report);
}

std::vector<ArrayName> ListArrays(vtkTetMarchFirstPicture* choice)
{
  std::vector<ArrayName> arrays;
  vtkNew<vtkTable> table;
  choice->ListArrays(table);
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    arrays.push_back({ table->GetValue(row, 0).ToString(),
      table->GetValue(row, 1).ToString() == "cells" ? vtkTetMarchFirstPicture::CELLS
                                                    : vtkTetMarchFirstPicture::POINTS,
      table->GetValue(row, 3).ToInt() });
  }
  return arrays;
}

bool HasCurvedCells(vtkDataSet* block)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(block);
  for (vtkIdType cell = 0; grid && cell < grid->GetNumberOfCells(); ++cell)
  {
    const int type = grid->GetCellType(cell);
    if (type >= VTK_QUADRATIC_EDGE && type != VTK_CONVEX_POINT_SET && type != VTK_POLYHEDRON)
    {
      return true;
    }
  }
  return false;
}

std::shared_ptr<AnyMapper> PrepareMapper(
  const Prepared& volume, double geometryTolerance, const ProgressReport& report)
{
  std::shared_ptr<AnyMapper> mapper = MakeMapper(false);
  mapper->SetInput(volume.Data.GetMapperInput());
  mapper->GetSettings()->SetGeometryTolerance(geometryTolerance);
  // Which of several blocks are drawn depends on it.
  mapper->SelectArray(
    volume.Choice->GetChosenAssociation(), volume.Choice->GetChosenArray()->GetName());
  const ErrorText error(mapper->GetMapper());
  const ProgressBar bar("preparing the mesh", mapper->GetMapper(), report);
  if (!mapper->PrepareMesh())
  {
    if (bar.IsStopped())
    {
      throw Cancelled("the preparation of the mesh was cancelled");
    }
    throw Failure(error.Get());
  }
  return mapper;
}
} // namespace

tetmarch::LoadResult tetmarch::RunJob(const LoadJob& job, const ProgressReport& report)
{
  const DataState& wanted = job.Wanted;
  LoadResult result;
  Prepared& volume = result.Volume;
  volume.Data = job.Read ? *job.Read : ReadData(wanted, report);
  if (!wanted.Surface.empty())
  {
    result.Surface = ReadSurface(wanted.Surface, report);
  }
  if (!report("choosing what to show", 0.0))
  {
    throw Cancelled("the choice was cancelled");
  }
  volume.Choice = vtkSmartPointer<vtkTetMarchFirstPicture>::New();
  const ErrorText error(volume.Choice);
  volume.Choice->SetInputData(volume.Data.Input);
  volume.Choice->SetArrayName(wanted.Array);
  volume.Choice->SetArrayAssociation(wanted.Association);
  volume.Choice->SetComponent(wanted.Component);
  const bool chosen = job.ChooseFunctions ? volume.Choice->Choose() : volume.Choice->ChooseArray();
  if (!chosen)
  {
    throw Failure(error.Get());
  }
  if (!report("counting values", 0.5))
  {
    throw Cancelled("the choice was cancelled");
  }
  volume.Arrays = ListArrays(volume.Choice);
  volume.Values = CountValues(volume.Data, volume.Choice);
  const auto& blocks = volume.Data.Blocks;
  volume.Curved = std::any_of(blocks.begin(), blocks.end(), HasCurvedCells);
  if (!volume.Data.Structured && !HasSameMesh(job.Shown, volume.Data.Input))
  {
    result.Mapper = PrepareMapper(volume, job.GeometryTolerance, report);
  }
  return result;
}
