// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics.h"

#include "Failure.h"
#include "Mesh/GridVersions.h"
#include "OffscreenWindow.h"

#include "vtkTetMarchFrameStatistics.h"
#include "vtkTetMarchVolumeMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersion.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <map>

namespace
{
std::map<std::string, vtkIdType> CountCells(vtkUnstructuredGrid* grid)
{
  std::map<std::string, vtkIdType> counts;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    ++counts[tetmarch::nameOfCellType(grid->GetCellType(cell))];
  }
  return counts;
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

std::string FormatStatistics(const CommandLine& commandLine, vtkUnstructuredGrid* grid,
  const ArraySelection& selection, double unitDistance, vtkTetMarchVolumeMapper* mapper,
  vtkRenderWindow* window, const Timing& timing)
{
  double range[2];
  selection.Array->GetRange(range, selection.Component);
  const GLInformation gl = GetGLInformation(window);
  nlohmann::ordered_json json;
  json["input"] = commandLine.Input;
  json["output"] = commandLine.Output;
  json["size"] = commandLine.Size;
  json["array"] = { { "name", selection.Array->GetName() },
    { "association", selection.Where == Association::POINTS ? "points" : "cells" },
    { "components", selection.Array->GetNumberOfComponents() },
    { "component",
      selection.Component < 0 ? nlohmann::json("magnitude") : nlohmann::json(selection.Component) },
    { "range", { range[0], range[1] } } };
  json["unit_distance"] = unitDistance;
  json["cells"] = CountCells(grid);
  json["points"] = grid->GetNumberOfPoints();
  json["tetrahedra"] = mapper->GetNumberOfTetrahedra();
  json["boundary_faces"] = mapper->GetNumberOfBoundaryFaces();
  json["gpu_bytes"] = mapper->GetGPUMemoryBytes();
  json["seconds"] = { { "read", timing.Read }, { "mesh", mapper->GetMeshSeconds() },
    { "scalars", mapper->GetScalarsSeconds() }, { "tables", mapper->GetTablesSeconds() },
    { "upload", mapper->GetUploadSeconds() }, { "first_frame", timing.FirstFrame } };
  if (commandLine.Light.Shade)
  {
    json["seconds"]["gradients"] = mapper->GetGradientsSeconds();
    json["seconds"]["opaque_shadows"] = mapper->GetOpaqueShadowsSeconds();
    json["seconds"]["vertex_light"] = mapper->GetVertexLightSeconds();
  }
  json["frames"] = { { "count", timing.Frames.size() },
    { "median_seconds", GetMedian(timing.Frames) }, { "seconds", timing.Frames } };
  json["accuracy"] = { { "level", mapper->GetUsedAccuracyLevelAsString() },
    { "tolerance", mapper->GetUsedErrorTolerance() } };
  if (commandLine.FrameTime > 0.0 || commandLine.Error > 0.0)
  {
    json["budget"] = { { "frame_time", commandLine.FrameTime }, { "error", commandLine.Error },
      { "kept", mapper->IsBudgetKept() } };
  }
  if (commandLine.Compare)
  {
    json["pixels"] = DescribePixels(mapper->GetLastFrameStatistics());
  }
  json["gl"] = { { "backend", gl.Backend }, { "vendor", gl.Vendor }, { "renderer", gl.Renderer },
    { "version", gl.Version } };
  json["vtk_version"] = vtkVersion::GetVTKVersion();
  json["tetmarch_version"] = TETMARCH_VERSION;
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void WriteText(const std::string& path, const std::string& text)
{
  std::ofstream file(path);
  file << text;
  file.close();
  if (!file)
  {
    throw Failure("cannot write '" + path + "'");
  }
}

} // namespace tetmarch
