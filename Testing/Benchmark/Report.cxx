// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include "Machine.h"
#include "Statistics.h"

#include <algorithm>

namespace tetmarch::bench
{
namespace
{
using Json = nlohmann::ordered_json;

const std::string Ours = "tetmarch";

/// The mapper's own clocks, where it has them.
void addPreprocessing(Json& json, const nlohmann::json& figures, double tetrahedra)
{
  if (!figures.contains("stages"))
  {
    return;
  }
  double seconds = 0.0;
  for (const auto& stage : figures["stages"])
  {
    seconds += stage.get<double>();
  }
  json["stages_seconds"] = figures["stages"];
  json["preprocessing_seconds"] = seconds;
  json["preprocessing_tetrahedra_per_second"] = tetrahedra / seconds;
  json["mesh_tetrahedra_per_second"] = tetrahedra / figures["stages"]["mesh"].get<double>();
}

Json describeMapper(const MapperRecord& record, double tetrahedra)
{
  Json json;
  json["name"] = record.Mapper;
  json["failure"] = record.Failure.empty() ? Json(nullptr) : Json(record.Failure);
  json["frames"] = summarizeSeconds(record.Frames);
  json["first_frame"] = summarizeSeconds(record.FirstFrames);
  json["covered_share"] = GetMedian(record.Covered);
  if (!record.Errors.is_null())
  {
    json["errors"] = record.Errors;
  }
  const nlohmann::json& figures = record.Figures;
  if (figures.is_null())
  {
    return json;
  }
  json["class"] = figures["class"];
  addPreprocessing(json, figures, tetrahedra);
  json["peak_resident_bytes"] = figures["peak_resident_bytes"];
  json["dataset_resident_bytes"] = figures["dataset_resident_bytes"];
  if (figures.contains("gpu_bytes"))
  {
    json["gpu_bytes"] = figures["gpu_bytes"];
    json["uploaded_bytes"] = figures["uploaded_bytes"];
    json["uploaded_bytes_per_tetrahedron"] = figures["uploaded_bytes"].get<double>() / tetrahedra;
  }
  return json;
}

/// How many times the median frame of ours every other takes.
void addRatios(Json& mappers)
{
  double ours = 0.0;
  for (const Json& mapper : mappers)
  {
    if (mapper["name"] == Ours && !mapper["frames"].is_null())
    {
      ours = mapper["frames"]["median_seconds"];
    }
  }
  for (Json& mapper : mappers)
  {
    if (ours > 0.0 && mapper["name"] != Ours && !mapper["frames"].is_null())
    {
      mapper["frame_ratio_to_tetmarch"] = mapper["frames"]["median_seconds"].get<double>() / ours;
    }
  }
}

/// How long ours takes beside the other build, as long as both have drawn: `pairs` is the median
/// over pairs of frames of the same view, one right after the other.
void addAgainst(Json& json, const std::vector<MapperRecord>& mappers)
{
  const auto named = [&](const std::string& name)
  {
    return std::find_if(mappers.begin(), mappers.end(),
      [&](const MapperRecord& mapper) { return mapper.Mapper == name; });
  };
  const auto ours = named(Ours);
  const auto other = named(AgainstMapper);
  if (ours == mappers.end() || other == mappers.end() || ours->Frames.empty() ||
      ours->Frames.size() != other->Frames.size())
  {
    return;
  }
  std::vector<double> ratios;
  for (std::size_t i = 0; i < ours->Frames.size(); ++i)
  {
    ratios.push_back(ours->Frames[i] / other->Frames[i]);
  }
  json["against"] = { { "count", ratios.size() }, { "pairs", GetMedian(ratios) },
    { "medians", GetMedian(ours->Frames) / GetMedian(other->Frames) } };
}

Json describeDataset(const DatasetRecord& record)
{
  const bool known = !record.Ready.is_null();
  const auto tetrahedra = known ? record.Ready["tetrahedra"].get<std::int64_t>() : 0;
  Json json;
  json["name"] = record.Shown.Dataset;
  json["functions"] = record.Shown.Functions;
  json["tetrahedra"] = known ? Json(tetrahedra) : Json(nullptr);
  json["points"] = known ? Json(record.Ready["points"]) : Json(nullptr);
  if (record.ReferenceSeconds > 0.0)
  {
    json["reference_seconds"] = record.ReferenceSeconds;
  }
  if (!record.ReferenceFailure.empty())
  {
    json["reference_failure"] = record.ReferenceFailure;
  }
  json["mappers"] = Json::array();
  for (const MapperRecord& mapper : record.Mappers)
  {
    json["mappers"].push_back(describeMapper(mapper, static_cast<double>(tetrahedra)));
  }
  addRatios(json["mappers"]);
  addAgainst(json, record.Mappers);
  return json;
}
} // namespace

nlohmann::ordered_json summarizeSeconds(const std::vector<double>& seconds)
{
  if (seconds.empty())
  {
    return nullptr;
  }
  const auto range = std::minmax_element(seconds.begin(), seconds.end());
  return { { "median_seconds", GetMedian(seconds) }, { "min_seconds", *range.first },
    { "max_seconds", *range.second }, { "seconds", seconds } };
}

nlohmann::ordered_json describeRun(const Options& options)
{
  Json report;
  report["kind"] = options.Kind;
  report["date"] = currentDate();
  report["tetmarch_version"] = TETMARCH_VERSION;
  report["cpu"] = cpuModel();
  report["cpu_threads"] = hardwareThreads();
  report["memory_bytes"] = memoryBytes();
  report["environment"] = nullptr;
  report["size"] = options.Size;
  report["rounds"] = options.Rounds;
  report["frames"] = options.Frames;
  report["limit_seconds"] = options.LimitSeconds;
  return report;
}

nlohmann::ordered_json makeReport(const Options& options, const std::vector<DatasetRecord>& records)
{
  Json report = describeRun(options);
  report["datasets"] = Json::array();
  for (const DatasetRecord& record : records)
  {
    if (!record.Ready.is_null())
    {
      report["environment"] = record.Ready["environment"];
    }
    report["datasets"].push_back(describeDataset(record));
  }
  return report;
}
} // namespace tetmarch::bench
