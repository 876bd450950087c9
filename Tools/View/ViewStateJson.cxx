// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewStateJson.h"

#include "Failure.h"
#include "OutputFile.h"
#include "StateWords.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

namespace
{
using nlohmann::json;
using namespace tetmarch;

constexpr const char* Kind = "tetmarch-view session";

/// Either of the two directions, so that each field is named once.
struct Writer
{
  json& Object;
  template <typename Value>
  void operator()(const char* name, const Value& value)
  {
    this->Object[name] = value;
  }
  template <std::size_t Count>
  void Choice(const char* name, const int& number, const std::array<const char*, Count>& words)
  {
    this->Object[name] = words.at(static_cast<std::size_t>(number));
  }
};

struct Reader
{
  const json& Object;
  template <typename Value>
  void operator()(const char* name, Value& value)
  {
    if (!this->Object.contains(name))
    {
      return;
    }
    try
    {
      value = this->Object.at(name).get<Value>();
    }
    catch (const json::exception&)
    {
      throw Failure(std::string(name) + " is " + this->Object.at(name).dump() +
                    ", which is of another kind than a session has there");
    }
  }
  template <std::size_t Count>
  void Choice(const char* name, int& number, const std::array<const char*, Count>& words)
  {
    std::string word = words.at(static_cast<std::size_t>(number));
    (*this)(name, word);
    number = FindWord(words, word);
    if (number < 0)
    {
      throw Failure(std::string(name) + " is \"" + word + "\", which is none of the known words");
    }
  }
};

/// The part of a session that a setting is in, by its name.
template <typename FindPart>
struct PartOfSetting
{
  FindPart Find;
  template <typename Value>
  void operator()(const SettingNames& names, Value& value)
  {
    this->Find(names.Part)(names.Key, value);
  }
  template <typename Number, typename Words>
  void Choice(const SettingNames& names, Number& number, const Words& words)
  {
    this->Find(names.Part).Choice(names.Key, number, words);
  }
};

template <typename Visitor, typename State>
void VisitData(Visitor&& visit, State& s)
{
  visit("file", s.File);
  visit("surface", s.Surface);
  visit("time step", s.TimeStep);
  visit("array", s.Array);
  visit("association", s.Association);
  visit("component", s.Component);
  visit("nearest", s.Nearest);
}

template <typename Visitor, typename State>
void VisitFunctions(Visitor&& visit, State& s)
{
  visit("color", s.Color);
  visit.Choice("color space", s.ColorSpace, ColorSpaceWords);
  visit("HSV wrap", s.HSVWrap);
  visit("log scale", s.LogScale);
  visit("NaN color", s.NanColor);
  visit("opacity", s.Opacity);
  visit("gradient opacity", s.GradientOpacity);
  visit("unit distance", s.UnitDistance);
  visit("structured opacity law", s.StructuredOpacityLaw);
}

template <typename Visitor, typename State>
void VisitCamera(Visitor&& visit, State& s)
{
  visit("position", s.Position);
  visit("focal point", s.FocalPoint);
  visit("view up", s.ViewUp);
  visit("view angle", s.ViewAngle);
  visit("parallel", s.Parallel);
  visit("parallel scale", s.ParallelScale);
}

template <typename Visitor, typename State>
void VisitEffects(Visitor&& visit, State& s)
{
  visit("shading", s.Shading);
  visit("gradient opacity", s.GradientOpacity);
  visit("scattering", s.Scattering);
  visit("headlight", s.Headlight);
  visit("light from", s.LightFrom);
  visit("intensity", s.Intensity);
  visit("ambient", s.Ambient);
  visit("diffuse", s.Diffuse);
  visit("specular", s.Specular);
  visit("specular power", s.SpecularPower);
  visit("scattering strength", s.ScatteringStrength);
  visit("gradient strength", s.GradientStrength);
}

template <typename Visitor, typename State>
void VisitCuts(Visitor&& visit, State& s)
{
  visit("clip", s.Clip);
  visit("origin", s.Origin);
  visit("normal", s.Normal);
  visit("crop", s.Crop);
  visit("box", s.Box);
}

template <typename Visitor, typename State>
void VisitPicture(Visitor&& visit, State& s)
{
  visit.Choice("blend", s.BlendMode, BlendWords);
  visit("isovalues", s.IsoValues);
  visit("background", s.Background);
  visit("size", s.Size);
}

ViewState FromJson(const json& document)
{
  if (!document.is_object() || document.value("kind", json()) != json(Kind))
  {
    throw Failure(std::string("it lacks \"kind\": \"") + Kind + "\"");
  }
  ViewState state;
  const json none = json::object();
  const auto part = [&](const char* name) -> const json&
  {
    const json& object = document.contains(name) ? document.at(name) : none;
    if (!object.is_object())
    {
      throw Failure(std::string(name) + " must be an object");
    }
    return object;
  };
  VisitData(Reader{ part("data") }, state.Data);
  VisitFunctions(Reader{ part("functions") }, state.Functions);
  VisitCamera(Reader{ part("camera") }, state.Camera);
  const auto find = [&](const char* name) { return Reader{ part(name) }; };
  VisitSettings(PartOfSetting<decltype(find)>{ find }, state.Settings);
  VisitEffects(Reader{ part("effects") }, state.Effects);
  VisitCuts(Reader{ part("cuts") }, state.Cuts);
  VisitPicture(Reader{ part("picture") }, state);
  return state;
}
} // namespace

namespace tetmarch
{

std::string WriteState(const ViewState& state)
{
  json document;
  document["kind"] = Kind;
  VisitData(Writer{ document["data"] }, state.Data);
  VisitFunctions(Writer{ document["functions"] }, state.Functions);
  VisitCamera(Writer{ document["camera"] }, state.Camera);
  const auto find = [&](const char* name) { return Writer{ document[name] }; };
  VisitSettings(PartOfSetting<decltype(find)>{ find }, state.Settings);
  VisitEffects(Writer{ document["effects"] }, state.Effects);
  VisitCuts(Writer{ document["cuts"] }, state.Cuts);
  VisitPicture(Writer{ document["picture"] }, state);
  return document.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

ViewState ReadState(const std::string& text)
{
  const json document = json::parse(text, nullptr, false);
  if (document.is_discarded())
  {
    throw Failure("it is not JSON");
  }
  return FromJson(document);
}

void SaveSession(const ViewState& state, const std::string& path)
{
  WriteFile(path, WriteState(state));
}

ViewState LoadSession(const std::string& path)
{
  std::ifstream file(path);
  std::stringstream text;
  if (!file || !(text << file.rdbuf()))
  {
    throw Failure("cannot read the session '" + path + "'");
  }
  try
  {
    return ReadState(text.str());
  }
  catch (const Failure& failure)
  {
    throw Failure("'" + path + "' is no session of tetmarch-view: " + failure.what());
  }
}

} // namespace tetmarch
