// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The ray of one pixel as JSON.
#include "PixelTrace.h"

#include "vtkTetMarchFrameStatistics.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"

#include <nlohmann/json.hpp>

namespace tetmarch
{
namespace
{
using Json = nlohmann::ordered_json;

// A number, or a list of several. JSON has null for what is not a number.
Json DescribeTuple(vtkDataArray* array, vtkIdType tuple)
{
  const bool whole = array->GetDataType() != VTK_DOUBLE;
  Json numbers = Json::array();
  for (int k = 0; k < array->GetNumberOfComponents(); ++k)
  {
    const double number = array->GetComponent(tuple, k);
    numbers.push_back(whole ? Json(static_cast<vtkIdType>(number)) : Json(number));
  }
  return numbers.size() == 1 ? numbers[0] : numbers;
}

Json DescribeCells(vtkTable* cells, bool structured)
{
  const std::pair<const char*, const char*> columns[] = { { "cell", "CellId" },
    { "block", "Block" }, { structured ? "lattice_cell" : "tetrahedron", "Tetrahedron" },
    { "enter", "Enter" }, { "leave", "Leave" }, { "begin", "Begin" }, { "end", "End" },
    { "scalar_enter", "ScalarEnter" }, { "scalar_leave", "ScalarLeave" }, { "opacity", "Opacity" },
    { "lookups", "Lookups" }, { "color", "Color" }, { "error_bound", "ErrorBound" } };
  Json json = Json::array();
  for (vtkIdType row = 0; row < cells->GetNumberOfRows(); ++row)
  {
    Json cell;
    for (const auto& [key, column] : columns)
    {
      cell[key] = DescribeTuple(vtkDataArray::SafeDownCast(cells->GetColumnByName(column)), row);
    }
    cell["enters_mesh"] = GetCellValue(cells, "EntersMesh", row) != 0.0;
    cell["outcome"] = cells->GetValueByName(row, "Outcome").ToString();
    json.push_back(cell);
  }
  return json;
}

Json DescribeRay(vtkTable* cells, bool structured)
{
  constexpr std::pair<const char*, const char*> facts[] = { { "color", "Color" },
    { "error_bound", "ErrorBound" }, { "lookups", "Lookups" },
    { "refused_entries", "RefusedEntries" }, { "lost_rays", "LostRays" },
    { "guard_hits", "GuardHits" } };
  Json json;
  for (const auto& [key, name] : facts)
  {
    json[key] = DescribeTuple(cells->GetFieldData()->GetArray(name), 0);
  }
  json["opaque"] = GetRayValue(cells, "Opaque") != 0.0;
  json["cells"] = DescribeCells(cells, structured);
  return json;
}

Json DescribeDifference(const std::array<double, 4>& a, const std::array<double, 4>& b)
{
  Json json = Json::array();
  for (int k = 0; k < 4; ++k)
  {
    json.push_back(a[k] - b[k]);
  }
  return json;
}
} // namespace

std::string FormatPixelJson(const CommandLine& commandLine, const std::string& arrayName,
  vtkTetMarchFrameStatistics* statistics, const PixelTrace& trace)
{
  const auto inFloat = GetRayColor(trace.Float), inDouble = GetRayColor(trace.Double);
  const auto fact = [&trace](const char* name)
  { return DescribeTuple(trace.Double->GetFieldData()->GetArray(name), 0); };
  Json json;
  json["input"] = commandLine.Input;
  json["pixel"] = *commandLine.Pixel;
  json["size"] = commandLine.Size;
  json["array"] = arrayName;
  json["accuracy"] = { { "level", statistics->GetUsedAccuracyLevelAsString() },
    { "tolerance", statistics->GetUsedErrorTolerance() } };
  json["ray"] = { { "origin", fact("Origin") }, { "direction", fact("Direction") },
    { "range", fact("Range") }, { "thickness_per_length", fact("ThicknessPerLength") } };
  json["picture"] = { { "color", trace.Drawn } };
  json["float"] = DescribeRay(trace.Float, trace.Structured);
  json["double"] = DescribeRay(trace.Double, trace.Structured);
  json["ground_truth"] = DescribeRay(trace.GroundTruth, trace.Structured);
  json["differences"] = { { "picture_float", DescribeDifference(trace.Drawn, inFloat) },
    { "float_double", DescribeDifference(inFloat, inDouble) },
    { "double_ground_truth", DescribeDifference(inDouble, GetRayColor(trace.GroundTruth)) } };
  const vtkIdType parting = FindParting(trace.Float, trace.Double);
  json["parting_row"] = parting < 0 ? Json() : Json(parting);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace tetmarch
