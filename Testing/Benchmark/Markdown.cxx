// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MarkdownText.h"
#include "Report.h"

namespace tetmarch::bench
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr double Million = 1e6;
const std::string Nothing = "";

/// A number in some unit, or nothing if there is none.
std::string cell(const Json& json, const char* key, const char* pattern, double unit = 1.0)
{
  return json.contains(key) ? format(pattern, json[key].get<double>() / unit) : Nothing;
}

/// Megabytes beyond those of the dataset.
std::string addedMemory(const Json& mapper)
{
  return mapper.contains("peak_resident_bytes")
           ? format("%.0f", (mapper["peak_resident_bytes"].get<double>() -
                              mapper["dataset_resident_bytes"].get<double>()) /
                              Million)
           : Nothing;
}

std::string remark(const Json& mapper)
{
  return mapper["failure"].is_null() ? Nothing : mapper["failure"].get<std::string>();
}

std::string firstFrame(const Json& mapper)
{
  const Json& first = mapper["first_frame"];
  return first.is_null() ? Nothing : seconds(first["median_seconds"]);
}

std::string speedRow(const Json& dataset, const Json& mapper)
{
  return row({ dataset["name"],
    dataset["tetrahedra"].is_null() ? Nothing : dataset["tetrahedra"].dump(), mapper["name"],
    timesOf(mapper["frames"]), cell(mapper, "frame_ratio_to_tetmarch", "%.2f"), firstFrame(mapper),
    mapper.contains("preprocessing_seconds") ? seconds(mapper["preprocessing_seconds"]) : Nothing,
    cell(mapper, "preprocessing_tetrahedra_per_second", "%.2f", Million), addedMemory(mapper),
    cell(mapper, "gpu_bytes", "%.1f", Million),
    cell(mapper, "uploaded_bytes_per_tetrahedron", "%.1f"), remark(mapper) });
}

std::string accuracyRow(const Json& dataset, const Json& mapper)
{
  const Json errors = mapper.value("errors", Json::object());
  return row({ dataset["name"], dataset["functions"], mapper["name"], timesOf(mapper["frames"]),
    firstFrame(mapper), cell(errors, "rms", "%.1e"), cell(errors, "p999", "%.1e"),
    cell(errors, "max", "%.1e"), addedMemory(mapper), cell(errors, "lookups_per_cell", "%.2f"),
    remark(mapper) });
}

std::string againstLine(const Json& dataset)
{
  if (!dataset.contains("against"))
  {
    return Nothing;
  }
  const Json& against = dataset["against"];
  return "\n" + dataset["name"].get<std::string>() + ": this build takes " +
         format("%.3f", against["pairs"]) + " times as long as the other (median of " +
         against["count"].dump() + " pairs of frames; ratio of medians " +
         format("%.3f", against["medians"]) + ").\n";
}
} // namespace

std::string makeMarkdown(const Json& report)
{
  const bool speed = report["kind"] == "speed";
  std::string text = heading(report) + "\n";
  text += speed ? row({ "dataset", "tets", "mapper", "frame, s (range)", "times ours",
                    "first frame, s", "preprocessing, s", "M tets/s", "memory added, MB", "GPU, MB",
                    "uploaded bytes/tet", "remark" }) +
                    "|---|---:|---|---:|---:|---:|---:|---:|---:|---:|---:|---|\n"
                : row({ "dataset", "functions", "mapper", "frame, s (range)", "first frame, s",
                    "RMS error", "99.9 %", "max", "memory added, MB", "lookups/cell", "remark" }) +
                    "|---|---|---|---:|---:|---:|---:|---:|---:|---:|---|\n";
  for (const Json& dataset : report["datasets"])
  {
    for (const Json& mapper : dataset["mappers"])
    {
      text += speed ? speedRow(dataset, mapper) : accuracyRow(dataset, mapper);
    }
  }
  for (const Json& dataset : report["datasets"])
  {
    text += againstLine(dataset);
  }
  return text;
}
} // namespace tetmarch::bench
