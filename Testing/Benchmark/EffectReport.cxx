// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EffectReport.h"

#include "MarkdownText.h"
#include "Report.h"
#include "Statistics.h"

#include <algorithm>

namespace tetmarch::bench
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr double Million = 1e6;

std::vector<double> valuesOf(const EffectRecord& record, double EffectSample::*member)
{
  std::vector<double> values;
  for (const auto& sample : record.Samples)
  {
    values.push_back(sample.second.*member);
  }
  return values;
}

/// Of a figure to the base frame of the same turn.
std::vector<double> baseRatios(const EffectRecord& record, double EffectSample::*member)
{
  std::vector<double> ratios;
  for (const auto& sample : record.Samples)
  {
    ratios.push_back(sample.second.*member / sample.second.Base);
  }
  return ratios;
}

/// Of the frames of two effects in the same turn.
std::vector<double> ratios(const EffectRecord& record, const EffectRecord& other)
{
  std::vector<double> ratios;
  for (const auto& sample : record.Samples)
  {
    const auto found = other.Samples.find(sample.first);
    if (found != other.Samples.end())
    {
      ratios.push_back(sample.second.Frame / found->second.Frame);
    }
  }
  return ratios;
}

Json summarizeRatios(const std::vector<double>& ratios)
{
  if (ratios.empty())
  {
    return nullptr;
  }
  const auto range = std::minmax_element(ratios.begin(), ratios.end());
  return { { "median", GetMedian(ratios) }, { "min", *range.first }, { "max", *range.second } };
}

/// Nothing where the stage didn't run.
void addStage(
  Json& json, const std::string& name, const EffectRecord& record, double EffectSample::*member)
{
  const std::vector<double> seconds = valuesOf(record, member);
  if (GetMedian(seconds) > 0.0)
  {
    json[name + "_seconds"] = GetMedian(seconds);
    json[name + "_base_frames"] = GetMedian(baseRatios(record, member));
  }
}

Json describeEffect(const EffectRecord& record, const EffectsRecord& all)
{
  Json json;
  json["name"] = record.Shown.Name;
  json["what"] = record.Shown.What;
  json["on"] = record.Shown.On;
  json["failure"] = record.Failure.empty() ? Json(nullptr) : Json(record.Failure);
  json["turns"] = record.Samples.size();
  json["frames"] = summarizeSeconds(valuesOf(record, &EffectSample::Frame));
  json["base_frames"] = summarizeSeconds(valuesOf(record, &EffectSample::Base));
  json["first_frame"] = summarizeSeconds(valuesOf(record, &EffectSample::First));
  json["base_ratio"] = summarizeRatios(baseRatios(record, &EffectSample::Frame));
  json["on_ratio"] = record.Shown.On == NoEffect ? json["base_ratio"] : Json(nullptr);
  for (const EffectRecord& other : all.Effects)
  {
    if (other.Shown.Name == record.Shown.On)
    {
      json["on_ratio"] = summarizeRatios(ratios(record, other));
    }
  }
  addStage(json, "gradients", record, &EffectSample::Gradients);
  addStage(json, "light", record, &EffectSample::Light);
  if (!record.Samples.empty())
  {
    json["covered_share"] = record.Covered;
    json["gpu_bytes"] = record.Bytes;
    json["gpu_bytes_more"] = record.Bytes - record.BaseBytes;
  }
  return json;
}

Json describeDataset(const EffectsRecord& record)
{
  const bool known = !record.Ready.is_null();
  std::vector<double> base;
  Json json;
  json["name"] = record.Shown.Dataset;
  json["functions"] = record.Shown.Functions;
  json["tetrahedra"] = known ? Json(record.Ready["tetrahedra"]) : Json(nullptr);
  json["points"] = known ? Json(record.Ready["points"]) : Json(nullptr);
  json["base"] = nullptr;
  json["effects"] = Json::array();
  for (const EffectRecord& effect : record.Effects)
  {
    const std::vector<double> frames = valuesOf(effect, &EffectSample::Base);
    base.insert(base.end(), frames.begin(), frames.end());
    json["effects"].push_back(describeEffect(effect, record));
    if (!effect.Samples.empty())
    {
      json["base_gpu_bytes"] = effect.BaseBytes;
    }
  }
  json["base"] = summarizeSeconds(base);
  return json;
}

std::string ratio(const Json& json, const char* key)
{
  return json[key].is_null() ? std::string() : format("%.2f", json[key]["median"]);
}

/// "0.012 s (0.30)": seconds, and how many base frames these are.
std::string stage(const Json& effect, const std::string& name)
{
  return effect.contains(name + "_seconds") ? seconds(effect[name + "_seconds"]) + " (" +
                                                format("%.2f", effect[name + "_base_frames"]) + ")"
                                            : std::string();
}

std::string effectRow(const Json& dataset, const Json& effect)
{
  return row(
    { dataset["name"], effect["name"], timesOf(effect["frames"]), ratio(effect, "base_ratio"),
      effect["on"], ratio(effect, "on_ratio"), stage(effect, "gradients"), stage(effect, "light"),
      effect.contains("gpu_bytes_more")
        ? format("%.1f", effect["gpu_bytes_more"].get<double>() / Million)
        : std::string(),
      effect["failure"].is_null() ? std::string() : effect["failure"].get<std::string>() });
}
} // namespace

nlohmann::ordered_json makeEffectReport(
  const Options& options, const std::vector<EffectsRecord>& records)
{
  Json report = describeRun(options);
  report["datasets"] = Json::array();
  for (const EffectsRecord& record : records)
  {
    if (!record.Ready.is_null())
    {
      report["environment"] = record.Ready["environment"];
    }
    report["datasets"].push_back(describeDataset(record));
  }
  return report;
}

std::string makeEffectMarkdown(const nlohmann::ordered_json& report)
{
  std::string text = heading(report) + "\n";
  text += row({ "dataset", "effect", "frame, s (range)", "times base", "on", "times that",
    "gradients, s (base frames)", "light, s (base frames)", "more on the GPU, MB", "remark" });
  text += "|---|---|---:|---:|---|---:|---:|---:|---:|---|\n";
  for (const Json& dataset : report["datasets"])
  {
    text +=
      row({ dataset["name"], NoEffect, timesOf(dataset["base"]), "", "", "", "", "", "", "" });
    for (const Json& effect : dataset["effects"])
    {
      text += effectRow(dataset, effect);
    }
  }
  return text;
}
} // namespace tetmarch::bench
