// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileSeries.h"

#include "ErrorText.h"
#include "Failure.h"
#include "FileReader.h"

#include "vtkNew.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

namespace
{
using namespace tetmarch;

std::string FindFile(const std::string& path, const std::string& listed)
{
  if (listed.empty())
  {
    RefuseFile(path, "it lists a file without a name");
  }
  const std::string found = (std::filesystem::path(path).parent_path() / listed).string();
  if (IsSeriesFile(found))
  {
    RefuseFile(path, "it lists '" + listed + "', which is a list of files itself");
  }
  return found;
}

/// Collects files by their times.
class Collector
{
public:
  void Add(double time, const SeriesPart& part) { this->Steps[time].push_back(part); }

  FileSeries Finish(const std::string& path, bool hasTimes)
  {
    if (this->Steps.empty())
    {
      RefuseFile(path, "it lists no files");
    }
    FileSeries series;
    series.HasTimes = hasTimes;
    for (auto& [time, parts] : this->Steps)
    {
      std::stable_sort(parts.begin(), parts.end(),
        [](const SeriesPart& a, const SeriesPart& b) { return a.Number < b.Number; });
      series.Steps.push_back({ time, std::move(parts) });
    }
    return series;
  }

private:
  std::map<double, std::vector<SeriesPart>> Steps;
};

double ParseTime(const std::string& path, const char* text)
{
  char* end = nullptr;
  const double time = std::strtod(text, &end);
  if (end == text || *end != '\0' || !std::isfinite(time))
  {
    RefuseFile(path, "'" + std::string(text) + "' is no time");
  }
  return time;
}

SeriesPart ReadPart(const std::string& path, vtkXMLDataElement* element)
{
  SeriesPart part;
  const char* file = element->GetAttribute("file");
  part.Path = FindFile(path, file ? file : "");
  element->GetScalarAttribute("part", part.Number);
  for (const char* named : { "name", "group" })
  {
    const char* name = element->GetAttribute(named);
    part.Name = part.Name.empty() && name ? name : part.Name;
  }
  return part;
}

FileSeries ReadPvd(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  vtkNew<vtkXMLDataParser> parser;
  parser->SetStream(&file);
  const ErrorText error(parser); // which isn't printed beside ours
  const bool parsed = parser->Parse() != 0;
  vtkXMLDataElement* root = parsed ? parser->GetRootElement() : nullptr;
  vtkXMLDataElement* list = root ? root->FindNestedElementWithName("Collection") : nullptr;
  if (!list)
  {
    RefuseFile(path, parsed ? "it has no element <Collection> that lists files"
                            : "it is no XML (" + error.Get() + ")");
  }
  Collector collector;
  bool hasTimes = false;
  for (int i = 0; i < list->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* element = list->GetNestedElement(i);
    if (std::string(element->GetName()) != "DataSet")
    {
      continue;
    }
    const char* time = element->GetAttribute("timestep");
    hasTimes = hasTimes || time;
    collector.Add(time ? ParseTime(path, time) : 0.0, ReadPart(path, element));
  }
  return collector.Finish(path, hasTimes);
}

FileSeries ReadJson(const std::string& path)
{
  std::ifstream file(path);
  const nlohmann::json list = nlohmann::json::parse(file, nullptr, false);
  if (list.is_discarded())
  {
    RefuseFile(path, "it is no JSON");
  }
  const auto files = list.is_object() ? list.find("files") : list.end();
  if (!list.is_object() || files == list.end() || !files->is_array())
  {
    RefuseFile(path, "it has no list \"files\"");
  }
  Collector collector;
  for (const nlohmann::json& entry : *files)
  {
    const bool sound = entry.is_object() && entry.contains("name") && entry["name"].is_string() &&
                       entry.contains("time") && entry["time"].is_number();
    if (!sound)
    {
      RefuseFile(
        path, "each entry of \"files\" needs a \"name\", a text, and a \"time\", a number");
    }
    const std::string name = entry["name"].get<std::string>();
    collector.Add(entry["time"].get<double>(), { FindFile(path, name), {}, 0 });
  }
  return collector.Finish(path, true);
}
} // namespace

namespace tetmarch
{

bool IsSeriesFile(const std::string& path)
{
  const std::string ending = GetEnding(path);
  return ending == ".pvd" || ending == ".series";
}

FileSeries ReadSeries(const std::string& path)
{
  CheckFile(path);
  return GetEnding(path) == ".pvd" ? ReadPvd(path) : ReadJson(path);
}

std::vector<double> GetTimes(const FileSeries& series)
{
  std::vector<double> times;
  for (const SeriesStep& step : series.Steps)
  {
    times.push_back(step.Time);
  }
  return series.HasTimes ? times : std::vector<double>();
}

} // namespace tetmarch
