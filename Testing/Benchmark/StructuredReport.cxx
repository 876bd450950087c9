// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StructuredReport.h"

#include "MarkdownText.h"
#include "Report.h"

namespace tetmarch::bench
{
namespace
{
using Json = nlohmann::ordered_json;

Json describeMapper(const MapperRecord& record)
{
  Json json;
  json["name"] = record.Mapper;
  json["class"] = record.Figures.is_null() ? Json(nullptr) : Json(record.Figures["class"]);
  json["failure"] = record.Failure.empty() ? Json(nullptr) : Json(record.Failure);
  json["frames"] = summarizeSeconds(record.Frames);
  const auto cpuSeconds = record.Figures.is_null()
                            ? std::vector<double>()
                            : record.Figures["cpu_seconds"].get<std::vector<double>>();
  json["cpu"] = summarizeSeconds(cpuSeconds); // of all threads, so that a busy machine matters less
  json["first_frame"] = summarizeSeconds(record.FirstFrames);
  if (!record.Errors.is_null())
  {
    json["errors"] = record.Errors;
  }
  return json;
}

Json describeVolume(const StructuredRecord& record)
{
  Json json;
  json["name"] = record.Shown.Dataset;
  json["functions"] = record.Shown.Functions;
  json["dimensions"] = record.Dimensions;
  json["scalar_type"] = record.ScalarType;
  json["reference_seconds"] = record.ReferenceSeconds;
  json["mappers"] = Json::array();
  for (const MapperRecord& mapper : record.Mappers)
  {
    json["mappers"].push_back(describeMapper(mapper));
  }
  return json;
}

std::string error(const Json& mapper, const char* key)
{
  return mapper.contains("errors") ? format("%.1e", mapper["errors"][key]) : std::string();
}

std::string median(const Json& summary)
{
  return summary.is_null() ? std::string() : seconds(summary["median_seconds"]);
}

std::string mapperRow(const Json& volume, const Json& mapper)
{
  const Json& frames = mapper["frames"];
  return row({ volume["name"], volume["functions"], mapper["name"], timesOf(frames),
    frames.is_null() ? "0" : std::to_string(frames["seconds"].size()), median(mapper["cpu"]),
    median(mapper["first_frame"]), error(mapper, "rms"), error(mapper, "p999"),
    error(mapper, "max"),
    mapper["failure"].is_null() ? std::string() : mapper["failure"].get<std::string>() });
}
} // namespace

nlohmann::ordered_json makeStructuredReport(
  const Options& options, const std::vector<StructuredRecord>& records)
{
  Json report = describeRun(options);
  report["stride"] = options.Stride;
  report["enough_seconds"] = options.EnoughSeconds;
  report["datasets"] = Json::array();
  for (const StructuredRecord& record : records)
  {
    report["environment"] = record.Environment;
    report["datasets"].push_back(describeVolume(record));
  }
  return report;
}

std::string makeStructuredMarkdown(const nlohmann::ordered_json& report)
{
  std::string text = heading(report) + "\n";
  text += row({ "volume", "functions", "mapper", "frame, s (range)", "frames", "CPU, s",
            "first frame, s", "RMS error", "99.9 %", "max", "remark" }) +
          "|---|---|---|---:|---:|---:|---:|---:|---:|---:|---|\n";
  for (const Json& volume : report["datasets"])
  {
    for (const Json& mapper : volume["mappers"])
    {
      text += mapperRow(volume, mapper);
    }
  }
  return text;
}
} // namespace tetmarch::bench
