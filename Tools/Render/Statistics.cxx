// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics.h"

#include "Failure.h"
#include "Input/GridVersions.h"
#include "OffscreenWindow.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkTetMarchFirstPicture.h"
#include "vtkTetMarchFrameStatistics.h"
#include "vtkVersion.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace
{
using tetmarch::VolumeData;

std::map<std::string, vtkIdType> CountCells(const VolumeData& data)
{
  std::map<std::string, vtkIdType> counts;
  for (vtkDataSet* block : data.Blocks)
  {
    if (data.Structured)
    {
      counts[tetmarch::nameOfCellType(VTK_VOXEL)] += block->GetNumberOfCells();
      continue;
    }
    for (vtkIdType cell = 0; cell < block->GetNumberOfCells(); ++cell)
    {
      ++counts[tetmarch::nameOfCellType(block->GetCellType(cell))];
    }
  }
  return counts;
}

vtkIdType CountPoints(const VolumeData& data)
{
  vtkIdType count = 0;
  for (vtkDataSet* block : data.Blocks)
  {
    count += block->GetNumberOfPoints();
  }
  return count;
}

/// What rays march through.
void AddSizes(
  nlohmann::ordered_json& json, const VolumeData& data, vtkTetMarchFrameStatistics* statistics)
{
  json["cells"] = CountCells(data);
  json["points"] = CountPoints(data);
  if (data.Structured || statistics->GetNumberOfLatticeCells() > 0)
  {
    json["blocks"] = data.Blocks.size();
    json["lattice_cells"] = statistics->GetNumberOfLatticeCells();
  }
  else
  {
    json["tetrahedra"] = statistics->GetNumberOfTetrahedra();
    json["boundary_faces"] = statistics->GetNumberOfBoundaryFaces();
  }
  json["gpu_bytes"] = statistics->GetGPUMemoryBytes();
}
} // namespace

namespace tetmarch
{

double GetMedian(std::vector<double> values)
{
  if (values.empty())
  {
    return 0.0;
  }
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

nlohmann::ordered_json DescribePixels(vtkTetMarchFrameStatistics* statistics)
{
  nlohmann::ordered_json json;
  for (const auto& [quantity, name] :
    { std::pair<int, const char*>{ vtkTetMarchFrameStatistics::TRUE_ERROR, "error" },
      { vtkTetMarchFrameStatistics::ERROR_BOUND, "error_bound" },
      { vtkTetMarchFrameStatistics::CELLS, "cells" },
      { vtkTetMarchFrameStatistics::LOOKUPS, "lookups" } })
  {
    json[name] = { { "count", statistics->GetNumberOfPixels(quantity) },
      { "mean", statistics->GetMean(quantity) }, { "rms", statistics->GetRootMeanSquare(quantity) },
      { "p99.9", statistics->GetPercentile(quantity, 99.9) },
      { "max", statistics->GetMaximum(quantity) } };
  }
  return json;
}

std::string FormatStatistics(const CommandLine& commandLine, const VolumeData& data,
  vtkTetMarchFirstPicture* choice, vtkTetMarchFrameStatistics* statistics, vtkRenderWindow* window,
  const Timing& timing)
{
  const int component = choice->GetChosenComponent();
  std::array<double, 2> range;
  choice->GetDataRange(range.data());
  const GLInformation gl = GetGLInformation(window);
  nlohmann::ordered_json json;
  json["input"] = commandLine.Input;
  json["output"] = commandLine.Output;
  json["size"] = commandLine.Size;
  json["array"] = { { "name", choice->GetChosenArray()->GetName() },
    { "association",
      choice->GetChosenAssociation() == vtkTetMarchFirstPicture::POINTS ? "points" : "cells" },
    { "components", choice->GetChosenArray()->GetNumberOfComponents() },
    { "component", component < 0 ? nlohmann::json("magnitude") : nlohmann::json(component) },
    { "range", range[0] <= range[1] ? nlohmann::json(range) : nlohmann::json() } };
  json["unit_distance"] = choice->GetUnitDistance();
  AddSizes(json, data, statistics);
  json["seconds"] = { { "read", timing.Read },
    { data.Structured ? "lattice" : "mesh", statistics->GetMeshSeconds() },
    { "scalars", statistics->GetScalarsSeconds() }, { "tables", statistics->GetTablesSeconds() },
    { "upload", statistics->GetUploadSeconds() }, { "first_frame", timing.FirstFrame } };
  if (!data.Structured)
  {
    json["seconds"]["visible_part"] = statistics->GetVisiblePartSeconds();
    json["seconds"]["entries"] = statistics->GetEntriesSeconds();
  }
  if (commandLine.Light.Shade)
  {
    json["seconds"]["gradients"] = statistics->GetGradientsSeconds();
    json["seconds"]["opaque_shadows"] = statistics->GetOpaqueShadowsSeconds();
    json["seconds"]["vertex_light"] = statistics->GetVertexLightSeconds();
    json["lights"] = { { "left_out", statistics->GetLightsLeftOut() },
      { "without_shadows", statistics->GetLightsWithoutShadows() } };
  }
  json["frames"] = { { "count", timing.Frames.size() },
    { "median_seconds", GetMedian(timing.Frames) }, { "seconds", timing.Frames } };
  json["accuracy"] = { { "level", statistics->GetUsedAccuracyLevelAsString() },
    { "tolerance", statistics->GetUsedErrorTolerance() },
    { "pixel_tolerance", statistics->GetUsedPixelTolerance() } };
  const double frameTime = commandLine.Settings->GetFrameTimeBudget();
  const double error = commandLine.Settings->GetErrorBudget();
  if (frameTime > 0.0 || error > 0.0)
  {
    json["budget"] = { { "frame_time", frameTime }, { "error", error },
      { "kept", statistics->GetBudgetKept() } };
  }
  if (commandLine.Compare)
  {
    json["pixels"] = DescribePixels(statistics);
  }
  json["gl"] = { { "backend", gl.Backend }, { "vendor", gl.Vendor }, { "renderer", gl.Renderer },
    { "version", gl.Version } };
  json["vtk_version"] = vtkVersion::GetVTKVersion();
  json["tetmarch_version"] = TETMARCH_VERSION;
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace tetmarch
